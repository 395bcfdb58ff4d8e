// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "api/frame_source.h"
#include "jobs/job_store.h"
#include "rest/body_source.h"

namespace slipstitch::rest {

/// Kinds of records of the binary stream of frames (see streamFrames in operations.cpp).
enum class StreamRecord : std::uint32_t { nothing = 0, header = 1, frame = 2, end = 3 };

inline constexpr std::size_t kStreamRecordHeadBytes = 24;
std::string stream_record_head(StreamRecord kind, std::uint32_t index, std::uint64_t payload_bytes, double t);

/// The messages of a FrameSource as records.
class FrameRecords final : public BodySource {
 public:
  FrameRecords(const jobs::JobStore& store, std::string id, const RunDir& dir, const v1::StreamFramesRequest& request)
      : store_(store), id_(std::move(id)), source_(dir, request) {}

  Piece next() override;
  std::string keep_alive() const override { return stream_record_head(StreamRecord::nothing, 0, 0, 0.0); }
  std::string job() const override { return id_; }
  /// Why the log cannot be read on; empty: it can.
  const std::string& damage() const { return source_.damage(); }

 private:
  std::string record(const v1::StreamFramesResponse& message);
  std::string header_record(const v1::HeaderChunk& chunk);

  const jobs::JobStore& store_;
  const std::string id_;
  FrameSource source_;
  std::string header_;  // serialised, as far as it came
};

}  // namespace slipstitch::rest
