// SPDX-License-Identifier: MIT
#include "cli/follow_job.h"

#include <iostream>

#include "cli/exit_code.h"
#include "cli/job_output.h"
#include "cli/options.h"
#include "cli/remote/watch_job.h"
#include "cli/remote_command.h"
#include "cli/screen/progress_bar.h"

namespace slipstitch {
namespace {

void show(const v1::SimJob& job, ProgressBar& bar) {
  if (job.state() == v1::SimJob::QUEUED) return bar.show(job.name() + " waits in the queue");
  if (!job.has_progress()) return bar.show(job.name() + " starts");
  const v1::JobProgress& progress = job.progress();
  if (job.has_study()) return bar.show_share(progress.share_done(), progress.doing(), eta_from(job));
  if (!is_simulating(progress)) return bar.show(job.name() + " is " + progress.doing());
  bar.show(progress_from(progress), eta_from(job));
}

void print_end(const v1::SimJob& job, const Connection& connection, bool json) {
  if (json) {
    std::cout << job_json(job).dump(2) << std::endl;
  } else {
    std::cout << job_summary_text(job) << std::flush;
    if (job.has_study() && job.state() != v1::SimJob::CANCELLED)
      note("To fetch the report:\n  " + command_for("artefacts", job.name(), connection) + " --out DIR");
  }
  if (job.state() == v1::SimJob::FAILED) complain(job.name() + " failed: " + remote_error(job.error()).message);
  if (job.state() == v1::SimJob::CANCELLED) complain(job.name() + " was cancelled");
}

}  // namespace

int follow_job(const Connection& connection, const std::string& name, Interrupt& interrupt, bool json) {
  ProgressBar bar;
  const Reply<v1::SimJob> end = watch_job(
      connection, name, [&] { return interrupt.requested(); }, [&](const v1::SimJob& job) { show(job, bar); },
      [&](const RemoteError& error) {
        bar.clear();
        note("Lost the server (" + plain_text(error) + "); trying again.");
      });
  bar.finish();
  if (end) {
    print_end(*end, connection, json);
    return exit_code_of(end->state());
  }
  if (end.error.code != grpc::StatusCode::OK) return report_error(end.error, connection);
  note(name + " goes on. To see it again:\n  " + command_for("watch", name, connection));
  return kExitInterrupted;
}

}  // namespace slipstitch
