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

struct DeleteOptions {
  std::string job, server;
  bool json = false;
};

int delete_job(const DeleteOptions& options) {
  const std::optional<std::string> name = job_name(options.job);
  const std::optional<Connection> connection = connect(options.server);
  if (!name || !connection) return kExitBadInput;
  v1::DeleteSimJobRequest request;
  request.set_name(*name);
  const auto done = unary<google::protobuf::Empty>(connection->jobs(), &v1::SimJobs::Stub::DeleteSimJob, request);
  if (!done) return report_error(done.error, *connection);
  if (options.json) {
    std::cout << nlohmann::ordered_json{{"name", *name}, {"deleted", true}}.dump(2) << std::endl;
  } else {
    std::cout << *name << ": deleted" << std::endl;
  }
  return kExitDone;
}

}  // namespace

Command add_delete(CLI::App& root) {
  auto options = std::make_shared<DeleteOptions>();
  CLI::App* app = root.add_subcommand("delete", "Remove an ended job and all its data");
  add_job_argument(*app, options->job);
  add_server_option(*app, options->server);
  add_json_flag(*app, options->json);
  return {app, [options] { return delete_job(*options); }};
}

}  // namespace slipstitch
