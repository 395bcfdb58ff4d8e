// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <signal.h>

#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "support/csv_cells.h"
#include "support/parsers/curves.h"

namespace slipstitch::test {
namespace {

using nlohmann::json;

// A server of its own for each test, stopped with its jobs at the end.
class CliWithServer : public ::testing::Test {
 protected:
  void SetUp() override {
    write_bytes(folder_ / "swing.json", swing_scene(0.2));
    write_bytes(folder_ / "long.json", swing_scene(10000.0));
    server_ = std::make_unique<Program>(
        "slipstitchd", std::vector<std::string>{"--grpc", "127.0.0.1:0", "--http", "none", "--data-dir",
                                                folder_ / "data", "--stop-jobs"});
    wait_until([&] { return server_->out().ends_with("\n") || !server_->running(); });
    const std::string ready = server_->out();
    const std::size_t place = ready.find("grpc=");
    ASSERT_NE(place, std::string::npos) << ready;
    address_ = ready.substr(place + 5, ready.find_first_of(" \n", place) - place - 5);
  }
  void TearDown() override {
    server_->send(SIGTERM);
    server_->wait();
  }

  std::vector<std::string> with_server(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), {"--server", address_});
    return arguments;
  }
  ProgramEnd call(const std::vector<std::string>& arguments) const { return slipstitch(with_server(arguments)); }

  std::string submit(const std::string& scene, std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"submit", folder_ / scene});
    const ProgramEnd end = call(more);
    EXPECT_EQ(end.exit_code, 0) << end.err;
    EXPECT_TRUE(end.out.starts_with("simJobs/")) << end.out;
    return end.out.substr(0, end.out.find('\n'));
  }
  std::string status(const std::string& job) const { return json::parse(call({"get", job, "--json"}).out)["status"]; }

  // Sends SIGINT once the program waits for it; the job must go on and the way back be named.
  void expect_detached(Program& program, const std::string& job, const std::string& again) {
    program.send(SIGINT);
    const ProgramEnd end = program.wait();
    EXPECT_EQ(end.exit_code, 130) << end.err;
    EXPECT_NE(end.err.find("slipstitch " + again + " " + job + " --server " + address_), std::string::npos) << end.err;
    EXPECT_EQ(status(job), "running");
  }

  TemporaryFolder folder_;
  std::unique_ptr<Program> server_;
  std::string address_;
};

TEST_F(CliWithServer, SubmitWaitPrintsTheNameFirstAndEndsLikeTheJob) {
  const ProgramEnd end = call({"submit", folder_ / "swing.json", "--wait"});
  EXPECT_EQ(end.exit_code, 0) << end.err;
  EXPECT_TRUE(end.out.starts_with("simJobs/")) << end.out;
  EXPECT_NE(end.out.find("swing: succeeded"), std::string::npos) << end.out;
  EXPECT_EQ(end.err, "");
}

TEST_F(CliWithServer, JsonHasTheNameAndTheWholeSummary) {
  const ProgramEnd end = call({"submit", folder_ / "swing.json", "--wait", "--json", "--threads", "1"});
  ASSERT_EQ(end.exit_code, 0) << end.err;
  const json job = json::parse(end.out);
  const json local = json::parse(slipstitch({"simulate", folder_ / "swing.json", "--json", "--threads", "1"}).out);
  for (const auto& [key, value] : local.items()) EXPECT_TRUE(job.contains(key)) << key;
  EXPECT_EQ(job["state_hash"], local["state_hash"]);
  EXPECT_EQ(job["status"], "succeeded");
  const std::string name = job["name"];
  EXPECT_EQ(json::parse(call({"get", name, "--json"}).out), job);
  EXPECT_EQ(json::parse(call({"watch", name.substr(name.find('/') + 1), "--json"}).out), job);
  EXPECT_EQ(json::parse(call({"list", "--json"}).out)["jobs"][0], job);
  EXPECT_NE(call({"list"}).out.find(name + "  SUCCEEDED"), std::string::npos);
}

TEST_F(CliWithServer, FramesAreTheFilesOfALocalRun) {
  const std::string job = submit("swing.json", {"--threads", "1"});
  const ProgramEnd end = call({"frames", job, "--out", folder_ / "remote", "--format", "vtp", "--follow"});
  ASSERT_EQ(end.exit_code, 0) << end.err;
  EXPECT_NE(end.out.find("7 frames as vtp"), std::string::npos) << end.out;
  slipstitch({"simulate", folder_ / "swing.json", "--out", folder_ / "run", "--threads", "1"});
  slipstitch({"export", folder_ / "run", "--out", folder_ / "local", "--format", "vtp"});
  for (const auto& file : std::filesystem::directory_iterator(folder_ / "local")) {
    const std::string name = file.path().filename();
    EXPECT_EQ(read_bytes(folder_ / "remote" / name), read_bytes(file.path())) << name;
  }
  const ProgramEnd part =
      call({"frames", job, "--out", folder_ / "part", "--format", "vtp", "--first", "3", "--stride", "3", "--json"});
  EXPECT_EQ(json::parse(part.out)["frames"], 2);
  EXPECT_EQ(read_bytes(folder_ / "part" / "frame_000006.vtp"), read_bytes(folder_ / "local" / "frame_000006.vtp"));
  EXPECT_EQ(call({"frames", job, "--out", folder_ / "part", "--format", "vtp"}).exit_code, 2);
  EXPECT_EQ(call({"frames", job, "--out", folder_ / "none", "--format", "vtp", "--first", "7"}).exit_code, 1);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "none"));
}

TEST_F(CliWithServer, AKilledDownloadLeavesAListOfTheFramesItHas) {
  const std::string job = submit("long.json");
  Program fetching("slipstitch", with_server({"frames", job, "--out", folder_ / "vtp", "--format", "vtp", "--follow"}));
  wait_until([&] { return std::filesystem::exists(folder_ / "vtp" / "frame_000005.vtp") || !fetching.running(); });
  fetching.send(SIGKILL);
  EXPECT_EQ(fetching.wait().signal, SIGKILL);
  const auto listed = parse_pvd(read_bytes(folder_ / "vtp" / "frames.pvd"));
  ASSERT_TRUE(listed);
  EXPECT_GE(listed->size(), 5U);
  for (const auto& [t, file] : *listed) EXPECT_TRUE(parse_vtp(read_bytes(folder_ / "vtp" / file))) << file;
}

TEST_F(CliWithServer, TheSameRequestIdGivesTheSameJob) {
  const std::string job = submit("swing.json", {"--request-id", "a-1"});
  EXPECT_EQ(submit("swing.json", {"--request-id", "a-1"}), job);
  EXPECT_NE(submit("swing.json"), job);
  const ProgramEnd other = call({"submit", folder_ / "swing.json", "--request-id", "a-1", "--set", "duration_s=0.1"});
  EXPECT_EQ(other.exit_code, 2) << other.err;
  const ProgramEnd bad = call({"submit", folder_ / "swing.json", "--request-id", "a b"});
  EXPECT_EQ(bad.exit_code, 2);
  EXPECT_EQ(bad.err, "slipstitch: request_id: is a b, expected at most 128 of A-Z a-z 0-9 . _ : -\n");
}

TEST_F(CliWithServer, WatchExitsWithFourWhenTheJobIsCancelledAndDeleteWaitsForTheEnd) {
  const std::string job = submit("long.json");
  Program watch("slipstitch", with_server({"watch", job}));
  const ProgramEnd early = call({"delete", job});
  EXPECT_EQ(early.exit_code, 1) << early.err;
  EXPECT_EQ(call({"cancel", job}).exit_code, 0);
  const ProgramEnd end = watch.wait();
  EXPECT_EQ(end.exit_code, 4) << end.err;
  EXPECT_NE(end.err.find("was cancelled"), std::string::npos) << end.err;
  EXPECT_EQ(call({"delete", job}).exit_code, 0);
  for (const char* command : {"get", "watch", "cancel", "delete"}) {
    const ProgramEnd gone = call({command, job});
    EXPECT_EQ(gone.exit_code, 2) << command;
    EXPECT_NE(gone.err.find(job), std::string::npos) << gone.err;
  }
  EXPECT_EQ(call({"frames", job, "--out", folder_ / "gone", "--format", "obj"}).exit_code, 2);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "gone"));
}

TEST_F(CliWithServer, AFailedJobExitsWithOneAndItsReason) {
  const ProgramEnd end =
      call({"submit", folder_ / "swing.json", "--wait", "--set", "fixed.max_newton_iterations=1", "--set",
            "fixed.smallest_step_s=1e-3", "--set", "fixed.velocity_tolerance_m_per_s=1e-300"});
  EXPECT_EQ(end.exit_code, 1) << end.err;
  EXPECT_NE(end.err.find(" failed: no step above 0.001 s converges"), std::string::npos) << end.err;
}

TEST_F(CliWithServer, CtrlCLeavesTheJobRunning) {
  Program submitting("slipstitch", with_server({"submit", folder_ / "long.json", "--wait"}));
  wait_until([&] { return submitting.out().ends_with("\n") || !submitting.running(); });
  const std::string job = submitting.out().substr(0, submitting.out().find('\n'));
  Program fetching("slipstitch", with_server({"frames", job, "--out", folder_ / "obj", "--format", "obj", "--follow"}));
  wait_until([&] { return std::filesystem::exists(folder_ / "obj" / "frame_000003.obj") || !fetching.running(); });
  Program watching("slipstitch", with_server({"watch", job}));
  wait_until([&] { return watching.blocks(SIGINT) || !watching.running(); });
  expect_detached(submitting, job, "watch");
  expect_detached(fetching, job, "frames");
  expect_detached(watching, job, "watch");
}

TEST_F(CliWithServer, FramesOfARunningJobComeWithoutFollowAsFarAsThereAreAny) {
  const std::string job = submit("long.json");
  wait_until([&] { return !json::parse(call({"get", job, "--json"}).out)["progress"].is_null(); });
  const ProgramEnd end = call({"frames", job, "--out", folder_ / "some", "--format", "obj"});
  EXPECT_EQ(end.exit_code, 0) << end.err;
  EXPECT_NE(end.err.find("--follow"), std::string::npos) << end.err;
}

// Rung and everything measured that is no time and no memory.
std::vector<std::vector<std::string>> results_of(const std::string& csv) {
  std::vector<std::vector<std::string>> results;
  const auto lines = lines_of(csv);
  for (std::size_t row = 1; row < lines.size(); ++row) {
    auto& result = results.emplace_back();
    for (const char* column : {"scene", "rung", "position_error_m", "stored_error_j", "force_error_n", "order", "steps",
                               "newton_iterations", "factorizations", "reference_error_m", "predictable_until_s"})
      result.push_back(cell(csv, row, column));
  }
  return results;
}

TEST_F(CliWithServer, AStudyReportsWhatTheSameStudyDoesHere) {
  const ProgramEnd end = call({"submit", folder_ / "swing.json", "--study", "--quick", "--wait"});
  ASSERT_EQ(end.exit_code, 0) << end.err;
  const std::string job = end.out.substr(0, end.out.find('\n'));
  EXPECT_NE(end.out.find("swing: succeeded"), std::string::npos) << end.out;
  EXPECT_NE(end.out.find("ways to run it, compared with a reference"), std::string::npos) << end.out;
  EXPECT_NE(end.err.find("slipstitch artefacts " + job), std::string::npos) << end.err;

  const ProgramEnd fetched = call({"artefacts", job, "--out", folder_ / "report", "--json"});
  ASSERT_EQ(fetched.exit_code, 0) << fetched.err;
  const json files = json::parse(fetched.out)["artefacts"];
  ASSERT_EQ(files.size(), 7U);
  for (const json& file : files) {
    const std::string name = file["file"];
    EXPECT_EQ(read_bytes(folder_ / "report" / name).size(), file["size_bytes"]) << name;
  }
  ASSERT_EQ(slipstitch({"study", folder_ / "swing.json", "--quick", "--out", folder_ / "here"}).exit_code, 0);
  const auto results = results_of(read_bytes(folder_ / "report" / "study.csv"));
  EXPECT_EQ(results.size(), 24U);
  EXPECT_EQ(results, results_of(read_bytes(folder_ / "here" / "study.csv")));
  // As its report says, its own scene.json gives another such.
  const ProgramEnd again =
      call({"submit", folder_ / "report" / "scene.json", "--study", "--quick", "--threads", "1", "--json"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(json::parse(again.out)["spec_hash"], json::parse(call({"get", job, "--json"}).out)["spec_hash"]);

  EXPECT_NE(call({"get", job}).out.find("quick study"), std::string::npos);
  EXPECT_NE(call({"list"}).out.find("study"), std::string::npos);
  EXPECT_NE(call({"artefacts", job}).out.find("study.html"), std::string::npos);
  const ProgramEnd occupied = call({"artefacts", job, "--out", folder_ / "report"});
  EXPECT_EQ(occupied.exit_code, 2) << occupied.err;
  const ProgramEnd frames = call({"frames", job, "--out", folder_ / "frames", "--format", "obj"});
  EXPECT_EQ(frames.exit_code, 1);
  EXPECT_EQ(frames.err, "slipstitch: " + job + " is a study, which has no frames; its report is among its artefacts\n");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "frames"));
}

TEST_F(CliWithServer, ACancelledStudyEndsItsWatchAndHasNoReport) {
  const std::string job = submit("long.json", {"--study", "--budget", "3600"});
  wait_until([&] {
    const json progress = json::parse(call({"get", job, "--json"}).out)["progress"];
    return !progress.is_null() && progress["share_done"] > 0.0;
  });
  EXPECT_NE(call({"get", job}).out.find("study, at most 1 h"), std::string::npos) << call({"get", job}).out;
  EXPECT_EQ(json::parse(call({"get", job, "--json"}).out)["work"]["study"]["budget_s"], 3600.0);
  Program watch("slipstitch", with_server({"watch", job}));
  EXPECT_EQ(call({"cancel", job}).exit_code, 0);
  const ProgramEnd end = watch.wait();
  EXPECT_EQ(end.exit_code, 4) << end.err;
  EXPECT_EQ(end.err.find("artefacts"), std::string::npos) << end.err;
  EXPECT_EQ(call({"artefacts", job}).out.find("study"), std::string::npos);
}

TEST_F(CliWithServer, WhatOnlyAStudyHasNeedsOne) {
  for (const std::vector<std::string>& more : {std::vector<std::string>{"--quick"},
                                               {"--budget", "10"},
                                               {"--study", "--budget", "0"},
                                               {"--study", "--budget", "soon"}}) {
    std::vector<std::string> words{"submit", folder_ / "swing.json"};
    words.insert(words.end(), more.begin(), more.end());
    EXPECT_EQ(call(words).exit_code, 2) << more[0];
  }
  EXPECT_EQ(call({"artefacts", "simJobs/none"}).exit_code, 2);
}

TEST_F(CliWithServer, ProxiesHaveNoBusinessOnThisMachine) {
  const std::vector<std::string> proxies{"http_proxy=http://127.0.0.1:1", "https_proxy=http://127.0.0.1:1",
                                         "grpc_proxy=http://127.0.0.1:1", "no_proxy=", "no_grpc_proxy="};
  const ProgramEnd end = run_program("slipstitch", with_server({"list"}), proxies);
  EXPECT_EQ(end.exit_code, 0) << end.err;
}

TEST_F(CliWithServer, TheVariableNamesTheServerToo) {
  const ProgramEnd end = run_program("slipstitch", {"list"}, {"SLIPSTITCH_SERVER=" + address_});
  EXPECT_EQ(end.exit_code, 0) << end.err;
  EXPECT_NE(end.err.find("No jobs at " + address_), std::string::npos) << end.err;
}

TEST_F(CliWithServer, ServeIsTheServer) {
  const ProgramEnd taken =
      slipstitch({"serve", "--grpc", "127.0.0.1:0", "--http", "none", "--data-dir", folder_ / "data"});
  EXPECT_EQ(taken.exit_code, 1) << taken.err;  // the data directory has a server
  Program second("slipstitch",
                 {"serve", "--grpc", "127.0.0.1:0", "--http", "127.0.0.1:0", "--data-dir", folder_ / "other"});
  wait_until([&] { return second.out().ends_with("\n") || !second.running(); });
  EXPECT_TRUE(second.out().starts_with("slipstitchd ready grpc=127.0.0.1:")) << second.out();
  EXPECT_NE(second.out().find(" http=127.0.0.1:"), std::string::npos) << second.out();
  second.send(SIGTERM);
  EXPECT_EQ(second.wait().exit_code, 0);
}

}  // namespace
}  // namespace slipstitch::test
