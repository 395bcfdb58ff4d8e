// SPDX-License-Identifier: MIT
#include "jobs/server_summary.h"

#include <string.h>
#include <sys/stat.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "jobs/local_executor.h"

namespace slipstitch::jobs {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kTailLines = 20;
constexpr std::streamoff kTailBytes = 4096;

std::string text_of(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::string signal_name(int signal) {
  const char* name = ::sigabbrev_np(signal);
  return name == nullptr ? "signal " + std::to_string(signal) : "SIG" + std::string(name);
}

// Logs may hold anything; JSON and protobuf want UTF-8.
std::string printable(std::string line) {
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7e) c = '?';
  }
  return line;
}

}  // namespace

std::optional<ServerSummary> parse_summary(std::string_view text) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  const std::optional<RunStatus> status = status_from_word(text_of(json, "status"));
  if (!status) return std::nullopt;
  ServerSummary summary{*status, {text_of(json, "reason"), text_of(json, "message"), {}}};
  if (summary.failure.reason.empty()) summary.failure.reason = "SIMULATION_FAILED";
  if (const auto tail = json.find("log_tail"); tail != json.end() && tail->is_array()) {
    for (const Json& line : *tail) {
      if (line.is_string()) summary.failure.log_tail.push_back(line.get<std::string>());
    }
  }
  return summary;
}

std::string server_summary(RunStatus status, const std::string& scene_name, const Failure& failure) {
  Json json = empty_summary();
  json["status"] = status_word(status);
  json["message"] = failure.message;
  json["scene"] = scene_name;
  if (status == RunStatus::failed) json["reason"] = failure.reason;
  if (!failure.log_tail.empty()) json["log_tail"] = failure.log_tail;
  return json.dump(2) + "\n";
}

Failure failure_of(const WorkerEnd& end, const RunDir& dir) {
  Failure failure{"WORKER_CRASHED", "", log_tail(worker_log(dir))};
  if (end.signal) {
    failure.message = "the worker was killed by " + signal_name(*end.signal);
    if (*end.signal == SIGKILL) failure.message += " (perhaps the machine ran out of memory)";
  } else if (end.exit_code) {
    failure.message = "the worker ended with exit code " + std::to_string(*end.exit_code) + " and left no summary";
  } else {
    failure.reason = "WORKER_LOST";
    failure.message =
        "the worker is gone and left no summary; its end status is unknown: it was started by an earlier server";
  }
  return failure;
}

std::vector<std::string> log_tail(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return {};
  stream.seekg(0, std::ios::end);
  const std::streamoff size = stream.tellg();
  const bool cut = size > kTailBytes;
  stream.seekg(cut ? size - kTailBytes : 0);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(printable(std::move(line)));
  if (cut && lines.size() > 1) lines.erase(lines.begin());
  if (lines.size() > kTailLines) lines.erase(lines.begin(), lines.end() - kTailLines);
  return lines;
}

std::string file_time(const std::filesystem::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return {};
  std::tm utc{};
  ::gmtime_r(&status.st_mtim.tv_sec, &utc);
  std::array<char, 32> date{};
  std::strftime(date.data(), date.size(), "%Y-%m-%dT%H:%M:%S", &utc);
  std::array<char, 16> fraction{};
  std::snprintf(fraction.data(), fraction.size(), ".%06dZ", static_cast<int>(status.st_mtim.tv_nsec / 1000));
  return std::string(date.data()) + fraction.data();
}

}  // namespace slipstitch::jobs
