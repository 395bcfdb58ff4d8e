// SPDX-License-Identifier: MIT
#include "rest/frame_file.h"

#include "run_dir/frame_log.h"

namespace slipstitch::rest {
namespace {

jobs::Error damaged(const std::string& why) { return {jobs::ErrorCode::data_loss, "STORAGE_FAILED", why, {}, {}, {}}; }

jobs::Error frame_not_found(const std::string& id, std::uint32_t index, int num_frames) {
  return {jobs::ErrorCode::not_found,
          "FRAME_NOT_FOUND",
          "job simJobs/" + id + " has no frame " + std::to_string(index) + "; it has " + std::to_string(num_frames) +
              " so far",
          {{"frames", std::to_string(num_frames)}},
          {},
          {}};
}

}  // namespace

jobs::Outcome<std::string> frame_file(const std::string& id, const RunDir& dir, std::uint32_t index,
                                      const Format& format) {
  FrameLogReader log(dir.frames());
  const LogState state = log.poll();
  if (index >= static_cast<std::uint32_t>(log.num_frames())) {
    if (state == LogState::corrupt) return damaged(log.reason());
    return frame_not_found(id, index, log.num_frames());
  }
  const Result<Frame> reference = log.read_frame(0);
  if (!reference) return damaged(reference.error);
  const Result<Frame> frame = log.read_frame(static_cast<int>(index));
  if (!frame) return damaged(frame.error);
  return format.write(make_curve_frame(*log.header(), *frame, *reference));
}

}  // namespace slipstitch::rest
