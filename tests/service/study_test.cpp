// SPDX-License-Identifier: MIT
#include <signal.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <thread>

#include "service_fixture.h"

namespace slipstitch::test {
namespace {

class StudyJobTest : public ServiceTest {
 protected:
  void SetUp() override { start_server(); }
};

v1::Scene short_swing() { return swing(5, 0.1, 30.0, 1e-2); }
v1::Scene long_swing() { return swing(20, 60.0, 30.0, 1e-2); }  // nobody waits for its study to end

const std::vector<std::string> kReport{"error-newton.svg", "error-time.svg", "study.csv", "study.html", "study.md"};

bool has_report(const std::vector<std::string>& artefacts) {
  return std::any_of(kReport.begin(), kReport.end(), [&](const std::string& file) {
    return std::find(artefacts.begin(), artefacts.end(), file) != artefacts.end();
  });
}

TEST_F(StudyJobTest, EndsWithAReport) {
  const v1::SimJob created = must_create_study(short_swing(), 600.0);
  EXPECT_TRUE(created.has_study());
  EXPECT_TRUE(created.study().quick());
  EXPECT_EQ(created.study().budget_s(), 600.0);
  const std::string name = created.name();
  double share = 0.0;
  const std::vector<v1::SimJob> snapshots = watch(name);
  for (const v1::SimJob& job : snapshots) {
    EXPECT_GE(job.progress().share_done(), share);
    share = job.progress().share_done();
    EXPECT_LE(job.progress().eta_s(), 600.0) << "at most its budget";
    EXPECT_TRUE(share < 1.0 || !job.progress().has_eta_s()) << "all done is done";
  }
  const v1::SimJob& ended = snapshots.back();
  ASSERT_EQ(ended.state(), v1::SimJob::SUCCEEDED) << ended.DebugString();
  EXPECT_EQ(ended.progress().doing(), "");
  EXPECT_EQ(share, 1.0);
  EXPECT_FALSE(ended.progress().has_eta_s());
  EXPECT_EQ(ended.progress().num_frames(), 0U);

  std::vector<std::string> expected = kReport;
  expected.insert(expected.begin() + 2, "scene.json");
  expected.emplace_back("summary.json");
  EXPECT_EQ(artefacts_of(name), expected) << "and none of the runs";
  const std::string document = read_artefact(name, "study.md");
  EXPECT_NE(document.find("Made by a server as " + name +
                          "; `slipstitch submit scene.json --study --quick --budget 600 --threads 1` makes another"),
            std::string::npos)
      << document;
  EXPECT_TRUE(read_artefact(name, "study.html").starts_with("<!doctype html>"));
  EXPECT_TRUE(read_artefact(name, "error-time.svg").starts_with("<svg "));
  EXPECT_EQ(read_artefact(name, "summary.json"), ended.summary_json());
  const auto summary = nlohmann::json::parse(ended.summary_json());
  EXPECT_EQ(summary["status"], "succeeded");
  EXPECT_TRUE(summary["newton_iterations"].is_null()) << "not measured";
  EXPECT_EQ(summary["study"]["finished"], true);
  EXPECT_EQ(summary["study"]["rungs"].size(), 24U);
  EXPECT_GT(summary["study"]["reference"]["error_m"], 0.0);
}

TEST_F(StudyJobTest, HasNoFrames) {
  const std::string name = must_create_study(short_swing(), 1e-9).name();
  for (const bool follow : {false, true}) {
    v1::StreamFramesRequest request = frames_request(name);
    request.set_follow(follow);
    const Received received = stream(request);
    expect_error(received.status, grpc::StatusCode::FAILED_PRECONDITION, "NO_FRAMES");
    EXPECT_FALSE(received.end);
  }
}

TEST_F(StudyJobTest, ThatHasNoTimeFailsAndSaysSo) {
  const v1::SimJob ended = wait_for_end(must_create_study(short_swing(), 1e-9).name());
  EXPECT_EQ(ended.state(), v1::SimJob::FAILED);
  EXPECT_EQ(details_of(ended.error()).infos.at(0).reason(), "SIMULATION_FAILED");
  EXPECT_NE(ended.error().message().find("no run of it fits into the time"), std::string::npos)
      << ended.error().message();
}

TEST_F(StudyJobTest, StopsSoonWhenCancelledAndKeepsItsRuns) {
  const std::string name = must_create_study(long_swing()).name();
  EXPECT_EQ(wait_for_runs(name, 2).state(), v1::SimJob::RUNNING);
  while (get(name).progress().doing().empty()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  ASSERT_TRUE(cancel(name).ok());
  const v1::SimJob ended = wait_for_end(name);
  EXPECT_EQ(ended.state(), v1::SimJob::CANCELLED);
  EXPECT_FALSE(ended.has_error());
  EXPECT_GE(runs_of(name).size(), 2U);
  EXPECT_EQ(artefacts_of(name), (std::vector<std::string>{"scene.json", "summary.json"})) << "no report";
  EXPECT_EQ(nlohmann::json::parse(ended.summary_json())["study"]["finished"], false);
  ASSERT_TRUE(remove(name).ok());
  EXPECT_FALSE(std::filesystem::exists(folder_of(name).path));
}

TEST_F(StudyJobTest, GoesOnWithoutTheServerAndFailsWithItsWorker) {
  const std::string name = must_create_study(long_swing()).name();
  wait_for_runs(name, 1);
  const WorkerInfo worker = worker_of(name);
  kill_server();
  start_server();
  EXPECT_EQ(get(name).state(), v1::SimJob::RUNNING);
  EXPECT_TRUE(get(name).has_study());
  EXPECT_EQ(worker_of(name).pid, worker.pid);
  wait_for_runs(name, runs_of(name).size() + 1);
  kill_server();
  ::kill(static_cast<pid_t>(worker.pid), SIGKILL);
  while (worker_alive(worker)) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  start_server();
  const v1::SimJob ended = wait_for_end(name);
  EXPECT_EQ(ended.state(), v1::SimJob::FAILED);
  EXPECT_EQ(details_of(ended.error()).infos.at(0).reason(), "WORKER_LOST");
  EXPECT_TRUE(ended.has_study());
  EXPECT_FALSE(has_report(artefacts_of(name)));
}

TEST_F(StudyJobTest, RefusesBudgetsThatAreNone) {
  for (const double budget : {-1.0, std::numeric_limits<double>::infinity(), std::nan("")}) {
    v1::SimJob job;
    const grpc::Status refused = create_study(short_swing(), budget, job);
    EXPECT_EQ(refused.error_code(), grpc::StatusCode::INVALID_ARGUMENT) << budget;
    const Details details = details_of(refused);
    ASSERT_EQ(details.bad_requests.size(), 1U);
    ASSERT_EQ(details.bad_requests[0].field_violations_size(), 1);
    EXPECT_EQ(details.bad_requests[0].field_violations(0).field(), "spec.study.budget_s");
  }
  EXPECT_TRUE(list_names().empty());
}

TEST_F(StudyJobTest, RefusesFieldsThatItDoesNotKnow) {
  v1::CreateSimJobRequest request;
  *request.mutable_spec()->mutable_scene() = short_swing();
  v1::Study& study = *request.mutable_spec()->mutable_study();
  study.GetReflection()->MutableUnknownFields(&study)->AddVarint(99, 1);
  grpc::ClientContext context;
  v1::SimJob job;
  const Details details = details_of(jobs_->CreateSimJob(&context, request, &job));
  ASSERT_EQ(details.bad_requests.size(), 1U);
  EXPECT_EQ(details.bad_requests[0].field_violations(0).field(), "spec.study");
}

}  // namespace
}  // namespace slipstitch::test
