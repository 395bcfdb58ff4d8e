// SPDX-License-Identifier: MIT
#include "rest/frame_records.h"

#include <bit>
#include <cstring>

#include "rest/api_json.h"

namespace slipstitch::rest {
namespace {

static_assert(std::endian::native == std::endian::little);

template <class T>
void append(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

// A whole record, padded to 8 bytes.
std::string text_record(StreamRecord kind, const std::string& payload) {
  std::string record = stream_record_head(kind, 0, payload.size(), 0.0) + payload;
  record.resize((record.size() + 7) / 8 * 8, '\0');
  return record;
}

// Behind the first chunk of a frame stand the doubles alone: its record is cut like the message.
std::string frame_record(const v1::FrameChunk& chunk) {
  std::string record;
  if (chunk.offset() == 0) {
    record = stream_record_head(StreamRecord::frame, chunk.index(), chunk.total() * sizeof(double), chunk.t());
  }
  record.append(reinterpret_cast<const char*>(chunk.q().data()),
                static_cast<std::size_t>(chunk.q_size()) * sizeof(double));
  return record;
}

}  // namespace

std::string stream_record_head(StreamRecord kind, std::uint32_t index, std::uint64_t payload_bytes, double t) {
  std::string head;
  append(head, static_cast<std::uint32_t>(kind));
  append(head, index);
  append(head, payload_bytes);
  append(head, t);
  return head;
}

std::string FrameRecords::header_record(const v1::HeaderChunk& chunk) {
  header_ += chunk.data();
  if (header_.size() < chunk.total_bytes()) return {};
  v1::FrameHeader header;
  header.ParseFromString(header_);  // our own serialisation
  header_ = std::string();
  return text_record(StreamRecord::header, api_json(header));
}

std::string FrameRecords::record(const v1::StreamFramesResponse& message) {
  if (message.has_header()) return header_record(message.header());
  if (message.has_frame()) return frame_record(message.frame());
  return text_record(StreamRecord::end, api_json(message.end()));
}

Piece FrameRecords::next() {
  const jobs::Outcome<jobs::Job> job = store_.get(id_);
  if (!job || store_.stopping()) return {"", Piece::Then::broken};
  const std::optional<v1::StreamFramesResponse> message = source_.next(job->state);
  if (!message) return {"", source_.damage().empty() ? Piece::Then::wait : Piece::Then::broken};
  return {record(*message), source_.finished() ? Piece::Then::end : Piece::Then::more};
}

}  // namespace slipstitch::rest
