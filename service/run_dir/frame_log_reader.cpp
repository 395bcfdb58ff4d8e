// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>
#include <string>

#include "run_dir/frame_log.h"
#include "run_dir/header_codec.h"

namespace slipstitch {
namespace {

constexpr std::uint64_t kMaxHeaderBytes = std::uint64_t{1} << 32;

bool all_zero(const RecordHeadBytes& bytes) {
  return std::all_of(bytes.begin(), bytes.end(), [](unsigned char byte) { return byte == 0; });
}

}  // namespace

LogState FrameLogReader::poll() {
  if (state_ != LogState::growing || !open_if_needed()) return state_;
  struct stat info {};
  if (::fstat(fd_.get(), &info) != 0) {
    stop(errno_message("cannot stat", file_));
    return state_;
  }
  size_ = static_cast<std::uint64_t>(info.st_size);
  if (size_ < scanned_) {
    stop("the file shrank below records already read");
    size_ = scanned_;
    return state_;
  }
  while (scan_record()) {
  }
  return state_;
}

bool FrameLogReader::open_if_needed() {
  if (fd_) return true;
  fd_ = UniqueFd(::open(file_.c_str(), O_RDONLY | O_CLOEXEC));
  if (!fd_ && errno != ENOENT) stop(errno_message("cannot open", file_));
  return static_cast<bool>(fd_);
}

bool FrameLogReader::scan_record() {
  if (state_ != LogState::growing || size_ - scanned_ < kRecordHeadBytes) return false;
  RecordHeadBytes bytes;
  if (!read_all_at(fd_.get(), bytes.data(), bytes.size(), scanned_)) return stop(errno_message("cannot read", file_));
  // Zeros: a filesystem may show the new length before the data, and keep it so after a power loss.
  if (all_zero(bytes)) return false;
  RecordHead head;
  if (const std::string why = decode_head(bytes, head); !why.empty()) return stop(why);
  switch (head.kind) {
    case RecordKind::header:
      return take_header(head, bytes);
    case RecordKind::frame:
      return take_frame(head);
    case RecordKind::end:
      return take_end(head);
  }
  return stop("unknown kind of record");
}

bool FrameLogReader::take_header(const RecordHead& head, const RecordHeadBytes& bytes) {
  if (header_) return stop("a second header");
  if (head.encoding != RecordEncoding::topology || head.index != 0) return stop("unknown encoding of the header");
  if (head.length > kMaxHeaderBytes) return stop("the header is too long");
  if (size_ - scanned_ - kRecordHeadBytes < head.length) return false;
  std::string payload(head.length, '\0');
  if (!read_all_at(fd_.get(), payload.data(), payload.size(), scanned_ + kRecordHeadBytes)) {
    return stop(errno_message("cannot read", file_));
  }
  if (!payload_matches(bytes, payload.data(), payload.size())) return stop("checksum of the header does not match");
  Result<FrameHeader> decoded = decode_header(payload);
  if (!decoded) return stop(decoded.error);
  header_ = std::move(*decoded);
  scanned_ += kRecordHeadBytes + head.length;
  return true;
}

bool FrameLogReader::take_frame(const RecordHead& head) {
  if (!header_) return stop("a frame in front of the header");
  if (head.encoding != RecordEncoding::raw_f64) return stop("unknown encoding of a frame");
  if (head.index != num_frames()) return stop("frame number " + std::to_string(head.index) + " out of order");
  if (head.length != static_cast<std::uint64_t>(header_->topology.num_coords()) * sizeof(double)) {
    return stop("the frame's length does not fit the topology");
  }
  if (num_frames() == std::numeric_limits<int>::max()) return stop("too many frames");
  if (size_ - scanned_ - kRecordHeadBytes < head.length) return false;
  offsets_.push_back(scanned_);
  scanned_ += kRecordHeadBytes + head.length;
  return true;
}

bool FrameLogReader::take_end(const RecordHead& head) {
  if (!header_ || head.index != num_frames() || head.length != 0 || head.encoding != RecordEncoding::none) {
    return stop("the end does not fit the frames before it");
  }
  RecordHeadBytes bytes;
  if (!read_all_at(fd_.get(), bytes.data(), bytes.size(), scanned_) || !payload_matches(bytes, nullptr, 0)) {
    return stop("checksum of the end does not match");
  }
  scanned_ += kRecordHeadBytes;
  if (size_ != scanned_) return stop("something follows the end");
  state_ = LogState::ended;
  return false;
}

bool FrameLogReader::stop(const std::string& why) {
  const std::string place = header_ ? "after frame count " + std::to_string(num_frames()) : "in the header";
  reason_ = file_.string() + " is corrupt " + place + " at byte " + std::to_string(scanned_) + ": " + why;
  state_ = LogState::corrupt;
  return false;
}

Result<Frame> FrameLogReader::read_frame(int index) const {
  const auto fail = [&](const std::string& why) {
    return Result<Frame>::failed("frame " + std::to_string(index) + " of " + file_.string() + ": " + why);
  };
  if (index < 0 || index >= num_frames()) return fail("not there, " + std::to_string(num_frames()) + " so far");
  const std::uint64_t offset = offsets_[static_cast<std::size_t>(index)];
  RecordHeadBytes bytes;
  RecordHead head;
  if (!read_all_at(fd_.get(), bytes.data(), bytes.size(), offset)) return fail("cannot be read");
  if (const std::string why = decode_head(bytes, head); !why.empty()) return fail(why);
  Frame frame;
  frame.index = index;
  frame.t = head.t;
  frame.q.resize(header_->topology.num_coords());
  const std::size_t length = static_cast<std::size_t>(frame.q.size()) * sizeof(double);
  if (!read_all_at(fd_.get(), frame.q.data(), length, offset + kRecordHeadBytes)) return fail("cannot be read");
  if (!payload_matches(bytes, frame.q.data(), length)) return fail("checksum does not match");
  return Result<Frame>::of(std::move(frame));
}

}  // namespace slipstitch
