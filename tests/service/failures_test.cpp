// SPDX-License-Identifier: MIT
// Errors that are nobody's bad input: runs that fail, storage that fails, clients that stall, a server that stops.
#include <signal.h>

#include <thread>

#include "raw_message.h"
#include "service_fixture.h"

namespace slipstitch::test {
namespace {

// A header and a frame of 1.6 MB each and a scene.json of more: gRPC holds none for a client that does not read.
v1::Scene large_scene() { return swing(50'000, 0.0, 100.0, 1e-2); }

v1::Scene scene_that_cannot_converge() {
  v1::Scene scene = swing(5, 1.0, 30.0, 1e-2);
  scene.mutable_fixed()->set_max_newton_iterations(1);
  scene.mutable_fixed()->set_smallest_step_s(1e-3);
  scene.mutable_fixed()->set_velocity_tolerance_m_per_s(1e-300);
  return scene;
}

class FailuresTest : public ServiceTest {
 protected:
  void expect_failed(const std::string& name, const std::string& reason) {
    const v1::SimJob job = wait_for_end(name);
    EXPECT_EQ(job.state(), v1::SimJob::FAILED);
    EXPECT_EQ(job.error().code(), grpc::StatusCode::INTERNAL);
    const Details details = details_of(job.error());
    ASSERT_EQ(details.infos.size(), 1U);
    EXPECT_EQ(details.infos[0].reason(), reason) << job.error().message();
    EXPECT_EQ(details.infos[0].domain(), "slipstitch");
  }

  // tmp/ is where jobs are made and where removed ones go: a file in its place fails both, for root too.
  void break_storage() {
    std::filesystem::remove(folder_ / "data/tmp");
    write_bytes(folder_ / "data/tmp", "");
  }
  void mend_storage() {
    std::filesystem::remove(folder_ / "data/tmp");
    std::filesystem::create_directory(folder_ / "data/tmp");
  }

  std::unique_ptr<grpc::ClientReader<v1::StreamFramesResponse>> open_frames(grpc::ClientContext& context,
                                                                            const std::string& name) {
    return frames_->StreamFrames(&context, frames_request(name));
  }
  std::unique_ptr<grpc::ClientReader<v1::ArtefactChunk>> open_scene(grpc::ClientContext& context,
                                                                    const std::string& name) {
    v1::GetArtefactRequest request;
    request.set_name(name + "/artefacts/scene.json");
    return jobs_->GetArtefact(&context, request);
  }

  template <class Message>
  static grpc::Status drain(grpc::ClientReader<Message>& reader) {
    for (Message message; reader.Read(&message);) continue;
    return reader.Finish();
  }

  // Reads nothing for a while, longer each time: how soon the server sees that is up to the machine.
  template <class Open>
  static grpc::Status status_after_stall(const Open& open) {
    grpc::Status status;
    for (auto pause = std::chrono::milliseconds(250); status.ok() && pause < std::chrono::seconds(20); pause *= 2) {
      grpc::ClientContext context;
      const auto reader = open(context);
      std::this_thread::sleep_for(pause);
      status = drain(*reader);
    }
    return status;
  }
};

TEST_F(FailuresTest, ARunThatDoesNotConvergeFailsAndSaysWhy) {
  start_server();
  const std::string name = must_create(scene_that_cannot_converge()).name();
  expect_failed(name, "SIMULATION_FAILED");
  const std::string why = get(name).error().message();
  EXPECT_NE(why.find("too many Newton iterations"), std::string::npos) << why;
  const Finished watch = run_program({SLIPSTITCH_BIN_DIR "/slipstitch", "watch", name, "--server", server_->address()});
  EXPECT_EQ(watch.code, 1);
  EXPECT_NE(watch.err.find(name + " failed: " + why), std::string::npos) << watch.err;
  expect_error(cancel(name), grpc::StatusCode::FAILED_PRECONDITION, "JOB_ENDED");
}

TEST_F(FailuresTest, AJobThatCannotBeStoredIsNotAcknowledged) {
  start_server();
  break_storage();
  v1::SimJob job;
  expect_error(create(swing(3, 0.1, 10.0, 1e-2), "r1", job), grpc::StatusCode::INTERNAL, "STORAGE_FAILED");
  EXPECT_TRUE(list_names().empty());
  mend_storage();
  const std::string name = must_create(swing(3, 0.1, 10.0, 1e-2), "r1").name();
  EXPECT_EQ(wait_for_end(name).state(), v1::SimJob::SUCCEEDED) << "the request id was not used up";
  break_storage();
  expect_error(remove(name), grpc::StatusCode::INTERNAL, "STORAGE_FAILED");
  EXPECT_EQ(list_names(), std::vector<std::string>{name});
}

TEST_F(FailuresTest, ACancelThatCannotBeWrittenIsNotPromised) {
  start_server();
  const std::string name = must_create(endless_swing()).name();
  wait_for_frames(name, 1);
  std::filesystem::create_directory(folder_of(name).control());
  expect_error(cancel(name), grpc::StatusCode::INTERNAL, "STORAGE_FAILED");
  ASSERT_FALSE(get(name).cancel_requested());
  std::filesystem::remove(folder_of(name).control());
  ASSERT_TRUE(cancel(name).ok());
  EXPECT_EQ(wait_for_end(name).state(), v1::SimJob::CANCELLED);
}

TEST_F(FailuresTest, ASummaryThatCannotBeReadFailsTheJob) {
  start_server();
  const std::string name = must_create(swing(3, 0.1, 10.0, 1e-2)).name();
  EXPECT_EQ(wait_for_end(name).state(), v1::SimJob::SUCCEEDED);
  kill_server();
  write_bytes(folder_of(name).summary(), "{\"status\": \"succ");
  start_server();
  expect_failed(name, "STORAGE_FAILED");
}

TEST_F(FailuresTest, AClientThatDoesNotReadLosesItsStream) {
  start_server({"--stall-timeout", "0.1"});
  const std::string name = must_create(large_scene()).name();
  while (!has_summary(folder_of(name))) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  expect_error(status_after_stall([&](grpc::ClientContext& context) { return open_frames(context, name); }),
               grpc::StatusCode::ABORTED, "STREAM_STALLED");
  expect_error(status_after_stall([&](grpc::ClientContext& context) { return open_scene(context, name); }),
               grpc::StatusCode::ABORTED, "STREAM_STALLED");
}

// Two clients that do not read hold the server while it stops; it still answers. Metadata comes with the first message,
// and no room for that is ever given before it is read: from then on the stream is there.
TEST_F(FailuresTest, AStoppingServerTakesNoJobsAndSaysSo) {
  start_server({"--stop-grace", "3600"});
  const std::string name = must_create(large_scene()).name();
  wait_for_end(name);
  grpc::ClientContext frames_context, scene_context, health_context;
  const auto frames = open_frames(frames_context, name);
  const auto scene = open_scene(scene_context, name);
  const auto health = watch_health(*channel_, health_context);
  frames->WaitForInitialMetadata();
  scene->WaitForInitialMetadata();
  grpc::ByteBuffer serving;
  ASSERT_TRUE(health->Read(&serving));
  server_->signal(SIGTERM);
  ASSERT_TRUE(health->Read(&serving));
  EXPECT_EQ(text_of(serving), kNotServing);
  v1::SimJob job;
  grpc::Status created;
  while (created.ok()) created = create(swing(3, 0.1, 10.0, 1e-2), "", job);  // between the health and the stop
  expect_error(created, grpc::StatusCode::UNAVAILABLE, "SERVER_STOPPING");
  EXPECT_EQ(get(name).state(), v1::SimJob::SUCCEEDED) << "what only reads is answered";
  expect_error(drain(*frames), grpc::StatusCode::UNAVAILABLE, "SERVER_STOPPING");
  expect_error(drain(*scene), grpc::StatusCode::UNAVAILABLE, "SERVER_STOPPING");
  health_context.TryCancel();
  EXPECT_EQ(server_->wait(), 0);
}

}  // namespace
}  // namespace slipstitch::test
