// SPDX-License-Identifier: MIT
#include <signal.h>

#include <future>

#include "raw_message.h"
#include "service_fixture.h"

namespace slipstitch::test {
namespace {

class StopTest : public ServiceTest {
 protected:
  // Reads `reader` to its end behind the first message; `started` is set when that has come.
  template <class Reader, class Message>
  static grpc::Status drain(Reader& reader, Message message, std::promise<void>& started) {
    EXPECT_TRUE(reader.Read(&message));
    started.set_value();
    while (reader.Read(&message)) {
    }
    return reader.Finish();
  }
};

TEST_F(StopTest, SigtermEndsStreamsWithAReasonAndLeavesWorkersRunning) {
  start_server();
  const std::string name = must_create(endless_swing()).name();
  wait_for_frames(name, 1);
  const WorkerInfo worker = worker_of(name);
  std::promise<void> watching, streaming;
  auto watched = std::async(std::launch::async, [&] {
    v1::WatchSimJobRequest request;
    request.set_name(name);
    grpc::ClientContext context;
    return drain(*jobs_->WatchSimJob(&context, request), v1::SimJob(), watching);
  });
  auto streamed = std::async(std::launch::async, [&] {
    v1::StreamFramesRequest request = frames_request(name);
    request.set_follow(true);
    grpc::ClientContext context;
    return drain(*frames_->StreamFrames(&context, request), v1::StreamFramesResponse(), streaming);
  });
  watching.get_future().wait();
  streaming.get_future().wait();
  server_->signal(SIGTERM);
  expect_error(watched.get(), grpc::StatusCode::UNAVAILABLE, "SERVER_STOPPING");
  expect_error(streamed.get(), grpc::StatusCode::UNAVAILABLE, "SERVER_STOPPING");
  EXPECT_EQ(server_->wait(), 0);
  EXPECT_TRUE(worker_alive(worker));

  start_server();
  EXPECT_EQ(get(name).state(), v1::SimJob::RUNNING);
  EXPECT_EQ(worker_of(name).pid, worker.pid);
}

TEST_F(StopTest, SigtermIsToldAsNotServing) {
  start_server();
  grpc::ClientContext context;
  const auto reader = watch_health(*channel_, context);
  grpc::ByteBuffer status;
  ASSERT_TRUE(reader->Read(&status));
  EXPECT_EQ(text_of(status), kServing);
  server_->signal(SIGTERM);
  ASSERT_TRUE(reader->Read(&status));
  EXPECT_EQ(text_of(status), kNotServing);
  context.TryCancel();
  EXPECT_EQ(server_->wait(), 0);
}

TEST_F(StopTest, StopJobsEndsWorkersToo) {
  start_server({"--stop-jobs"});
  const std::string running = must_create(endless_swing()).name();
  const std::string queued = must_create(swing(3, 0.1, 10.0, 1e-2)).name();
  wait_for_frames(running, 1);
  const WorkerInfo worker = worker_of(running);
  server_->signal(SIGTERM);
  EXPECT_EQ(server_->wait(), 0);
  EXPECT_FALSE(worker_alive(worker));
  EXPECT_EQ(read_summary(folder_of(running))->status, RunStatus::cancelled);
  start_server();
  EXPECT_EQ(get(running).state(), v1::SimJob::CANCELLED);
  EXPECT_EQ(wait_for_end(queued).state(), v1::SimJob::SUCCEEDED) << "stayed queued, then ran";
}

TEST_F(StopTest, AnInterruptIsATermination) {
  start_server();
  server_->signal(SIGINT);
  EXPECT_EQ(server_->wait(), 0);
}

}  // namespace
}  // namespace slipstitch::test
