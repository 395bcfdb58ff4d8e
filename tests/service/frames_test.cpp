// SPDX-License-Identifier: MIT
#include <future>
#include <thread>

#include "run_dir/frame_log.h"
#include "service_fixture.h"

namespace slipstitch::test {
namespace {

class FramesTest : public ServiceTest {
 protected:
  void SetUp() override { start_server(); }

  std::string finished_swing() {
    const std::string name = must_create(swing(5, 1.0, 30.0, 1e-2)).name();
    EXPECT_EQ(wait_for_end(name).state(), v1::SimJob::SUCCEEDED);
    return name;
  }
};

TEST_F(FramesTest, StreamsExactlyWhatTheLogHolds) {
  const std::string name = finished_swing();
  const Received received = stream_all(name);
  FrameLogReader log(folder_of(name).frames());
  ASSERT_EQ(log.poll(), LogState::ended);
  ASSERT_EQ(received.frames.size(), 31U);
  ASSERT_EQ(log.num_frames(), 31);
  for (const auto& [index, frame] : received.frames) {
    const Result<Frame> logged = log.read_frame(static_cast<int>(index));
    ASSERT_TRUE(logged) << logged.error;
    EXPECT_EQ(frame.t, logged->t);
    EXPECT_EQ(frame.q, std::vector<double>(logged->q.begin(), logged->q.end()));
  }
  ASSERT_TRUE(received.header);
  EXPECT_EQ(received.header->topology().num_nodes(), 5);
  EXPECT_EQ(received.header->num_frames(), 31U);
  EXPECT_EQ(received.end->frames_sent(), 31U);
  EXPECT_EQ(received.end->frame_count(), 31U);
  EXPECT_EQ(received.end->state(), v1::SimJob::SUCCEEDED);
  EXPECT_EQ(received.end->reason(), "END_OF_JOB");
}

TEST_F(FramesTest, ResumesInTheMiddle) {
  const std::string name = finished_swing();
  const Received all = stream_all(name);
  const Received rest = stream(frames_request(name, 17));
  ASSERT_TRUE(rest.end);
  EXPECT_TRUE(rest.header);
  EXPECT_EQ(rest.frames, (std::map(all.frames.find(17), all.frames.end())));
  EXPECT_EQ(rest.end->frames_sent(), 14U);
}

TEST_F(FramesTest, SkipsByStrideAndStopsAtTheEndIndex) {
  const std::string name = finished_swing();
  const Received all = stream_all(name);
  v1::StreamFramesRequest request = frames_request(name, 3, 7);
  request.set_end_index(24);
  const Received some = stream(request);
  std::map<std::uint32_t, ReceivedFrame> expected;
  for (const std::uint32_t index : {3U, 10U, 17U}) expected[index] = all.frames.at(index);
  EXPECT_EQ(some.frames, expected);
  ASSERT_TRUE(some.end);
  EXPECT_EQ(some.end->reason(), "END_OF_RANGE");
  const Received none = stream(frames_request(name, 31));
  EXPECT_TRUE(none.frames.empty());
  ASSERT_TRUE(none.end);
  EXPECT_EQ(none.end->reason(), "END_OF_JOB");
}

TEST_F(FramesTest, FollowsARunningJobToItsEndForTwoClients) {
  const std::string name = must_create(swing(5, 20.0, 30.0, 1e-3)).name();
  v1::StreamFramesRequest request = frames_request(name);
  request.set_follow(true);
  auto second = std::async(std::launch::async, [&] { return stream(request); });
  const Received first = stream(request);
  EXPECT_TRUE(first.status.ok()) << first.status.error_message();
  ASSERT_TRUE(first.end);
  EXPECT_EQ(first.end->reason(), "END_OF_JOB");
  EXPECT_EQ(first.end->state(), v1::SimJob::SUCCEEDED);
  EXPECT_EQ(first.frames.size(), 601U);
  EXPECT_EQ(second.get().frames, first.frames);
}

TEST_F(FramesTest, EndsAtTheLastFrameThereIsWithoutFollow) {
  const std::string name = must_create(endless_swing()).name();
  wait_for_frames(name, 3);
  const Received received = stream(frames_request(name));
  ASSERT_TRUE(received.end);
  EXPECT_GE(received.frames.size(), 3U);
  EXPECT_EQ(received.end->reason(), "NO_MORE_YET");
  EXPECT_EQ(received.end->state(), v1::SimJob::RUNNING);
}

TEST_F(FramesTest, SaysThatAQueuedJobHasNothingYet) {
  must_create(endless_swing());
  const std::string queued = must_create(endless_swing()).name();
  const Received received = stream(frames_request(queued));
  ASSERT_TRUE(received.end);
  EXPECT_FALSE(received.header);
  EXPECT_EQ(received.end->reason(), "NO_MORE_YET");
  EXPECT_EQ(received.end->state(), v1::SimJob::QUEUED);
}

TEST_F(FramesTest, CutsFramesAboveAMebibyte) {
  // 50,000 points: 3 x 50,000 positions and 50,000 arc lengths, 1.6 MB a frame.
  v1::Scene scene = swing(50'000, 0.01, 100.0, 1e-2);
  scene.clear_handles();  // falls
  const std::string name = must_create(scene).name();
  const v1::SimJob ended = wait_for_end(name);
  ASSERT_EQ(ended.state(), v1::SimJob::SUCCEEDED) << ended.error().message();
  const Received received = stream_all(name);
  ASSERT_EQ(received.frames.size(), 2U);
  EXPECT_EQ(received.frames.at(0).q.size(), 200'000U);
  EXPECT_EQ(received.header->topology().num_nodes(), 50'000);
  EXPECT_GT(received.header->ByteSizeLong(), 512U * 1024U);
  EXPECT_LE(received.largest_message, 1U << 20);
}

TEST_F(FramesTest, ReportsADamagedLog) {
  const std::string name = finished_swing();
  std::string bytes = read_bytes(folder_of(name).frames());
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  write_bytes(folder_of(name).frames(), bytes);
  const Received received = stream(frames_request(name));
  expect_error(received.status, grpc::StatusCode::DATA_LOSS, "STORAGE_FAILED");
  EXPECT_FALSE(received.end);
}

}  // namespace
}  // namespace slipstitch::test
