// SPDX-License-Identifier: MIT
#include "server/serve.h"

#include "cli/command.h"

namespace slipstitch {

Command add_serve(CLI::App& root) {
  CLI::App* app = root.add_subcommand("serve", "Serve jobs, the same as slipstitchd");
  app->prefix_command();
  app->set_help_flag();
  return {app, [app] { return serve(app->remaining(), "slipstitch serve"); }};
}

}  // namespace slipstitch
