// SPDX-License-Identifier: MIT
#include "worker/run_job.h"

#include <utility>
#include <variant>

#include "platform/blas.h"
#include "platform/memory.h"
#include "platform/version.h"
#include "scene_io/issue_text.h"
#include "scene_io/load_scene.h"
#include "study/choose_effects.h"
#include "worker/run_study_job.h"

namespace slipstitch {
namespace {

RunSummary failed(std::string message) {
  RunSummary summary;
  summary.message = std::move(message);
  return summary;
}

RunSummary run_stored_scene(const RunDir& dir, int threads, const RunHooks& hooks) {
  const Result<std::string> text = read_scene(dir);
  if (!text) return failed(text.error);
  const LoadResult loaded = load_scene_json(*text);
  if (const auto* issues = std::get_if<Issues>(&loaded)) return failed(issue_lines(*issues));
  return run_scene(std::get<LoadedScene>(loaded).scene, threads, hooks);
}

}  // namespace

Result<RunSummary> run_job(const RunDir& dir, RecorderOptions options) {
  const Result<JobInfo> job = read_job(dir);
  if (!job) return Result<RunSummary>::failed(job.error);
  set_blas_threads(job->threads);
  if (job->study) return run_study_job(dir, *job, options);
  options.control_interval_s = 0.0;
  RunRecorder recorder(dir, std::move(options));
  RunSummary summary = run_stored_scene(dir, job->threads, recorder.hooks());
  summary.scene = job->scene_name;
  summary.threads = job->threads;
  summary.blas = to_string(blas_in_use());
  summary.version = version_string();
  summary.peak_memory_bytes = peak_memory_bytes();
  return recorder.finish(std::move(summary));
}

}  // namespace slipstitch
