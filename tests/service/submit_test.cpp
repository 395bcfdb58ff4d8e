// SPDX-License-Identifier: MIT
#include <signal.h>

#include <thread>

#include "service_fixture.h"

namespace slipstitch::test {
namespace {

class SubmitTest : public ServiceTest {
 protected:
  void SetUp() override { start_server(); }
};

TEST_F(SubmitTest, RunsASceneToItsEnd) {
  const v1::SimJob created = must_create(swing(5, 1.0, 30.0, 1e-2), "r1");
  EXPECT_TRUE(created.name().starts_with("simJobs/")) << created.name();
  EXPECT_EQ(created.scene_name(), "swing");
  EXPECT_EQ(created.request_id(), "r1");
  EXPECT_GT(created.threads(), 0U);
  EXPECT_EQ(created.spec_hash().size(), 64U);
  EXPECT_GT(created.create_time().seconds(), 0);
  const std::vector<v1::SimJob> snapshots = watch(created.name());
  std::uint64_t revision = 0;
  for (const v1::SimJob& job : snapshots) {
    EXPECT_GT(job.revision(), revision);
    revision = job.revision();
  }
  const v1::SimJob& ended = snapshots.back();
  EXPECT_EQ(ended.state(), v1::SimJob::SUCCEEDED) << ended.DebugString();
  EXPECT_FALSE(ended.has_error());
  EXPECT_EQ(ended.progress().frames(), 31U);
  EXPECT_GT(ended.progress().wall_by_phase_s().at("assembly"), 0.0);
  EXPECT_NE(ended.summary_json().find("\"newton_iterations\""), std::string::npos);
  EXPECT_GE(ended.end_time().seconds(), ended.create_time().seconds());
  EXPECT_EQ(watch(created.name()).size(), 1U) << "an ended job is told once";
}

TEST_F(SubmitTest, WorksWithoutARequestId) {
  EXPECT_NE(must_create(swing(3, 0.1, 10.0, 1e-2)).name(), must_create(swing(3, 0.1, 10.0, 1e-2)).name());
}

TEST_F(SubmitTest, RunsWithinABudget) {
  v1::Scene scene = swing(3, 0.1, 10.0, 1e-2);
  scene.mutable_accuracy()->set_budget_s(0.5);
  const v1::SimJob ended = wait_for_end(must_create(scene).name());
  EXPECT_EQ(ended.state(), v1::SimJob::SUCCEEDED) << ended.error().message();
  EXPECT_EQ(ended.progress().budget_s(), 0.5);
  EXPECT_NE(ended.summary_json().find("\"same_tolerance_m\""), std::string::npos) << ended.summary_json();
}

TEST_F(SubmitTest, ValidatesWithoutStoring) {
  v1::CreateSimJobRequest request;
  *request.mutable_spec()->mutable_scene() = swing(3, 0.1, 10.0, 1e-2);
  request.mutable_spec()->mutable_simulate();
  request.set_validate_only(true);
  grpc::ClientContext context;
  v1::SimJob job;
  EXPECT_TRUE(jobs_->CreateSimJob(&context, request, &job).ok());
  EXPECT_EQ(job.name(), "");
  EXPECT_TRUE(list_names().empty());
  ASSERT_TRUE(job.has_prediction());
  EXPECT_GT(job.prediction().unknowns(), 0U);
  EXPECT_GT(job.prediction().memory_bytes(), 1'000'000U);
  EXPECT_GE(job.prediction().as_it_is().steps(), 10U);
  EXPECT_GT(job.prediction().as_it_is().wall_s(), 0.0);
  EXPECT_NE(job.prediction().as_it_is().basis(), v1::PredictedRun::BASIS_UNSPECIFIED);
  ASSERT_EQ(job.prediction().to_tolerance_size(), 3);
  EXPECT_EQ(job.prediction().to_tolerance(1).tolerance_m(), 1e-4);
  EXPECT_FALSE(must_create(swing(3, 0.1, 10.0, 1e-2)).has_prediction());
}

TEST_F(SubmitTest, PredictsNoStudies) {
  v1::CreateSimJobRequest request;
  *request.mutable_spec()->mutable_scene() = swing(3, 0.1, 10.0, 1e-2);
  request.mutable_spec()->mutable_study();
  request.set_validate_only(true);
  grpc::ClientContext context;
  v1::SimJob job;
  EXPECT_TRUE(jobs_->CreateSimJob(&context, request, &job).ok());
  EXPECT_FALSE(job.has_prediction());
}

TEST_F(SubmitTest, CancelsARunningJobAndKeepsItsFrames) {
  const std::string name = must_create(endless_swing()).name();
  wait_for_frames(name, 2);
  ASSERT_TRUE(cancel(name).ok());
  const v1::SimJob ended = wait_for_end(name);
  EXPECT_EQ(ended.state(), v1::SimJob::CANCELLED);
  EXPECT_TRUE(ended.cancel_requested());
  EXPECT_TRUE(cancel(name).ok()) << "repeating is harmless";
  const Received received = stream_all(name);
  EXPECT_GE(received.frames.size(), 2U);
  EXPECT_EQ(received.frames.rbegin()->first + 1, received.frames.size()) << "without gaps";
  EXPECT_EQ(received.end->state(), v1::SimJob::CANCELLED);
}

TEST_F(SubmitTest, CancelsAQueuedJob) {
  const std::string running = must_create(endless_swing()).name();
  wait_for_frames(running, 1);
  const std::string queued = must_create(endless_swing()).name();
  ASSERT_TRUE(cancel(queued).ok());
  EXPECT_EQ(wait_for_end(queued).state(), v1::SimJob::CANCELLED);
  EXPECT_EQ(get(running).state(), v1::SimJob::RUNNING);
}

TEST_F(SubmitTest, DeletesAnEndedJob) {
  const std::string name = must_create(swing(3, 0.1, 10.0, 1e-2), "r1").name();
  wait_for_end(name);
  const std::filesystem::path folder = folder_of(name).path;
  ASSERT_TRUE(std::filesystem::exists(folder));
  ASSERT_TRUE(remove(name).ok());
  EXPECT_FALSE(std::filesystem::exists(folder));
  EXPECT_TRUE(list_names().empty());
}

TEST_F(SubmitTest, GoesOnWithoutAnyClient) {
  const std::string name = must_create(endless_swing()).name();
  {
    v1::StreamFramesRequest request = frames_request(name);
    request.set_follow(true);
    grpc::ClientContext context;
    const auto reader = frames_->StreamFrames(&context, request);
    v1::StreamFramesResponse message;
    ASSERT_TRUE(reader->Read(&message));
    context.TryCancel();
    EXPECT_EQ(reader->Finish().error_code(), grpc::StatusCode::CANCELLED);
  }
  channel_.reset();
  const std::uint32_t frames = get(name).progress().frames();
  wait_for_frames(name, frames + 2);
}

TEST_F(SubmitTest, ADeadlineEndsTheStreamNotTheJob) {
  const std::string name = must_create(endless_swing()).name();
  wait_for_frames(name, 1);
  v1::WatchSimJobRequest request;
  request.set_name(name);
  grpc::ClientContext context;
  context.set_deadline(std::chrono::system_clock::now() + std::chrono::milliseconds(300));
  const auto reader = jobs_->WatchSimJob(&context, request);
  for (v1::SimJob job; reader->Read(&job);) {
  }
  EXPECT_EQ(reader->Finish().error_code(), grpc::StatusCode::DEADLINE_EXCEEDED);
  EXPECT_EQ(get(name).state(), v1::SimJob::RUNNING);
}

TEST_F(SubmitTest, OutlivesAKilledWorker) {
  const std::string name = must_create(endless_swing()).name();
  wait_for_frames(name, 2);
  ASSERT_EQ(::kill(static_cast<pid_t>(worker_of(name).pid), SIGKILL), 0);
  const v1::SimJob ended = wait_for_end(name);
  EXPECT_EQ(ended.state(), v1::SimJob::FAILED);
  const Details details = details_of(ended.error());
  ASSERT_EQ(details.infos.size(), 1U);
  EXPECT_EQ(details.infos[0].reason(), "WORKER_CRASHED");
  EXPECT_NE(ended.error().message().find("SIGKILL"), std::string::npos) << ended.error().message();
  EXPECT_NE(details.infos[0].metadata().at("log_tail").find("running " + name), std::string::npos);
  const Received received = stream_all(name);
  EXPECT_GE(received.frames.size(), 2U);
  EXPECT_EQ(received.end->state(), v1::SimJob::FAILED);
  EXPECT_EQ(wait_for_end(must_create(swing(3, 0.1, 10.0, 1e-2)).name()).state(), v1::SimJob::SUCCEEDED);
}

TEST_F(SubmitTest, HandsOutTheSceneAsRun) {
  const std::string name = must_create(swing(3, 0.1, 10.0, 1e-2)).name();
  wait_for_end(name);
  v1::ListArtefactsRequest list;
  list.set_name(name);
  grpc::ClientContext list_context;
  v1::ListArtefactsResponse artefacts;
  ASSERT_TRUE(jobs_->ListArtefacts(&list_context, list, &artefacts).ok());
  ASSERT_EQ(artefacts.artefacts_size(), 4);
  EXPECT_EQ(artefacts.artefacts(0).name(), name + "/artefacts/history.csv");
  EXPECT_EQ(artefacts.artefacts(1).name(), name + "/artefacts/reactions.csv");  // of the scene's handles
  EXPECT_EQ(artefacts.artefacts(2).name(), name + "/artefacts/scene.json");
  EXPECT_EQ(artefacts.artefacts(3).name(), name + "/artefacts/summary.json");
  v1::GetArtefactRequest get_request;
  get_request.set_name(artefacts.artefacts(2).name());
  grpc::ClientContext context;
  const auto reader = jobs_->GetArtefact(&context, get_request);
  std::string data;
  std::uint64_t total = 0;
  for (v1::ArtefactChunk chunk; reader->Read(&chunk); total = chunk.total_bytes()) {
    EXPECT_EQ(chunk.offset(), data.size());
    data += chunk.data();
  }
  EXPECT_TRUE(reader->Finish().ok());
  EXPECT_EQ(data.size(), total);
  EXPECT_EQ(data, *read_scene(folder_of(name)));
}

}  // namespace
}  // namespace slipstitch::test
