// SPDX-License-Identifier: MIT
#include "cli/remote/frame_assembler.h"

#include <gtest/gtest.h>

#include "cli/frame_messages.h"

namespace slipstitch::test {
namespace {

using Messages = std::vector<v1::StreamFramesResponse>;

class AssembledFrames : public ::testing::Test {
 protected:
  void SetUp() override {
    messages_ = header_messages(header_);
    for (const int index : {2, 5}) {
      const Messages frame = frame_messages(sample_frame(header_, index));
      messages_.insert(messages_.end(), frame.begin(), frame.end());
    }
    messages_.push_back(end_message(2));
  }

  // The first thing that is wrong.
  static std::string flaw(const Messages& messages) {
    FrameAssembler assembler(2, 3);
    for (const auto& message : messages) {
      if (const std::string found = assembler.add(message); !found.empty()) return found;
    }
    return assembler.end() ? "" : "no end";
  }

  const FrameHeader header_ = sample_header();
  Messages messages_;  // 2 of the header, 3 a frame, the end
};

TEST_F(AssembledFrames, ComeOutBitForBit) {
  FrameAssembler assembler(2, 3);
  std::vector<Frame> frames;
  for (const auto& message : messages_) {
    ASSERT_EQ(assembler.add(message), "");
    if (assembler.frame()) frames.push_back(*assembler.frame());
  }
  ASSERT_TRUE(assembler.header() && assembler.end());
  EXPECT_EQ(assembler.header()->topology.visit_node, header_.topology.visit_node);
  EXPECT_EQ(assembler.next_index(), 8U);
  ASSERT_EQ(frames.size(), 2U);
  for (const Frame& frame : frames) {
    const Frame expected = sample_frame(header_, frame.index);
    EXPECT_EQ(frame.t, expected.t);
    EXPECT_EQ(frame.q, expected.q);
  }
}

TEST_F(AssembledFrames, AnyMessageLostOrTwiceIsNoticed) {
  EXPECT_EQ(flaw(messages_), "");
  for (std::size_t i = 0; i < messages_.size(); ++i) {
    Messages lost = messages_, twice = messages_;
    lost.erase(lost.begin() + static_cast<std::ptrdiff_t>(i));
    twice.insert(twice.begin() + static_cast<std::ptrdiff_t>(i), messages_[i]);
    EXPECT_NE(flaw(lost), "") << i;
    EXPECT_NE(flaw(twice), "") << i;
  }
}

TEST_F(AssembledFrames, TwoSwappedMessagesAreNoticed) {
  for (std::size_t i = 0; i + 1 < messages_.size(); ++i) {
    Messages swapped = messages_;
    std::swap(swapped[i], swapped[i + 1]);
    EXPECT_NE(flaw(swapped), "") << i;
  }
}

TEST_F(AssembledFrames, SizesThatDoNotFitAreRefused) {
  Messages more = messages_;
  more[2].mutable_frame()->set_total(more[2].frame().total() + 1);
  EXPECT_NE(flaw(more), "");
  Messages longer = messages_;
  longer[4].mutable_frame()->add_q(0.0);
  EXPECT_NE(flaw(longer), "");
  Messages header = messages_;
  header[0].mutable_header()->set_total_bytes(1);
  EXPECT_NE(flaw(header), "");
  Messages empty = messages_;
  empty[3].Clear();
  EXPECT_NE(flaw(empty), "");
}

TEST_F(AssembledFrames, AHeaderWithAnIndexOutOfRangeIsRefused) {
  FrameHeader header = header_;
  header.topology.visit_node[0] = header.topology.num_nodes;
  FrameAssembler assembler(0, 1);
  EXPECT_NE(assembler.add(header_messages(header, 1)[0]), "");
}

}  // namespace
}  // namespace slipstitch::test
