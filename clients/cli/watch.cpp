// SPDX-License-Identifier: MIT
#include <memory>

#include "cli/command.h"
#include "cli/exit_code.h"
#include "cli/follow_job.h"
#include "cli/options.h"
#include "cli/remote_command.h"

namespace slipstitch {
namespace {

struct WatchOptions {
  std::string job, server;
  bool json = false;
};

int watch(const WatchOptions& options) {
  const std::optional<std::string> name = job_name(options.job);
  Interrupt interrupt({});
  const std::optional<Connection> connection = connect(options.server);
  if (!name || !connection) return kExitBadInput;
  return follow_job(*connection, *name, interrupt, options.json);
}

}  // namespace

Command add_watch(CLI::App& root) {
  auto options = std::make_shared<WatchOptions>();
  CLI::App* app = root.add_subcommand("watch", "Show a job's progress until it ends, and end like it");
  add_job_argument(*app, options->job);
  add_server_option(*app, options->server);
  add_json_flag(*app, options->json);
  return {app, [options] { return watch(*options); }};
}

}  // namespace slipstitch
