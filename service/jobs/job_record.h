// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "jobs/executor.h"
#include "jobs/job.h"
#include "run_dir/run_dir.h"

namespace slipstitch::jobs {

/// What a file looked like, to see cheaply whether it was replaced or has grown.
struct FileStamp {
  std::uint64_t inode = 0, size = 0;
  std::int64_t modified_ns = 0;
  bool operator==(const FileStamp&) const = default;
};
FileStamp stamp_of(const std::filesystem::path& file);

/// What a server remembers of a job. All of it but the watchers can be read back from the directory.
struct JobRecord {
  Job job;
  RunDir dir;
  WorkerInfo worker;           // while running
  FileStamp progress, frames;  // as last seen
};

/// Reads a job that an earlier server left. A worker that vanished without a summary makes the job FAILED, WORKER_LOST.
Result<JobRecord> load_job(const RunDir& dir, const std::string& id);

/// True when progress.json changed (job.progress is new then) or, with `frames_grew` set, frames.log did.
bool refresh_progress(JobRecord& record, bool& frames_grew);

/// Makes the job terminal once its worker is gone: from summary.json, else FAILED, and a summary.json that says so.
void settle(JobRecord& record, const WorkerEnd& end);

/// Makes a job terminal that no worker may take up any more.
void settle_cancelled(JobRecord& record);
void settle_failed(JobRecord& record, Failure failure);

}  // namespace slipstitch::jobs
