// SPDX-License-Identifier: MIT
#include "rest/metrics.h"

#include "platform/version.h"

namespace slipstitch::rest {
namespace {

void begin_family(std::string& text, const std::string& name, const std::string& type, const std::string& help) {
  text += "# HELP " + name + " " + help + "\n# TYPE " + name + " " + type + "\n";
}

void add_jobs(const jobs::JobStore& store, std::string& text) {
  begin_family(text, "slipstitch_jobs", "gauge", "Jobs by state.");
  for (const auto& [state, count] : store.counts()) {
    text += "slipstitch_jobs{state=\"" + std::string(jobs::state_name(state)) + "\"} " + std::to_string(count) + "\n";
  }
}

}  // namespace

void Metrics::count_response(const std::string& operation, unsigned status) {
  const std::lock_guard lock(mutex_);
  ++responses_[{operation, status}];
}

void Metrics::change_connections(int by) {
  const std::lock_guard lock(mutex_);
  connections_ += by;
}

void Metrics::change_streams(int by) {
  const std::lock_guard lock(mutex_);
  streams_ += by;
}

void Metrics::set_exports(std::size_t waiting, std::size_t bytes) {
  const std::lock_guard lock(mutex_);
  exports_waiting_ = waiting;
  export_bytes_ = bytes;
}

std::string Metrics::text(const jobs::JobStore& store) const {
  std::string text;
  begin_family(text, "slipstitch_info", "gauge", "The version that runs.");
  text += "slipstitch_info{version=\"" + version_string() + "\"} 1\n";
  add_jobs(store, text);
  const std::lock_guard lock(mutex_);
  begin_family(text, "slipstitch_http_connections", "gauge", "Open HTTP connections.");
  text += "slipstitch_http_connections " + std::to_string(connections_) + "\n";
  begin_family(text, "slipstitch_http_streams", "gauge", "Responses being sent piece by piece.");
  text += "slipstitch_http_streams " + std::to_string(streams_) + "\n";
  begin_family(text, "slipstitch_http_exports_waiting", "gauge", "Requests that wait for their turn to get a frame.");
  text += "slipstitch_http_exports_waiting " + std::to_string(exports_waiting_) + "\n";
  begin_family(text, "slipstitch_http_export_bytes", "gauge", "Frames as files, made and not yet sent.");
  text += "slipstitch_http_export_bytes " + std::to_string(export_bytes_) + "\n";
  begin_family(text, "slipstitch_http_responses_total", "counter", "HTTP responses by operation and status.");
  for (const auto& [key, count] : responses_) {
    text += "slipstitch_http_responses_total{operation=\"" + key.first + "\",status=\"" + std::to_string(key.second) +
            "\"} " + std::to_string(count) + "\n";
  }
  return text;
}

}  // namespace slipstitch::rest
