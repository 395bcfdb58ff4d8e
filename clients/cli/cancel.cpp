// SPDX-License-Identifier: MIT
#include <iostream>
#include <memory>

#include "cli/command.h"
#include "cli/exit_code.h"
#include "cli/job_output.h"
#include "cli/options.h"
#include "cli/remote_command.h"

namespace slipstitch {
namespace {

struct CancelOptions {
  std::string job, server;
  bool json = false;
};

int cancel_job(const CancelOptions& options) {
  const std::optional<std::string> name = job_name(options.job);
  const std::optional<Connection> connection = connect(options.server);
  if (!name || !connection) return kExitBadInput;
  v1::CancelSimJobRequest request;
  request.set_name(*name);
  const auto job = unary<v1::SimJob>(connection->jobs(), &v1::SimJobs::Stub::CancelSimJob, request);
  if (!job) return report_error(job.error, *connection);
  if (options.json) {
    std::cout << job_json(*job).dump(2) << std::endl;
  } else {
    std::cout << job->name() << ": " << state_text(*job) << std::endl;
  }
  return kExitDone;
}

}  // namespace

Command add_cancel(CLI::App& root) {
  auto options = std::make_shared<CancelOptions>();
  CLI::App* app = root.add_subcommand("cancel", "Ask a job to stop; its frames so far stay");
  add_job_argument(*app, options->job);
  add_server_option(*app, options->server);
  add_json_flag(*app, options->json);
  return {app, [options] { return cancel_job(*options); }};
}

}  // namespace slipstitch
