// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include "scene_io/convert.h"
#include "support/sample_run.h"

namespace slipstitch::test {

/// A header that can be trusted, as the sample is after a round trip through a log.
inline std::vector<v1::StreamFramesResponse> header_messages(const FrameHeader& header, std::size_t parts = 2) {
  const std::string bytes = message_from_header(header).SerializeAsString();
  const std::size_t size = bytes.size() / parts + 1;
  std::vector<v1::StreamFramesResponse> messages;
  for (std::size_t offset = 0; offset < bytes.size(); offset += size) {
    v1::HeaderChunk& chunk = *messages.emplace_back().mutable_header();
    chunk.set_offset(offset);
    chunk.set_total_bytes(bytes.size());
    chunk.set_data(bytes.substr(offset, size));
  }
  return messages;
}

inline std::vector<v1::StreamFramesResponse> frame_messages(const Frame& frame, int parts = 3) {
  const auto total = static_cast<int>(frame.q.size());
  const int size = total / parts + 1;
  std::vector<v1::StreamFramesResponse> messages;
  for (int offset = 0; offset < total; offset += size) {
    v1::FrameChunk& chunk = *messages.emplace_back().mutable_frame();
    chunk.set_index(static_cast<std::uint32_t>(frame.index));
    chunk.set_t(frame.t);
    chunk.set_offset(static_cast<std::uint64_t>(offset));
    chunk.set_total(static_cast<std::uint64_t>(total));
    const double* begin = frame.q.data() + offset;
    chunk.mutable_q()->Add(begin, begin + std::min(size, total - offset));
  }
  return messages;
}

inline v1::StreamFramesResponse end_message(std::uint32_t frames_sent) {
  v1::StreamFramesResponse message;
  message.mutable_end()->set_state(v1::SimJob::SUCCEEDED);
  message.mutable_end()->set_frames_sent(frames_sent);
  message.mutable_end()->set_frame_count(frames_sent);
  message.mutable_end()->set_reason("END_OF_JOB");
  return message;
}

}  // namespace slipstitch::test
