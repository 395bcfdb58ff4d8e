// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "jobs/job_store.h"

namespace slipstitch::rest {

/// Counters since the start. Every method may be called from any thread.
class Metrics {
 public:
  void count_response(const std::string& operation, unsigned status);
  void change_connections(int by);
  void change_streams(int by);
  void set_exports(std::size_t waiting, std::size_t bytes);

  /// Prometheus text format, with the jobs of the store.
  std::string text(const jobs::JobStore& store) const;

 private:
  mutable std::mutex mutex_;  // guards all below
  std::map<std::pair<std::string, unsigned>, long> responses_;
  int connections_ = 0, streams_ = 0;  // now
  std::size_t exports_waiting_ = 0, export_bytes_ = 0;
};

}  // namespace slipstitch::rest
