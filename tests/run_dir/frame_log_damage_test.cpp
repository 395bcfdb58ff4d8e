// SPDX-License-Identifier: MIT
#include <sys/resource.h>

#include "log_bytes.h"
#include "run_dir/header_codec.h"

namespace slipstitch::test {
namespace {

TEST(FrameLogDamage, TornTailAtEveryByteGivesTheCompletePrefix) {
  const TemporaryFolder folder;
  const auto file = folder / "frames.log";
  write_log(file, 3, false);
  const std::string bytes = read_bytes(file);
  for (std::size_t kept = 0; kept < bytes.size(); ++kept) {
    write_bytes(file, bytes.substr(0, kept));
    FrameLogReader reader(file);
    const int good = good_prefix(reader);
    EXPECT_EQ(reader.state(), LogState::growing) << reader.reason();
    if (bytes.size() - kept <= kSampleFrameBytes) {
      EXPECT_EQ(good, 2) << kept;
      EXPECT_EQ(reader.trailing_bytes(), kept - (bytes.size() - kSampleFrameBytes));
    }
    // The rest arrives: the same reader goes on.
    write_bytes(file, bytes);
    EXPECT_EQ(good_prefix(reader), 3) << kept;
  }
}

TEST(FrameLogDamage, EveryFlippedBitIsDetected) {
  const TemporaryFolder folder;
  const auto file = folder / "frames.log";
  write_log(file, 2, true);
  const std::string bytes = read_bytes(file);
  const std::size_t first_frame = bytes.size() - 40 - 2 * kSampleFrameBytes;
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    std::string damaged = bytes;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
    write_bytes(file, damaged);
    FrameLogReader reader(file);
    const int good = good_prefix(reader);
    const bool in_payload = reader.state() == LogState::ended && good < 2;
    EXPECT_TRUE(in_payload || (reader.state() == LogState::corrupt && !reader.reason().empty())) << "bit " << bit;
    const std::size_t record = bit / 8 < first_frame ? 0 : (bit / 8 - first_frame) / kSampleFrameBytes;
    EXPECT_EQ(good, bit / 8 < first_frame ? 0 : static_cast<int>(record)) << "bit " << bit;
  }
}

TEST(FrameLogDamage, ReopenCutsABrokenLastFrameAndRefusesAnEarlierOne) {
  const TemporaryFolder folder;
  const auto file = folder / "frames.log";
  write_log(file, 3, false);
  const std::string bytes = read_bytes(file);
  std::string damaged = bytes;
  damaged.back() = static_cast<char>(damaged.back() ^ 1);
  write_bytes(file, damaged);
  {
    const Result<FrameLogWriter> writer = FrameLogWriter::reopen(file);
    ASSERT_TRUE(writer) << writer.error;
    EXPECT_EQ(writer->num_frames(), 2);
  }
  EXPECT_EQ(read_bytes(file), bytes.substr(0, bytes.size() - kSampleFrameBytes));
  damaged = bytes;
  char& earlier = damaged[bytes.size() - kSampleFrameBytes - 1];
  earlier = static_cast<char>(earlier ^ 1);
  write_bytes(file, damaged);
  EXPECT_FALSE(FrameLogWriter::reopen(file));
  EXPECT_EQ(read_bytes(file), damaged);
}

// Reads the log under a limit on memory that its lengths, if believed, would break.
LogState state_of(const std::filesystem::path& file, const std::string& bytes) {
  write_bytes(file, bytes);
  FrameLogReader reader(file);
  return reader.poll();
}

TEST(FrameLogDamage, HostileLengthsAllocateNothing) {
  const TemporaryFolder folder;
  const auto file = folder / "frames.log";
  const std::string header =
      forge_record(1, 1, 0, encode_header(sample_header()).size(), encode_header(sample_header()));
  EXPECT_EQ(state_of(file, header), LogState::growing);
  for (const std::uint64_t length : {std::uint64_t{1} << 33, std::uint64_t{1} << 63, ~std::uint64_t{0}}) {
    EXPECT_EQ(state_of(file, forge_record(1, 1, 0, length, "")), LogState::corrupt) << length;
    EXPECT_EQ(state_of(file, header + forge_record(2, 2, 0, length, "")), LogState::corrupt) << length;
    EXPECT_EQ(state_of(file, header + forge_record(3, 0, 0, length, "")), LogState::corrupt) << length;
  }
  EXPECT_EQ(state_of(file, forge_record(1, 1, 0, std::uint64_t{1} << 32, "")), LogState::growing);  // not read yet
  FrameLogReader reader(file);
  reader.poll();
  struct rusage usage {};
  ::getrusage(RUSAGE_SELF, &usage);
  EXPECT_LT(usage.ru_maxrss, 1 << 20);  // [KiB]
}

TEST(FrameLogDamage, RecordsOutOfPlaceAreRefused) {
  const TemporaryFolder folder;
  const auto file = folder / "frames.log";
  const std::string payload = encode_header(sample_header());
  const std::string header = forge_record(1, 1, 0, payload.size(), payload);
  const std::string q(200, '\0');
  const std::string frame = forge_record(2, 2, 0, 200, q);
  const std::string end = forge_record(3, 0, 1, 0, "");
  EXPECT_EQ(state_of(file, header + frame + end), LogState::ended);
  EXPECT_EQ(state_of(file, frame), LogState::corrupt);
  EXPECT_EQ(state_of(file, header + header), LogState::corrupt);
  EXPECT_EQ(state_of(file, header + frame + frame), LogState::corrupt);
  EXPECT_EQ(state_of(file, header + end), LogState::corrupt);
  EXPECT_EQ(state_of(file, header + frame + end + "x"), LogState::corrupt);
  EXPECT_EQ(state_of(file, header + forge_record(9, 2, 0, 200, q)), LogState::corrupt);
  EXPECT_EQ(state_of(file, header + forge_record(2, 9, 0, 200, q)), LogState::corrupt);
  EXPECT_EQ(state_of(file, header + forge_record(2, 2, 0, 168, q.substr(8))), LogState::corrupt);
  EXPECT_EQ(state_of(file, header + std::string(100, '\0')), LogState::growing);  // zeros of a lost tail
}

}  // namespace
}  // namespace slipstitch::test
