// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/exit_code.h"
#include "cli/options.h"
#include "platform/startup.h"
#include "platform/version.h"
#include "scene_io/nearest_name.h"

namespace {

using namespace slipstitch;

std::vector<Command> add_commands(CLI::App& app) {
  return {add_simulate(app), add_validate(app),  add_effects(app), add_study(app), add_export(app),
          add_serve(app),    add_submit(app),    add_list(app),    add_get(app),   add_watch(app),
          add_frames(app),   add_artefacts(app), add_cancel(app),  add_delete(app)};
}

// Empty when the word is a command or an option. CLI11 would only say that it did not expect it.
std::string unknown_command(const std::string& word, const std::vector<Command>& commands) {
  if (word.empty() || word.front() == '-') return {};
  std::vector<std::string> names;
  for (const Command& command : commands) names.push_back(command.app->get_name());
  if (std::find(names.begin(), names.end(), word) != names.end()) return {};
  const std::string meant = nearest_name(word, names);
  return "there is no command '" + word + "'; " +
         (meant.empty() ? "there are " + one_of(names) : "did you mean '" + meant + "'?");
}

// "help" and "version" as words: what the options of that name do.
std::vector<std::string> with_options_for_words(std::vector<std::string> words) {
  if (words.front() == "version") words.front() = "--version";
  if (words.front() != "help") return words;
  words.erase(words.begin());
  words.emplace_back("--help");
  return words;
}

int usage_error(const CLI::App& app, const CLI::ParseError& error) {
  const auto used = app.get_subcommands();
  complain(error.what());
  note("See 'slipstitch " + (used.empty() ? "" : used.front()->get_name() + " ") + "--help'.");
  return kExitBadInput;
}

}  // namespace

int main(int argc, char** argv) {
  start_process(argv);
  CLI::App app("Slipstitch simulates knitted fabric yarn by yarn.", "slipstitch");
  app.set_version_flag("--version", version_line("slipstitch"), "Show version and BLAS");
  app.require_subcommand(1);
  app.get_formatter()->column_width(26);
  const std::vector<Command> commands = add_commands(app);
  // Behind the commands, which would inherit it.
  app.footer(
      "'slipstitch COMMAND --help' shows the options of a command.\n"
      "Exit codes: 0 done, 1 the run failed, 2 bad usage or input, 3 no server,\n"
      "            4 cancelled, 130 interrupted.");
  if (argc < 2) {
    std::cerr << app.help();
    return kExitBadInput;
  }
  std::vector<std::string> words = with_options_for_words({argv + 1, argv + argc});
  if (const std::string why = unknown_command(words.front(), commands); !why.empty()) {
    complain(why);
    return kExitBadInput;
  }
  std::reverse(words.begin(), words.end());  // CLI11 takes them from the back
  try {
    app.parse(words);
  } catch (const CLI::CallForHelp& call) {
    return app.exit(call);
  } catch (const CLI::CallForVersion& call) {
    return app.exit(call);
  } catch (const CLI::ParseError& error) {
    return usage_error(app, error);
  }
  const auto used = std::find_if(commands.begin(), commands.end(), [](const Command& c) { return c.app->parsed(); });
  const int code = used->run();
  if (std::cout.flush()) return code;
  complain("cannot write to standard output");
  return code == 0 ? kExitFailed : code;
}
