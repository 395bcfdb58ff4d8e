// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "jobs/error.h"
#include "run_dir/run_dir.h"
#include "run_dir/unique_fd.h"

namespace slipstitch::jobs {

/// $XDG_STATE_HOME/slipstitch, else ~/.local/state/slipstitch; empty when neither variable is set.
std::filesystem::path default_data_dir();

/// The folder that holds all jobs: DIR/jobs/ID is the run directory of a job, DIR/tmp/ what is being made or removed,
/// DIR/lock names the server that owns it.
class DataDir {
 public:
  /// Makes what is missing, takes the lock and clears tmp/. Refused while another server holds the lock.
  static Outcome<DataDir> open(const std::filesystem::path& path);

  RunDir job(std::string_view id) const { return {path_ / "jobs" / id}; }
  std::vector<std::string> job_ids() const;  // sorted

  /// On disk when this returns; after a crash the job is there completely or not at all.
  IoError create_job(const std::string& id, const JobInfo& info, std::string_view scene_json) const;
  IoError remove_job(const std::string& id) const;

 private:
  DataDir(std::filesystem::path path, UniqueFd lock) : path_(std::move(path)), lock_(std::move(lock)) {}

  std::filesystem::path path_;
  UniqueFd lock_;
};

/// Held by a worker for as long as it runs, so that a job never has two.
Result<UniqueFd> lock_job(const RunDir& dir);

}  // namespace slipstitch::jobs
