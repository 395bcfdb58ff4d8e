// SPDX-License-Identifier: MIT
#include "run_dir/run_dir.h"

#include <algorithm>
#include <system_error>

#include "run_dir/atomic_file.h"
#include "run_dir/control_log.h"

namespace slipstitch {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxJsonBytes = std::size_t{64} << 20;
constexpr std::size_t kMaxSceneBytes = std::size_t{1} << 30;

template <class Json>
IoError write_json(const fs::path& path, const Json& json) {
  // Bytes that are no UTF-8 (a file name in a message) are replaced rather than refused.
  return write_file_atomic(path, json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
}

template <class T>
Result<T> read_json(const fs::path& path, Result<T> (*parse)(std::string_view)) {
  const Result<std::string> text = read_file(path, kMaxJsonBytes);
  if (!text) return Result<T>::failed(text.error);
  Result<T> parsed = parse(*text);
  if (!parsed) parsed.error = path.string() + ": " + parsed.error;
  return parsed;
}

// job.json goes first: from then on the folder is no run.
IoError remove_earlier_run(const RunDir& dir) {
  for (const fs::path& file : {dir.job(), dir.scene(), dir.frames(), dir.progress(), dir.summary(), dir.control(),
                               dir.worker(), dir.report()}) {
    std::error_code error;
    fs::remove_all(file, error);
    if (error) return "cannot remove " + file.string() + ": " + error.message();
  }
  return {};
}

}  // namespace

bool occupied(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) return false;
  return !fs::is_directory(status) || !fs::is_empty(path, error) || error;
}

Result<RunDir> create_run_dir(const fs::path& path, const JobInfo& job, std::string_view scene_json, bool force) {
  const RunDir dir{fs::absolute(path).lexically_normal()};
  if (occupied(dir.path)) {
    if (!force) return Result<RunDir>::failed(path.string() + " exists and is not an empty folder");
    if (IoError error = remove_earlier_run(dir); !error.empty()) return Result<RunDir>::failed(error);
  }
  std::error_code error;
  fs::create_directories(dir.report(), error);
  if (error) return Result<RunDir>::failed("cannot create " + path.string() + ": " + error.message());
  for (const IoError& failure : {write_file_atomic(dir.scene(), scene_json), write_json(dir.job(), to_json(job)),
                                 sync_folder(dir.path.parent_path())}) {
    if (!failure.empty()) return Result<RunDir>::failed(failure);
  }
  return Result<RunDir>::of(dir);
}

Result<RunDir> open_run_dir(const fs::path& path) {
  const RunDir dir{fs::absolute(path).lexically_normal()};
  std::error_code error;
  if (!fs::is_regular_file(dir.job(), error)) {
    return Result<RunDir>::failed(path.string() + " is not a run directory: it has no job.json");
  }
  return Result<RunDir>::of(dir);
}

IoError write_progress(const RunDir& dir, const ProgressInfo& progress) {
  return write_json(dir.progress(), to_json(progress));
}
IoError write_summary(const RunDir& dir, const RunSummary& summary) {
  return write_json(dir.summary(), to_json(summary));
}
IoError write_summary(const RunDir& dir, const StudySummary& summary) {
  return write_json(dir.summary(), to_json(summary));
}
IoError write_worker(const RunDir& dir, const WorkerInfo& worker) { return write_json(dir.worker(), to_json(worker)); }

Result<JobInfo> read_job(const RunDir& dir) { return read_json(dir.job(), job_from_json); }
Result<std::string> read_scene(const RunDir& dir) { return read_file(dir.scene(), kMaxSceneBytes); }
Result<ProgressInfo> read_progress(const RunDir& dir) { return read_json(dir.progress(), progress_from_json); }
Result<RunSummary> read_summary(const RunDir& dir) { return read_json(dir.summary(), summary_from_json); }
Result<WorkerInfo> read_worker(const RunDir& dir) { return read_json(dir.worker(), worker_from_json); }

bool has_summary(const RunDir& dir) {
  std::error_code error;
  return fs::is_regular_file(dir.summary(), error);
}

IoError request_cancel(const RunDir& dir) { return append_command(dir.control(), kCancelCommand); }

std::vector<std::string> list_artefacts(const RunDir& dir) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator entry(dir.report(), error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    std::error_code status_error;
    if (valid_artefact_name(name) && fs::is_regular_file(entry->symlink_status(status_error))) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

bool valid_artefact_name(std::string_view name) {
  const auto allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '_' ||
           c == '-';
  };
  return !name.empty() && name.size() <= 255 && name.front() != '.' && std::all_of(name.begin(), name.end(), allowed);
}

}  // namespace slipstitch
