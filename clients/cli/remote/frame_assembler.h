// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "sim/frame.h"
#include "slipstitch/v1/frames.pb.h"

namespace slipstitch {

/// Puts the messages of one frame stream together again and trusts none of them.
class FrameAssembler {
 public:
  FrameAssembler(std::uint32_t first_index, std::uint32_t stride) : next_index_(first_index), stride_(stride) {}

  /// What is wrong with the message, empty when nothing is. After it header(), frame() and end() show what it
  /// completed.
  std::string add(const v1::StreamFramesResponse& message);

  const std::optional<FrameHeader>& header() const { return header_; }
  const std::optional<Frame>& frame() const { return frame_; }  // completed by the last message
  const std::optional<v1::StreamEnd>& end() const { return end_; }
  std::uint32_t next_index() const { return next_index_; }  // of the first frame that is not complete

 private:
  std::string add_header(const v1::HeaderChunk& chunk);
  std::string add_frame(const v1::FrameChunk& chunk);
  std::string finish_header();

  std::uint32_t next_index_, stride_, frames_ = 0;
  std::string header_bytes_;
  std::optional<FrameHeader> header_;
  std::optional<Frame> frame_;
  Frame partial_;
  Eigen::Index filled_ = 0;  // doubles of partial_
  std::optional<v1::StreamEnd> end_;
};

}  // namespace slipstitch
