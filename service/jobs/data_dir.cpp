// SPDX-License-Identifier: MIT
#include "jobs/data_dir.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <thread>

#include "jobs/job_id.h"
#include "run_dir/atomic_file.h"

namespace slipstitch::jobs {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr auto kLongestStart = 5000ms, kLook = 10ms;

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string() : std::string(value);
}

Error data_dir_error(const fs::path& path, const std::string& why) {
  return {ErrorCode::failed_precondition, "DATA_DIR_UNUSABLE", path.string() + ": " + why, {}, {}, {}};
}

std::string owner_of(const fs::path& path) {
  const Result<std::string> owner = read_file(path / "lock", 64);
  return owner ? owner->substr(0, owner->find('\n')) : "unknown";
}

bool is_gone(const std::string& pid) {
  const long number = std::strtol(pid.c_str(), nullptr, 10);
  return number > 0 && ::kill(static_cast<pid_t>(number), 0) != 0 && errno == ESRCH;
}

/// A worker that a killed server was just starting has its lock until it runs another program.
bool lock_soon(int lock, const fs::path& path) {
  for (auto waited = 0ms; waited <= kLongestStart; waited += kLook) {
    if (::flock(lock, LOCK_EX | LOCK_NB) == 0) return true;
    if (!is_gone(owner_of(path))) return false;
    std::this_thread::sleep_for(kLook);
  }
  return false;
}

Error data_dir_in_use(const fs::path& path) {
  const std::string pid = owner_of(path);
  return {ErrorCode::failed_precondition,
          "DATA_DIR_IN_USE",
          path.string() + " is in use by another server (pid " + pid + ")",
          {{"pid", pid}},
          {},
          {}};
}

Outcome<UniqueFd> take_lock(const fs::path& path) {
  UniqueFd lock(::open((path / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644));
  if (!lock) return data_dir_error(path, errno_message("open", path / "lock"));
  if (!lock_soon(lock.get(), path)) return data_dir_in_use(path);
  const std::string pid = std::to_string(::getpid()) + "\n";
  if (::ftruncate(lock.get(), 0) != 0 || !write_all(lock.get(), pid.data(), pid.size())) {
    return data_dir_error(path, errno_message("write", path / "lock"));
  }
  return lock;
}

}  // namespace

fs::path default_data_dir() {
  if (const std::string state = variable("XDG_STATE_HOME"); !state.empty()) return fs::path(state) / "slipstitch";
  if (const std::string home = variable("HOME"); !home.empty()) return fs::path(home) / ".local/state/slipstitch";
  return {};
}

Outcome<DataDir> DataDir::open(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path / "jobs", error);
  if (error) return data_dir_error(path, error.message());
  Outcome<UniqueFd> lock = take_lock(path);
  if (!lock) return lock.error();
  fs::remove_all(path / "tmp", error);
  if (!error) fs::create_directories(path / "tmp", error);
  if (error) return data_dir_error(path / "tmp", error.message());
  return DataDir(path, std::move(*lock));
}

std::vector<std::string> DataDir::job_ids() const {
  std::vector<std::string> ids;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(path_ / "jobs", error)) {
    if (std::string id = entry.path().filename().string(); is_job_id(id)) ids.push_back(std::move(id));
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

IoError DataDir::create_job(const std::string& id, const JobInfo& info, std::string_view scene_json) const {
  const fs::path temporary = path_ / "tmp" / id;
  if (auto made = create_run_dir(temporary, info, scene_json, false); !made) return made.error;
  std::error_code error;
  fs::rename(temporary, job(id).path, error);
  if (error) return job(id).path.string() + ": " + error.message();
  return sync_folder(path_ / "jobs");
}

IoError DataDir::remove_job(const std::string& id) const {
  const fs::path temporary = path_ / "tmp" / id;
  std::error_code error;
  fs::rename(job(id).path, temporary, error);
  if (error) return job(id).path.string() + ": " + error.message();
  const IoError unsynced = sync_folder(path_ / "jobs");
  fs::remove_all(temporary, error);  // what stays is cleared by the next start
  return unsynced;
}

Result<UniqueFd> lock_job(const RunDir& dir) {
  UniqueFd lock(::open(dir.path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!lock) return Result<UniqueFd>::failed(errno_message("open", dir.path));
  if (::flock(lock.get(), LOCK_EX | LOCK_NB) != 0) return Result<UniqueFd>::failed(errno_message("lock", dir.path));
  return Result<UniqueFd>::of(std::move(lock));
}

}  // namespace slipstitch::jobs
