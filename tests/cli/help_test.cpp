// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "cli/program.h"
#include "formats/formats.h"

namespace slipstitch::test {
namespace {

const std::set<std::string> kCommands{"simulate", "validate", "effects", "study",  "export",    "serve",  "submit",
                                      "list",     "get",      "watch",   "frames", "artefacts", "cancel", "delete"};

// First words of the lines below "Subcommands:" that are indented by two.
std::set<std::string> commands_of(const std::string& help) {
  std::set<std::string> commands;
  std::istringstream lines(help.substr(help.find("Subcommands:")));
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line) && line.starts_with("  ")) {
    if (line[2] != ' ') commands.insert(line.substr(2, line.find(' ', 2) - 2));
  }
  return commands;
}

TEST(Help, NamesEveryCommandThereIsAndNoOther) {
  const ProgramEnd end = slipstitch({"--help"});
  EXPECT_EQ(end.exit_code, 0);
  EXPECT_EQ(end.err, "");
  EXPECT_EQ(commands_of(end.out), kCommands) << end.out;
}

TEST(Help, EveryCommandHasItsOwn) {
  for (const std::string& command : kCommands) {
    const ProgramEnd end = slipstitch({command, "--help"});
    EXPECT_EQ(end.exit_code, 0) << command;
    EXPECT_NE(end.out.find("slipstitch " + command), std::string::npos) << end.out;
  }
}

TEST(Help, NamesTheFormatsThereAreAndNoOther) {
  for (const char* command : {"frames", "export"}) {
    const std::string help = slipstitch({command, "--help"}).out;
    for (const Format& format : formats()) EXPECT_NE(help.find(std::string(format.name)), std::string::npos) << help;
    for (const char* later : {"usda", "glb", "ply", "npz"}) EXPECT_EQ(help.find(later), std::string::npos) << help;
  }
}

TEST(Help, FitsTerminalsOfEightyColumns) {
  for (const std::string& command : kCommands) {
    if (command == "serve") continue;  // it shows default paths, which may be long
    std::istringstream lines(slipstitch({command, "--help"}).out);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
  }
}

TEST(Help, VersionNamesTheProgramAndItsBlas) {
  const ProgramEnd end = slipstitch({"--version"});
  EXPECT_EQ(end.exit_code, 0);
  EXPECT_TRUE(end.out.starts_with("slipstitch ")) << end.out;
  EXPECT_NE(end.out.find("BLAS"), std::string::npos) << end.out;
}

TEST(Help, WordsWithoutDashesDoTheSame) {
  const auto expect_same = [](const std::vector<std::string>& words, const std::vector<std::string>& options) {
    const ProgramEnd found = slipstitch(words), expected = slipstitch(options);
    EXPECT_EQ(found.exit_code, 0) << words[0] << "\n" << found.err;
    EXPECT_EQ(found.out, expected.out);
    EXPECT_NE(found.out, "");
  };
  expect_same({"help"}, {"--help"});
  expect_same({"help", "frames"}, {"frames", "--help"});
  expect_same({"help", "serve"}, {"serve", "--help"});
  expect_same({"version"}, {"--version"});
  EXPECT_EQ(slipstitch({"help", "simulat"}).exit_code, 2);
}

TEST(Help, AMistypedCommandGetsTheNearest) {
  const ProgramEnd end = slipstitch({"simulat", "x.json"});
  EXPECT_EQ(end.exit_code, 2);
  EXPECT_NE(end.err.find("did you mean 'simulate'?"), std::string::npos) << end.err;
}

TEST(Help, NothingAtAllShowsTheHelpAsAnError) {
  const ProgramEnd end = slipstitch({});
  EXPECT_EQ(end.exit_code, 2);
  EXPECT_EQ(end.out, "");
  EXPECT_NE(end.err.find("simulate"), std::string::npos);
}

}  // namespace
}  // namespace slipstitch::test
