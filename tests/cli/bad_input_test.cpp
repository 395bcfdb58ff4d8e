// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "cli/program.h"

namespace slipstitch::test {
namespace {

struct Mistake {
  std::vector<std::string>
      arguments;                  // FOLDER stands for a folder with good.json, bad.json, chart.k, full/ and no more
  std::vector<std::string> said;  // in stderr
};

const std::vector<Mistake> kMistakes{
    {{"simulate"}, {"SCENE is required", "slipstitch simulate --help"}},
    {{"simulate", "FOLDER/none.json"}, {"there is no file", "none.json"}},
    {{"simulate", "FOLDER"}, {"is a folder"}},
    {{"simulate", "FOLDER/chart.k"}, {"not supported yet", ".json"}},
    {{"simulate", "FOLDER/good.json", "--out", "FOLDER/full"}, {"not empty", "--force"}},
    {{"simulate", "FOLDER/good.json", "--out", "FOLDER/good.json"}, {"not a folder"}},
    {{"simulate", "FOLDER/good.json", "--threads", "0"}, {"--threads"}},
    {{"simulate", "FOLDER/good.json", "--treads", "2"}, {"--treads"}},
    {{"simulate", "FOLDER/good.json", "--set", "yarn.radius=1e-3"}, {"yarn.radius: ", "radius_m"}},
    {{"simulate", "FOLDER/good.json", "--set", "yarn.radius_m"}, {"PATH=VALUE"}},
    {{"simulate", "FOLDER/good.json", "--set", "yarn.radius_m=-1"}, {"yarn.radius_m: is -1, expected"}},
    {{"simulate", "FOLDER/good.json", "--set", "yarn.radius_m=NaN"}, {"yarn.radius_m: "}},
    {{"simulate", "FOLDER/good.json", "--set", "durationS=2"}, {"durationS: ", "duration_s"}},
    {{"validate", "FOLDER/bad.json"}, {"2 problems:", "yarn.radius_m: is -1, ", "duration_s: is -2, "}},
    {{"submit", "FOLDER/bad.json"}, {"2 problems:", "yarn.radius_m: is -1, ", "duration_s: is -2, "}},
    {{"export", "FOLDER/none", "--out", "FOLDER/new", "--format", "obj"}, {"none"}},
    {{"export", "FOLDER/full", "--out", "FOLDER/new", "--format", "obj"}, {"full"}},
    {{"export", "FOLDER/full", "--out", "FOLDER/new", "--format", "usda"},
     {"'usda' is not supported yet", "obj bcc vtp"}},
    {{"export", "FOLDER/full", "--out", "FOLDER/new", "--format", "objj"}, {"'objj' is unknown", "obj bcc vtp"}},
    {{"export", "FOLDER/full", "--out", "FOLDER/new", "--format", "obj", "--stride", "0"}, {"--stride"}},
    {{"export", "FOLDER/full", "--format", "obj"}, {"--out is required"}},
    {{"frames", "abc", "--out", "FOLDER/full", "--format", "obj"}, {"not empty", "--force"}},
    {{"frames", "abc", "--out", "FOLDER/new", "--format", "glb"}, {"'glb' is not supported yet"}},
    {{"get"}, {"JOB is required"}},
    {{"get", ""}, {"simJobs/ID"}},
    {{"get", "simJobs/"}, {"simJobs/ID"}},
    {{"get", "jobs/abc"}, {"simJobs/ID"}},
    {{"list", "--server", "localhost"}, {"'localhost'", "HOST:PORT"}},
    {{"list", "--server", "http://localhost:50651"}, {"HOST:PORT"}},
    {{"list", "--server", "localhost:http"}, {"HOST:PORT"}},
    {{"list", "more"}, {"more"}},
    {{"serve", "--slots", "0"}, {"--slots"}},
};

std::string with_folder(std::string text, const std::string& folder) {
  if (text.starts_with("FOLDER")) text.replace(0, 6, folder);
  return text;
}

TEST(BadInput, ExitsWithTwoAndSaysWhatWasExpected) {
  const TemporaryFolder folder;
  write_bytes(folder / "good.json", swing_scene(0.1));
  write_bytes(folder / "bad.json", R"({"yarns": [{"points_m": [0, 0, 0, 1, 0, 0]}],
    "yarn": {"radius_m": -1}, "effects": {"stretch": {}}, "duration_s": -2})");
  write_bytes(folder / "chart.k", ";!knitout-2\n");
  std::filesystem::create_directory(folder / "full");
  write_bytes(folder / "full" / "note", "keep");
  for (const Mistake& mistake : kMistakes) {
    std::vector<std::string> arguments;
    std::string line;
    for (const std::string& argument : mistake.arguments) {
      arguments.push_back(with_folder(argument, folder.path().string()));
      line += " " + argument;
    }
    const ProgramEnd end = slipstitch(arguments);
    EXPECT_EQ(end.exit_code, 2) << line << "\n" << end.err;
    EXPECT_EQ(end.out, "") << line;
    for (const std::string& said : mistake.said) {
      EXPECT_NE(end.err.find(said), std::string::npos) << line << "\ndoes not say: " << said << "\nbut:\n" << end.err;
    }
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "new"));
  EXPECT_EQ(read_bytes(folder / "full" / "note"), "keep");
}

TEST(BadInput, NoServerIsNamedWithItsAddressAndWhatToDo) {
  const std::string address = "127.0.0.1:1";  // tcpmux: nobody listens
  const TemporaryFolder folder;
  write_bytes(folder / "good.json", swing_scene(0.1));
  const std::string scene = folder / "good.json", out = folder / "out";
  const std::vector<std::vector<std::string>> calls{{"list"},
                                                    {"get", "abc"},
                                                    {"watch", "abc"},
                                                    {"cancel", "abc"},
                                                    {"delete", "abc"},
                                                    {"submit", scene},
                                                    {"submit", scene, "--wait"},
                                                    {"frames", "abc", "--out", out, "--format", "obj"}};
  for (std::vector<std::string> call : calls) {
    const ProgramEnd by_variable = run_program("slipstitch", call, {"SLIPSTITCH_SERVER=" + address});
    call.insert(call.end(), {"--server", address});
    const ProgramEnd by_option = slipstitch(call);
    for (const ProgramEnd& end : {by_option, by_variable}) {
      EXPECT_EQ(end.exit_code, 3) << call[0] << "\n" << end.err;
      EXPECT_EQ(end.out, "") << call[0];
      EXPECT_NE(end.err.find(address), std::string::npos) << end.err;
      EXPECT_NE(end.err.find("slipstitch serve"), std::string::npos) << end.err;
      EXPECT_NE(end.err.find("Connection refused"), std::string::npos) << end.err;
      EXPECT_EQ(end.err.find("last error"), std::string::npos) << "gRPC's own words: " << end.err;
    }
  }
  EXPECT_FALSE(std::filesystem::exists(out));
}

}  // namespace
}  // namespace slipstitch::test
