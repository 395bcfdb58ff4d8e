// SPDX-License-Identifier: MIT
#include <signal.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <iostream>

#include "jobs/data_dir.h"
#include "jobs/executor.h"
#include "platform/startup.h"
#include "platform/version.h"
#include "worker/predict.h"
#include "worker/run_job.h"

namespace {

using namespace slipstitch;

// SIGINT and SIGTERM wait, blocked, to be seen by the next look: no handler, no global flag.
void block_stop_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  sigprocmask(SIG_BLOCK, &signals, nullptr);
}

bool stop_signal_waits() {
  sigset_t pending;
  sigpending(&pending);
  return sigismember(&pending, SIGINT) == 1 || sigismember(&pending, SIGTERM) == 1;
}

int exit_code(RunStatus status) {
  switch (status) {
    case RunStatus::succeeded:
      return 0;
    case RunStatus::cancelled:
      return 4;
    case RunStatus::failed:
      break;
  }
  return 1;
}

int run_worker(const RunDir& dir) {
  const Result<UniqueFd> lock = jobs::lock_job(dir);
  if (!lock) {
    std::cerr << "slipstitch-worker: " << lock.error << "\n";
    return jobs::kWorkerExitBusy;
  }
  if (has_summary(dir)) {
    std::cerr << "slipstitch-worker: " << dir.path.string() << " has been run already\n";
    return 2;
  }
  const std::optional<WorkerInfo> self = describe_process(::getpid());
  const IoError error = self ? write_worker(dir, *self) : "cannot read /proc";
  if (!error.empty()) {
    std::cerr << "slipstitch-worker: " << error << "\n";
    return 1;
  }
  if (const Result<JobInfo> job = read_job(dir); job) {
    std::cerr << "slipstitch-worker: running " << job->name << " with " << job->threads << " threads" << std::endl;
  }
  RecorderOptions options;
  options.should_stop = stop_signal_waits;
  const Result<RunSummary> summary = run_job(dir, options);
  if (!summary) {
    std::cerr << "slipstitch-worker: " << summary.error << "\n";
    return 1;
  }
  std::cerr << "slipstitch-worker: " << status_word(summary->status) << " " << summary->message << "\n";
  return exit_code(summary->status);
}

}  // namespace

int main(int argc, char** argv) {
  start_process(argv);
  CLI::App app("Runs the one job in a job directory. Meant to be started by slipstitchd.", "slipstitch-worker");
  std::string job_dir;
  bool predict = false;
  auto* what = app.add_option_group("work")->require_option(1);
  what->add_option("--job-dir", job_dir, "The job's run directory")->check(CLI::ExistingDirectory);
  what->add_flag("--predict", predict, "Say what a run of the scene on standard input takes");
  app.set_version_flag("--version", version_line("slipstitch-worker"));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  if (predict) return predict_for_server();
  block_stop_signals();
  return run_worker({job_dir});
}
