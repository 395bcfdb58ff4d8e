// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "run_dir/result.h"
#include "run_dir/run_json.h"

namespace slipstitch {

/// A run directory: the same for a local run and for a job of the server.
///   job.json scene.json   written once, job.json last: a folder without it is no run
///   frames.log            append-only (frame_log.h)
///   progress.json         replaced while running
///   summary.json          written last: a run with it is over
///   report/               named artefacts
///   study/                what a study has run (study_dir.h)
///   control.log           commands to the running process
///   worker.json           which process that is
struct RunDir {
  std::filesystem::path path;

  std::filesystem::path job() const { return path / "job.json"; }
  std::filesystem::path scene() const { return path / "scene.json"; }
  std::filesystem::path frames() const { return path / "frames.log"; }
  std::filesystem::path progress() const { return path / "progress.json"; }
  std::filesystem::path summary() const { return path / "summary.json"; }
  std::filesystem::path report() const { return path / "report"; }
  std::filesystem::path study() const { return path / "study"; }
  std::filesystem::path control() const { return path / "control.log"; }
  std::filesystem::path worker() const { return path / "worker.json"; }
};

/// Makes the folder (and its parents) with scene.json, report/ and job.json, on disk when this returns. A non-empty
/// folder is refused; with `force` the files of an earlier run in it are removed, anything else in it is left alone.
Result<RunDir> create_run_dir(const std::filesystem::path& path, const JobInfo& job, std::string_view scene_json,
                              bool force);

/// An existing run, known by its job.json.
Result<RunDir> open_run_dir(const std::filesystem::path& path);

/// True for a folder with entries, and for anything that is not a folder.
bool occupied(const std::filesystem::path& path);

IoError write_progress(const RunDir& dir, const ProgressInfo& progress);
IoError write_summary(const RunDir& dir, const RunSummary& summary);
IoError write_summary(const RunDir& dir, const StudySummary& summary);
IoError write_worker(const RunDir& dir, const WorkerInfo& worker);

Result<JobInfo> read_job(const RunDir& dir);
Result<std::string> read_scene(const RunDir& dir);  // the text of scene.json
Result<ProgressInfo> read_progress(const RunDir& dir);
Result<RunSummary> read_summary(const RunDir& dir);
Result<WorkerInfo> read_worker(const RunDir& dir);
bool has_summary(const RunDir& dir);

IoError request_cancel(const RunDir& dir);

/// Files in report/, by name. A name is one path component of [A-Za-z0-9._-], not starting with a dot.
std::vector<std::string> list_artefacts(const RunDir& dir);
bool valid_artefact_name(std::string_view name);

}  // namespace slipstitch
