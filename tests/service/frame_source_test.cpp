// SPDX-License-Identifier: MIT
#include "api/frame_source.h"

#include <gtest/gtest.h>

#include "support/sample_run.h"

namespace slipstitch {
namespace {

class FrameSourceTest : public ::testing::Test {
 protected:
  FrameLogWriter new_log() { return std::move(*FrameLogWriter::create(dir_.frames())); }

  void append(FrameLogWriter& log, int first, int count) {
    for (int i = first; i < first + count; ++i) EXPECT_EQ(log.append_frame(test::sample_frame(header_, i)), "");
  }

  const test::TemporaryFolder folder_;
  const RunDir dir_{folder_.path()};
  const FrameHeader header_ = test::sample_header();
};

v1::StreamFramesRequest follow() {
  v1::StreamFramesRequest request;
  request.set_follow(true);
  return request;
}

TEST_F(FrameSourceTest, WaitsForWhatIsNotThereYet) {
  FrameSource source(dir_, follow());
  EXPECT_FALSE(source.next(jobs::JobState::queued));
  FrameLogWriter log = new_log();
  EXPECT_FALSE(source.next(jobs::JobState::running));
  ASSERT_EQ(log.append_header(header_), "");
  EXPECT_TRUE(source.next(jobs::JobState::running)->has_header());
  EXPECT_FALSE(source.next(jobs::JobState::running));
  append(log, 0, 2);
  EXPECT_EQ(source.next(jobs::JobState::running)->frame().index(), 0U);
  EXPECT_EQ(source.next(jobs::JobState::running)->frame().index(), 1U);
  EXPECT_FALSE(source.next(jobs::JobState::running));
  EXPECT_FALSE(source.finished());
}

// The last frames may come between the end of the job and the look at the log.
TEST_F(FrameSourceTest, SendsEverythingBeforeTheEnd) {
  FrameLogWriter log = new_log();
  ASSERT_EQ(log.append_header(header_), "");
  FrameSource source(dir_, follow());
  EXPECT_TRUE(source.next(jobs::JobState::running)->has_header());
  append(log, 0, 1);
  EXPECT_TRUE(source.next(jobs::JobState::succeeded)->has_frame());
  const auto end = source.next(jobs::JobState::succeeded);
  ASSERT_TRUE(end && end->has_end());
  EXPECT_EQ(end->end().frame_count(), 1U);
  EXPECT_TRUE(source.finished());
  EXPECT_FALSE(source.next(jobs::JobState::succeeded));
}

TEST_F(FrameSourceTest, EndsWithoutHeaderWhenTheJobNeverStarted) {
  FrameSource source(dir_, follow());
  const auto end = source.next(jobs::JobState::cancelled);
  ASSERT_TRUE(end && end->has_end());
  EXPECT_EQ(end->end().reason(), "END_OF_JOB");
  EXPECT_EQ(end->end().frame_count(), 0U);
}

TEST_F(FrameSourceTest, LargestIndicesDoNotWrapAround) {
  FrameLogWriter log = new_log();
  ASSERT_EQ(log.append_header(header_), "");
  append(log, 0, 3);
  v1::StreamFramesRequest request = follow();
  request.set_first_index(1);
  request.set_stride(0xffffffffU);
  FrameSource source(dir_, request);
  EXPECT_TRUE(source.next(jobs::JobState::running)->has_header());
  EXPECT_EQ(source.next(jobs::JobState::running)->frame().index(), 1U);
  EXPECT_FALSE(source.next(jobs::JobState::running));
}

TEST_F(FrameSourceTest, StopsInFrontOfDamage) {
  {
    FrameLogWriter log = new_log();
    ASSERT_EQ(log.append_header(header_), "");
    append(log, 0, 2);
  }
  std::string bytes = test::read_bytes(dir_.frames());
  bytes.back() = static_cast<char>(bytes.back() ^ 1);
  test::write_bytes(dir_.frames(), bytes);
  FrameSource source(dir_, {});
  EXPECT_TRUE(source.next(jobs::JobState::succeeded)->has_header());
  EXPECT_TRUE(source.next(jobs::JobState::succeeded)->has_frame());
  EXPECT_FALSE(source.next(jobs::JobState::succeeded));
  EXPECT_NE(source.damage(), "");
  EXPECT_FALSE(source.finished());
}

}  // namespace
}  // namespace slipstitch
