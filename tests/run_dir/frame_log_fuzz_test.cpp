// SPDX-License-Identifier: MIT
#include <random>

#include "log_bytes.h"
#include "run_dir/header_check.h"
#include "run_dir/header_codec.h"

namespace slipstitch::test {
namespace {

using Random = std::mt19937_64;

std::size_t below(Random& random, std::size_t end) { return static_cast<std::size_t>(random() % end); }

void mutate(std::string& bytes, Random& random) {
  if (bytes.empty()) return;
  const std::size_t at = below(random, bytes.size());
  const std::size_t length = below(random, bytes.size() - at + 1);
  switch (below(random, 6)) {
    case 0:
      bytes[at] = static_cast<char>(random());
      break;
    case 1:
      bytes.resize(at);
      break;
    case 2:
      bytes.erase(at, length);
      break;
    case 3:
      bytes.insert(below(random, bytes.size()), bytes.substr(at, length));
      break;
    case 4:
      bytes.replace(at, length, length, '\0');
      break;
    default:
      if (at + 8 <= bytes.size()) poke(bytes, at, ~std::uint64_t{0} >> below(random, 64));
  }
}

TEST(FrameLogFuzz, MutatedLogsGiveAPrefixOfTheTruth) {
  const TemporaryFolder folder;
  const auto file = folder / "frames.log";
  write_log(file, 4, true);
  const std::string bytes = read_bytes(file);
  Random random(20240501);
  for (int round = 0; round < 5000; ++round) {
    std::string damaged = bytes;
    for (std::size_t count = 1 + below(random, 3); count > 0; --count) mutate(damaged, random);
    write_bytes(file, damaged);
    FrameLogReader reader(file);
    const int good = good_prefix(reader);  // compares each with the truth
    EXPECT_LE(good, 4) << round;
    if (reader.state() == LogState::corrupt) {
      EXPECT_FALSE(reader.reason().empty());
    }
  }
}

TEST(FrameLogFuzz, MutatedHeadersAreRefusedOrSound) {
  const std::string bytes = encode_header(sample_header());
  Random random(20240502);
  int accepted = 0;
  for (int round = 0; round < 20000; ++round) {
    std::string damaged = bytes;
    mutate(damaged, random);
    const Result<FrameHeader> header = decode_header(damaged);
    if (!header) continue;
    ++accepted;
    EXPECT_EQ(header_flaw(*header), "");
    EXPECT_EQ(encode_header(*header), damaged);  // one meaning, one spelling
  }
  EXPECT_GT(accepted, 100);  // changed numbers within their ranges
}

}  // namespace
}  // namespace slipstitch::test
