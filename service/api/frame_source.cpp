// SPDX-License-Identifier: MIT
#include "api/frame_source.h"

#include <algorithm>
#include <limits>

#include "api/job_message.h"
#include "api/message_limits.h"
#include "scene_io/convert.h"

namespace slipstitch {
namespace {

constexpr std::uint64_t kChunkDoubles = kChunkBytes / sizeof(double);

}  // namespace

std::optional<jobs::Error> check_range(const v1::StreamFramesRequest& request) {
  if (!request.has_end_index() || request.end_index() >= request.first_index()) return std::nullopt;
  return jobs::invalid_field("end_index", std::to_string(request.end_index()), "at least first_index");
}

std::optional<jobs::Error> check_has_frames(const jobs::Job& job) {
  return job.info.study ? std::optional(jobs::no_frames(job.id)) : std::nullopt;
}

FrameSource::FrameSource(const RunDir& dir, const v1::StreamFramesRequest& request)
    : log_(dir.frames()),
      follow_(request.follow()),
      stride_(std::max(1U, request.stride())),
      end_index_(request.has_end_index() ? request.end_index() : std::numeric_limits<std::uint64_t>::max()),
      next_index_(request.first_index()) {}

std::optional<v1::StreamFramesResponse> FrameSource::next(jobs::JobState state) {
  if (finished_ || !damage_.empty()) return {};
  if (frame_) return frame_chunk();
  if (header_offset_ > 0 && !header_sent_) return header_chunk();
  const LogState log_state = log_.poll();
  if (!header_sent_ && log_.header()) return header_chunk();
  if (header_sent_ && next_index_ >= end_index_) return end(state, "END_OF_RANGE");
  if (header_sent_ && next_index_ < static_cast<std::uint64_t>(log_.num_frames())) {
    return load_frame() ? frame_chunk() : Message();
  }
  if (log_state == LogState::corrupt) {
    damage_ = log_.reason();
    return {};
  }
  if (jobs::is_terminal(state)) return end(state, "END_OF_JOB");
  return follow_ ? Message() : end(state, "NO_MORE_YET");
}

FrameSource::Message FrameSource::header_chunk() {
  if (header_.empty()) header_ = message_from_header(*log_.header()).SerializeAsString();
  v1::StreamFramesResponse response;
  v1::HeaderChunk& chunk = *response.mutable_header();
  chunk.set_offset(header_offset_);
  chunk.set_total_bytes(header_.size());
  chunk.set_data(header_.substr(header_offset_, kChunkBytes));
  header_offset_ += chunk.data().size();
  header_sent_ = header_offset_ == header_.size();
  if (header_sent_) header_ = std::string();
  return response;
}

bool FrameSource::load_frame() {
  Result<Frame> frame = log_.read_frame(static_cast<int>(next_index_));
  if (!frame) {
    damage_ = frame.error;
    return false;
  }
  frame_ = std::move(*frame);
  frame_offset_ = 0;
  return true;
}

FrameSource::Message FrameSource::frame_chunk() {
  const std::uint64_t total = static_cast<std::uint64_t>(frame_->q.size());
  const std::uint64_t size = std::min(kChunkDoubles, total - frame_offset_);
  v1::StreamFramesResponse response;
  v1::FrameChunk& chunk = *response.mutable_frame();
  chunk.set_index(static_cast<std::uint32_t>(frame_->index));
  chunk.set_t(frame_->t);
  chunk.set_offset(frame_offset_);
  chunk.set_total(total);
  const double* begin = frame_->q.data() + frame_offset_;
  chunk.mutable_q()->Add(begin, begin + size);
  frame_offset_ += size;
  if (frame_offset_ == total) {
    frame_.reset();
    ++frames_sent_;
    next_index_ += stride_;
  }
  return response;
}

FrameSource::Message FrameSource::end(jobs::JobState state, const char* reason) {
  v1::StreamFramesResponse response;
  v1::StreamEnd& message = *response.mutable_end();
  message.set_state(message_from_state(state));
  message.set_frames_sent(frames_sent_);
  message.set_frame_count(static_cast<std::uint32_t>(log_.num_frames()));
  message.set_reason(reason);
  finished_ = true;
  return response;
}

}  // namespace slipstitch
