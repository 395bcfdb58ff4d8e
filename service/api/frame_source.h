// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "jobs/error.h"
#include "jobs/job.h"
#include "run_dir/frame_log.h"
#include "run_dir/run_dir.h"
#include "slipstitch/v1/frames.pb.h"

namespace slipstitch {

/// What is wrong with a request besides its name; empty: nothing.
std::optional<jobs::Error> check_range(const v1::StreamFramesRequest& request);

/// Why a job never has frames; empty: it may.
std::optional<jobs::Error> check_has_frames(const jobs::Job& job);

/// Cuts a job's frame log into the messages of one StreamFrames call. Knows no gRPC.
class FrameSource {
 public:
  FrameSource(const RunDir& dir, const v1::StreamFramesRequest& request);

  /// The next message, or nothing when the log has none yet: ask again when it has grown. `state` is the job's, read
  /// before this call. After the StreamEnd finished() is true.
  std::optional<v1::StreamFramesResponse> next(jobs::JobState state);

  bool finished() const { return finished_; }
  /// Why the log cannot be read on; empty: it can.
  const std::string& damage() const { return damage_; }

 private:
  using Message = std::optional<v1::StreamFramesResponse>;
  Message header_chunk();
  Message frame_chunk();
  Message end(jobs::JobState state, const char* reason);
  bool load_frame();

  FrameLogReader log_;
  const bool follow_;
  const std::uint64_t stride_;
  const std::uint64_t end_index_;
  std::uint64_t next_index_;
  std::string header_;               // serialised
  std::uint64_t header_offset_ = 0;  // sent so far [byte]
  bool header_sent_ = false;
  std::optional<Frame> frame_;      // being sent
  std::uint64_t frame_offset_ = 0;  // sent so far [double]
  std::uint32_t frames_sent_ = 0;
  bool finished_ = false;
  std::string damage_;
};

}  // namespace slipstitch
