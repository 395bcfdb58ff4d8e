// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace slipstitch {

/// One word of the command line. `run` returns the exit code; it owns the options that `app` fills.
struct Command {
  CLI::App* app = nullptr;
  std::function<int()> run;
};

Command add_simulate(CLI::App& root);
Command add_validate(CLI::App& root);
Command add_effects(CLI::App& root);
Command add_study(CLI::App& root);
Command add_serve(CLI::App& root);  // only for the help; main() hands its arguments on
Command add_submit(CLI::App& root);
Command add_list(CLI::App& root);
Command add_get(CLI::App& root);
Command add_watch(CLI::App& root);
Command add_artefacts(CLI::App& root);
Command add_cancel(CLI::App& root);
Command add_delete(CLI::App& root);
Command add_frames(CLI::App& root);
Command add_export(CLI::App& root);

}  // namespace slipstitch
