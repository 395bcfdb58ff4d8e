// SPDX-License-Identifier: MIT
#include <iostream>
#include <memory>

#include "cli/command.h"
#include "cli/exit_code.h"
#include "cli/interrupt.h"
#include "cli/options.h"
#include "cli/screen/progress_bar.h"
#include "cli/screen/summary_text.h"
#include "cli/screen/text.h"
#include "jobs/worker_environment.h"
#include "platform/blas.h"
#include "platform/memory.h"
#include "platform/version.h"
#include "run_dir/run_recorder.h"
#include "scene_io/message_json.h"
#include "scene_io/spec_hash.h"
#include "slipstitch/v1/job.pb.h"
#include "study/choose_effects.h"

namespace slipstitch {
namespace {

struct SimulateOptions {
  SceneOptions scene;
  std::string out;
  int threads = 0;
  bool force = false, json = false;
};

JobInfo job_info(const LoadedScene& scene, int threads) {
  v1::SimJobSpec spec;
  *spec.mutable_scene() = scene.message;
  spec.set_threads(static_cast<std::uint32_t>(threads));
  spec.mutable_simulate();
  JobInfo job;
  job.spec_hash = message_hash(spec);
  job.threads = threads;
  job.blas = jobs::blas_core_for_jobs();
  job.create_time = utc_now();
  job.scene_name = scene.scene.name;
  return job;
}

// Asks the interrupt between steps only, so that the step under way is finished; before the first one at any time.
class StepwiseStop {
 public:
  explicit StepwiseStop(Interrupt& interrupt) : interrupt_(interrupt) {}
  void step_done() {
    stepping_ = true;
    stop_ = interrupt_.requested();
  }
  bool operator()() {
    const bool requested = interrupt_.requested();
    return stop_ || (requested && !stepping_);
  }

 private:
  Interrupt& interrupt_;
  bool stepping_ = false, stop_ = false;
};

// With a directory everything goes there, without one nothing is kept.
Result<RunSummary> simulate_here(const LoadedScene& scene, int threads, const std::optional<RunDir>& dir,
                                 RecorderOptions options) {
  const auto finished = [&](RunSummary summary) {
    summary.blas = to_string(blas_in_use());
    summary.version = version_string();
    summary.peak_memory_bytes = peak_memory_bytes();
    return summary;
  };
  if (dir) {
    RunRecorder recorder(*dir, std::move(options));
    return recorder.finish(finished(run_scene(scene.scene, threads, recorder.hooks())));
  }
  RunHooks hooks;
  hooks.on_progress = options.on_progress;
  hooks.should_stop = options.should_stop;
  return Result<RunSummary>::of(finished(run_scene(scene.scene, threads, hooks)));
}

int report(const RunSummary& summary, const SimulateOptions& options, bool interrupted) {
  const auto json = to_json(summary);
  if (options.json) {
    std::cout << json.dump(2) << std::endl;
  } else {
    Rows more;
    if (!options.out.empty()) more.emplace_back("kept in", options.out);
    std::cout << summary_text(json, more) << std::flush;
  }
  switch (summary.status) {
    case RunStatus::succeeded:
      return kExitDone;
    case RunStatus::cancelled:
      if (interrupted && !options.out.empty()) {
        note("Interrupted; '" + options.out + "' holds a valid run of " + count_of(summary.frames, "frame", "frames") +
             ".");
      }
      return interrupted ? kExitInterrupted : kExitCancelled;
    case RunStatus::failed:
      break;
  }
  complain("the run failed: " + summary.message);
  return kExitFailed;
}

int simulate(const SimulateOptions& options) {
  const std::optional<LoadedScene> scene = load(options.scene);
  if (!scene || (!options.out.empty() && refuse_occupied(options.out, options.force))) return kExitBadInput;
  ProgressBar bar;
  Interrupt interrupt([&] {
    bar.clear();
    note("Stopping after this step; Ctrl-C again ends at once.");
  });
  const int threads = options.threads > 0 ? options.threads : jobs::kDefaultThreads;
  set_blas_threads(threads);
  std::optional<RunDir> dir;
  if (!options.out.empty()) {
    Result<RunDir> made =
        create_run_dir(options.out, job_info(*scene, threads), json_text(scene->message), options.force);
    if (!made) {
      complain(made.error);
      return kExitFailed;
    }
    dir = std::move(*made);
  }
  bar.show("preparing " + (scene->scene.name.empty() ? options.scene.scene : scene->scene.name));
  StepwiseStop stop(interrupt);
  RecorderOptions recorder;
  recorder.on_progress = [&](const Progress& progress) {
    if (!progress.doing.empty()) return bar.show(progress.doing);
    stop.step_done();
    bar.show(progress, estimate_eta(progress));
  };
  recorder.should_stop = [&] { return stop(); };
  const Result<RunSummary> summary = simulate_here(*scene, threads, dir, std::move(recorder));
  bar.finish();
  if (!summary) {
    complain(summary.error);
    return kExitFailed;
  }
  if (!dir && !options.json && summary->status == RunStatus::succeeded) note("No --out: the frames are not kept.");
  return report(*summary, options, interrupt.requested());
}

}  // namespace

Command add_simulate(CLI::App& root) {
  auto options = std::make_shared<SimulateOptions>();
  CLI::App* app = root.add_subcommand("simulate", "Run a scene here, without a server");
  add_scene_options(*app, options->scene);
  app->add_option("--out", options->out, "Keep the run in this directory, new or empty")->type_name("DIR");
  app->add_flag("--force", options->force, "Replace the run in a directory that is not empty");
  add_threads_option(*app, options->threads);
  add_json_flag(*app, options->json);
  return {app, [options] { return simulate(*options); }};
}

}  // namespace slipstitch
