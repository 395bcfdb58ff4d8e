// SPDX-License-Identifier: MIT
#include "run_dir/frame_log.h"

#include "log_bytes.h"

namespace slipstitch::test {
namespace {

TEST(FrameLog, ReturnsWhatWasWrittenInAnyOrder) {
  const TemporaryFolder folder;
  write_log(folder / "frames.log", 5, true);
  FrameLogReader reader(folder / "frames.log");
  EXPECT_EQ(reader.poll(), LogState::ended);
  ASSERT_EQ(reader.num_frames(), 5);
  EXPECT_EQ(reader.trailing_bytes(), 0u);
  for (const int index : {4, 0, 3, 1, 2}) {
    const Result<Frame> frame = reader.read_frame(index);
    ASSERT_TRUE(frame) << frame.error;
    EXPECT_EQ(frame->q, sample_frame(sample_header(), index).q);
  }
  EXPECT_FALSE(reader.read_frame(5));
  EXPECT_FALSE(reader.read_frame(-1));
}

TEST(FrameLog, HasTheDocumentedBytes) {
  EXPECT_EQ(crc32c("123456789"), 0xE3069283u);  // check value of CRC-32C
  const TemporaryFolder folder;
  write_log(folder / "frames.log", 2, true);
  const std::string bytes = read_bytes(folder / "frames.log");
  const std::string end = bytes.substr(bytes.size() - 40);
  std::string expected = forge_record(3, 0, 2, 0, "");
  poke(expected, 16, 2.0);
  poke(expected, 32, crc32c(std::string_view(expected).substr(0, 32)));
  poke(expected, 36, crc32c(std::string_view(expected).substr(0, 32)));
  EXPECT_EQ(end, expected);

  const std::string frame = bytes.substr(bytes.size() - 40 - kSampleFrameBytes, kSampleFrameBytes);
  EXPECT_EQ(frame.substr(0, 8), std::string("SLPR\1\0\2\2", 8));
  EXPECT_EQ(peek<std::int64_t>(frame, 8), 1);
  EXPECT_EQ(peek<double>(frame, 16), 1 / 30.0);
  EXPECT_EQ(peek<std::uint64_t>(frame, 24), 200u);
  EXPECT_EQ(peek<std::uint32_t>(frame, 36), crc32c(frame.substr(0, 32) + frame.substr(40)));
  EXPECT_EQ(peek<double>(frame, 40 + 8 * 3), sample_frame(sample_header(), 1).q[3]);
}

TEST(FrameLog, TwoReadersFollowAGrowingLog) {
  const TemporaryFolder folder;
  const auto file = folder / "frames.log";
  FrameLogReader early(file);
  EXPECT_EQ(early.poll(), LogState::growing);  // no file yet
  const FrameHeader header = sample_header();
  Result<FrameLogWriter> writer = FrameLogWriter::create(file);
  ASSERT_TRUE(writer) << writer.error;
  EXPECT_EQ(early.poll(), LogState::growing);
  EXPECT_FALSE(early.header());
  ASSERT_EQ(writer->append_header(header), "");
  FrameLogReader late(file);
  for (int index = 0; index < 6; ++index) {
    ASSERT_EQ(writer->append_frame(sample_frame(header, index)), "");
    EXPECT_EQ(good_prefix(early), index + 1);
    if (index % 3 == 2) {
      EXPECT_EQ(good_prefix(late), index + 1);
    }
  }
  ASSERT_EQ(writer->append_end(1.0), "");
  EXPECT_EQ(early.poll(), LogState::ended);
  EXPECT_EQ(late.poll(), LogState::ended);
}

TEST(FrameLog, RefusesFramesThatDoNotContinueIt) {
  const TemporaryFolder folder;
  const FrameHeader header = sample_header();
  Result<FrameLogWriter> writer = FrameLogWriter::create(folder / "frames.log");
  ASSERT_TRUE(writer) << writer.error;
  EXPECT_NE(writer->append_frame(sample_frame(header, 0)), "");  // no header
  EXPECT_NE(writer->append_end(0.0), "");
  ASSERT_EQ(writer->append_header(header), "");
  EXPECT_NE(writer->append_header(header), "");
  EXPECT_NE(writer->append_frame(sample_frame(header, 1)), "");  // 0 first
  Frame small = sample_frame(header, 0);
  small.q.conservativeResize(3);
  EXPECT_NE(writer->append_frame(small), "");
  EXPECT_EQ(writer->append_frame(sample_frame(header, 0)), "");
  EXPECT_FALSE(FrameLogWriter::create(folder / "frames.log"));  // never overwritten
  FrameLogReader reader(folder / "frames.log");
  EXPECT_EQ(good_prefix(reader), 1);
}

TEST(FrameLog, ReopenGoesOnBehindATornRecord) {
  const TemporaryFolder folder;
  const auto file = folder / "frames.log";
  write_log(file, 3, false);
  const std::string bytes = read_bytes(file);
  for (const std::size_t missing : {std::size_t{0}, std::size_t{1}, kSampleFrameBytes - 1}) {
    write_bytes(file, bytes.substr(0, bytes.size() - missing));
    FrameLogReader follower(file);
    follower.poll();
    Result<FrameLogWriter> writer = FrameLogWriter::reopen(file);
    ASSERT_TRUE(writer) << writer.error;
    EXPECT_EQ(writer->num_frames(), missing == 0 ? 3 : 2);
    const FrameHeader header = sample_header();
    for (int index = writer->num_frames(); index < 5; ++index) {
      ASSERT_EQ(writer->append_frame(sample_frame(header, index)), "");
    }
    ASSERT_EQ(writer->append_end(1.0), "");
    EXPECT_EQ(good_prefix(follower), 5);
    EXPECT_EQ(follower.state(), LogState::ended);
  }
  EXPECT_FALSE(FrameLogWriter::reopen(file));  // ended
}

}  // namespace
}  // namespace slipstitch::test
