// SPDX-License-Identifier: MIT
// That what a prediction takes is bounded, and that nobody is held up by one.
#include <signal.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <thread>

#include "rest_fixture.h"

namespace slipstitch::test {
namespace {

v1::CreateSimJobRequest question(const v1::Scene& scene) {
  v1::CreateSimJobRequest request;
  *request.mutable_spec()->mutable_scene() = scene;
  request.mutable_spec()->mutable_simulate();
  request.set_validate_only(true);
  return request;
}

// A yarn of that many points within 2 cm.
v1::Scene crowded_yarn(int points) {
  v1::Scene scene = swing(points, 0.1, 10.0, 1e-3);
  auto& numbers = *scene.mutable_yarns(0)->mutable_points_m();
  for (int i = 0; i < points; ++i) {
    numbers.Set(3 * i, 0.01 * std::sin(1.1 * i));
    numbers.Set(3 * i + 1, 0.01 * std::sin(1.7 * i));
    numbers.Set(3 * i + 2, 0.01 * std::sin(2.3 * i));
  }
  scene.mutable_effects()->mutable_self_collision();
  return scene;
}

class PredictionTest : public RestTest {
 protected:
  /// With a worker that never comes to an end.
  void start_with_sleeper() {
    start_with_worker("echo $$ > " + pid_file().string() + ".new && mv " + pid_file().string() + ".new " +
                      pid_file().string() + "\nexec sleep 100000\n");
  }

  void start_with_worker(const std::string& script, const std::string& timeout_s = "86400") {
    const std::filesystem::path worker = folder_ / "worker.sh";
    std::ofstream(worker) << "#!/bin/sh\n" << script;
    std::filesystem::permissions(worker, std::filesystem::perms::owner_all);
    start_rest({"--worker", worker.string(), "--prediction-timeout", timeout_s});
  }

  std::filesystem::path pid_file() const { return folder_ / "pid"; }

  pid_t wait_for_sleeper() const {
    pid_t pid = 0;
    while (!(std::ifstream(pid_file()) >> pid)) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return pid;
  }

  static void wait_until_gone(pid_t pid) {
    while (::kill(pid, 0) == 0) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }

  std::string body() {
    return Json({{"spec", Json::parse(create_body(swing(3, 0.1, 10.0, 1e-2))).at("spec")}, {"validate_only", true}})
        .dump();
  }
};

TEST_F(PredictionTest, EndsWhenItsHttpClientLeaves) {
  start_with_sleeper();
  auto connection = std::make_unique<HttpConnection>(http());
  connection->send_request("POST", "/v1/simJobs", {{"content-type", "application/json"}}, body());
  const pid_t pid = wait_for_sleeper();
  connection.reset();
  wait_until_gone(pid);
  EXPECT_EQ(call("GET", "/healthz").status, 200U);
}

TEST_F(PredictionTest, EndsWhenItsGrpcClientLeaves) {
  start_with_sleeper();
  grpc::ClientContext context;
  grpc::Status status;
  std::thread asking([&] {
    v1::SimJob job;
    status = jobs_->CreateSimJob(&context, question(swing(3, 0.1, 10.0, 1e-2)), &job);
  });
  const pid_t pid = wait_for_sleeper();
  context.TryCancel();
  asking.join();
  EXPECT_EQ(status.error_code(), grpc::StatusCode::CANCELLED);
  wait_until_gone(pid);
}

TEST_F(PredictionTest, EndsWithTheServerWhichAnswersWithout) {
  start_with_sleeper();
  HttpConnection connection(http());
  connection.send_request("POST", "/v1/simJobs", {{"content-type", "application/json"}}, body());
  const pid_t pid = wait_for_sleeper();
  server_->signal(SIGTERM);
  const HttpAnswer answer = connection.read_answer();
  EXPECT_EQ(answer.status, 200U);
  EXPECT_FALSE(Json::parse(answer.body).contains("prediction"));
  EXPECT_EQ(server_->wait(), 0);
  EXPECT_NE(::kill(pid, 0), 0);
}

TEST_F(PredictionTest, IsGivenUpAfterAWhile) {
  start_with_worker("exec sleep 100000\n", "0.1");
  const HttpAnswer answer = post_json("/v1/simJobs", body());
  EXPECT_EQ(answer.status, 200U);
  EXPECT_FALSE(Json::parse(answer.body).contains("prediction"));
}

TEST_F(PredictionTest, IsInEveryAnswerOfAConnection) {
  start_rest();
  HttpConnection connection(http());
  for (int i = 0; i < 3; ++i) {
    connection.send_request("POST", "/v1/simJobs", {{"content-type", "application/json"}}, body());
    EXPECT_TRUE(Json::parse(connection.read_answer().body).contains("prediction")) << i;
    connection.send_request("GET", "/healthz");
    EXPECT_EQ(connection.read_answer().status, 200U);
  }
}

TEST_F(PredictionTest, IsLeftOutWhereTheWorkerFailsOrTalksNonsense) {
  for (const char* script : {"exit 3\n", "echo nonsense\n", "kill -9 $$\n"}) {
    start_with_worker(script);
    const HttpAnswer answer = post_json("/v1/simJobs", body());
    EXPECT_EQ(answer.status, 200U) << script;
    EXPECT_FALSE(Json::parse(answer.body).contains("prediction")) << script;
    kill_server();
  }
}

// As many contacts as there are points squared: gigabytes and minutes, if there were no limit.
TEST_F(PredictionTest, IsGivenUpBeyondItsLimits) {
  const std::filesystem::path scene = folder_ / "scene";
  std::ofstream(scene, std::ios::binary) << crowded_yarn(9'999).SerializeAsString();
  const std::string worker = SLIPSTITCH_BIN_DIR "/slipstitch-worker";
  const Finished predicted = run_program({"/bin/sh", "-c", worker + " --predict < " + scene.string()});
  EXPECT_NE(predicted.code, 0);
  EXPECT_EQ(predicted.out, "");
}

TEST_F(PredictionTest, IsThereWhereYarnMayMeetYarn) {
  start_rest();
  grpc::ClientContext context;
  v1::SimJob job;
  EXPECT_TRUE(jobs_->CreateSimJob(&context, question(crowded_yarn(20)), &job).ok());
  EXPECT_TRUE(job.has_prediction());
}

}  // namespace
}  // namespace slipstitch::test
