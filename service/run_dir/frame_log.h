// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "run_dir/frame_record.h"
#include "run_dir/result.h"
#include "run_dir/unique_fd.h"
#include "sim/frame.h"

namespace slipstitch {

/// Appends records to frames.log (layout: frame_record.h). Every record goes to the kernel before its call returns, so
/// a killed process loses at most the record it was writing; fsync only with the header and the end, so a power loss
/// may cost frames but never shows wrong ones. After an error the file is cut back to its last whole record.
class FrameLogWriter {
 public:
  /// New log; an existing file is refused.
  static Result<FrameLogWriter> create(const std::filesystem::path& file);

  /// Goes on with a log left behind by a crash: cuts a torn or broken last record. Refused: other damage, an ended log.
  static Result<FrameLogWriter> reopen(const std::filesystem::path& file);

  IoError append_header(const FrameHeader& header);
  IoError append_frame(const Frame& frame);  // frames come in the order 0, 1, 2, ... with num_coords values each
  IoError append_end(double t);

  int num_frames() const { return num_frames_; }
  bool has_header() const { return num_coords_ >= 0; }

 private:
  FrameLogWriter() = default;
  IoError append(RecordHead head, const void* payload);
  IoError sync();

  std::filesystem::path file_;
  UniqueFd fd_;
  std::uint64_t size_ = 0;
  int num_frames_ = 0;
  int num_coords_ = -1;  // -1: no header yet
};

enum class LogState {
  growing,  // no end yet: the writer is at work, or died
  ended,
  corrupt,  // reading stopped in front of a broken record; earlier frames are good
};

/// Reads a log that may still grow, by polling. Holds offsets only, no frame. One reader per thread.
class FrameLogReader {
 public:
  explicit FrameLogReader(std::filesystem::path file) : file_(std::move(file)) {}

  /// Looks for records written since the last call. A missing file and an incomplete last record are `growing`. Frame
  /// payloads are checked by read_frame.
  LogState poll();

  LogState state() const { return state_; }
  const std::string& reason() const { return reason_; }  // of corrupt: names the record and its offset
  const std::optional<FrameHeader>& header() const { return header_; }
  int num_frames() const { return static_cast<int>(offsets_.size()); }  // complete so far
  std::uint64_t complete_bytes() const { return scanned_; }             // end of the last complete record
  std::uint64_t trailing_bytes() const { return size_ - scanned_; }     // behind it: incomplete or broken

  /// Frame `index` of the num_frames() found so far; checks its checksum.
  Result<Frame> read_frame(int index) const;

 private:
  bool open_if_needed();
  bool scan_record();  // false: nothing more to take now
  bool take_header(const RecordHead& head, const RecordHeadBytes& bytes);
  bool take_frame(const RecordHead& head);
  bool take_end(const RecordHead& head);
  bool stop(const std::string& why);

  std::filesystem::path file_;
  UniqueFd fd_;
  LogState state_ = LogState::growing;
  std::string reason_;
  std::optional<FrameHeader> header_;
  std::vector<std::uint64_t> offsets_;  // of frame records
  std::uint64_t scanned_ = 0, size_ = 0;
};

}  // namespace slipstitch
