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

struct GetOptions {
  std::string job, server;
  bool json = false;
};

int get_job(const GetOptions& options) {
  const std::optional<std::string> name = job_name(options.job);
  const std::optional<Connection> connection = connect(options.server);
  if (!name || !connection) return kExitBadInput;
  v1::GetSimJobRequest request;
  request.set_name(*name);
  const auto job = unary<v1::SimJob>(connection->jobs(), &v1::SimJobs::Stub::GetSimJob, request);
  if (!job) return report_error(job.error, *connection);
  if (options.json) {
    std::cout << job_json(*job).dump(2) << std::endl;
  } else {
    std::cout << job_text(*job) << job_summary_text(*job) << std::flush;
  }
  return kExitDone;
}

}  // namespace

Command add_get(CLI::App& root) {
  auto options = std::make_shared<GetOptions>();
  CLI::App* app = root.add_subcommand("get", "Show a job, and its summary once it has ended");
  add_job_argument(*app, options->job);
  add_server_option(*app, options->server);
  add_json_flag(*app, options->json);
  return {app, [options] { return get_job(*options); }};
}

}  // namespace slipstitch
