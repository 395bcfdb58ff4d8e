// SPDX-License-Identifier: MIT
#include "cli/remote/frame_assembler.h"

#include <algorithm>

#include "run_dir/header_check.h"
#include "scene_io/convert.h"

namespace slipstitch {

std::string FrameAssembler::add(const v1::StreamFramesResponse& message) {
  frame_.reset();
  if (end_) return "something comes behind the end of the stream";
  switch (message.payload_case()) {
    case v1::StreamFramesResponse::kHeader:
      return add_header(message.header());
    case v1::StreamFramesResponse::kFrame:
      return add_frame(message.frame());
    case v1::StreamFramesResponse::kEnd:
      if (filled_ > 0) return "the stream ends within frame " + std::to_string(next_index_);
      if (message.end().frames_sent() != frames_) return "frames got lost on the way";
      end_ = message.end();
      return {};
    case v1::StreamFramesResponse::PAYLOAD_NOT_SET:
      break;
  }
  return "the server sent something this version does not know";
}

std::string FrameAssembler::add_header(const v1::HeaderChunk& chunk) {
  if (header_ || chunk.offset() != header_bytes_.size()) return "the parts of the header are out of order";
  header_bytes_ += chunk.data();
  if (header_bytes_.size() > chunk.total_bytes()) return "the header is longer than announced";
  return header_bytes_.size() == chunk.total_bytes() ? finish_header() : std::string();
}

std::string FrameAssembler::finish_header() {
  v1::FrameHeader message;
  if (!message.ParseFromString(header_bytes_)) return "the header cannot be read";
  header_bytes_ = std::string();
  std::optional<FrameHeader> header = header_from_message(message);
  if (!header) return "the header has values this version does not know";
  if (const std::string flaw = header_flaw(*header); !flaw.empty()) return "the header is wrong: " + flaw;
  header_ = std::move(header);
  return {};
}

std::string FrameAssembler::add_frame(const v1::FrameChunk& chunk) {
  const std::string name = "frame " + std::to_string(chunk.index());
  if (!header_) return name + " comes before the header";
  const Eigen::Index total = header_->topology.num_coords();
  if (chunk.index() != next_index_) return name + " comes where " + std::to_string(next_index_) + " should";
  if (chunk.total() != static_cast<std::uint64_t>(total)) return name + " does not fit the topology";
  if (chunk.offset() != static_cast<std::uint64_t>(filled_) || chunk.q_size() > total - filled_) {
    return "the parts of " + name + " are out of order";
  }
  if (filled_ == 0) partial_ = {static_cast<int>(chunk.index()), chunk.t(), VecX(total)};
  std::copy(chunk.q().begin(), chunk.q().end(), partial_.q.data() + filled_);
  filled_ += chunk.q_size();
  if (filled_ < total) return {};
  frame_ = std::move(partial_);
  filled_ = 0;
  ++frames_;
  next_index_ += stride_;
  return {};
}

}  // namespace slipstitch
