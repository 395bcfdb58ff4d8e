// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <unistd.h>

#include <cstring>
#include <string>
#include <vector>

#include "run_dir/atomic_file.h"
#include "run_dir/frame_log.h"
#include "run_dir/header_check.h"
#include "run_dir/header_codec.h"

namespace slipstitch {
namespace {

std::uint64_t frame_record_bytes(int num_coords) {
  return kRecordHeadBytes + static_cast<std::uint64_t>(num_coords) * sizeof(double);
}

}  // namespace

Result<FrameLogWriter> FrameLogWriter::create(const std::filesystem::path& file) {
  FrameLogWriter writer;
  writer.file_ = file;
  writer.fd_ = UniqueFd(::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644));
  if (!writer.fd_) return Result<FrameLogWriter>::failed(errno_message("cannot create", file));
  return Result<FrameLogWriter>::of(std::move(writer));
}

Result<FrameLogWriter> FrameLogWriter::reopen(const std::filesystem::path& file) {
  FrameLogReader reader(file);
  const LogState state = reader.poll();
  const auto refuse = [&](const std::string& why) {
    return Result<FrameLogWriter>::failed("cannot go on with " + file.string() + ": " + why);
  };
  if (state == LogState::corrupt) return refuse(reader.reason());
  if (state == LogState::ended) return refuse("it has ended");
  const int num_frames = reader.num_frames();
  int good = 0;
  while (good < num_frames && reader.read_frame(good)) ++good;
  if (good < num_frames - 1) return refuse(reader.read_frame(good).error);
  FrameLogWriter writer;
  writer.file_ = file;
  writer.fd_ = UniqueFd(::open(file.c_str(), O_WRONLY | O_CLOEXEC));
  if (reader.header()) writer.num_coords_ = reader.header()->topology.num_coords();
  writer.num_frames_ = good;
  writer.size_ = reader.complete_bytes();
  if (good < num_frames) writer.size_ -= frame_record_bytes(writer.num_coords_);
  if (!writer.fd_ || ::ftruncate(writer.fd_.get(), static_cast<off_t>(writer.size_)) != 0 ||
      ::lseek(writer.fd_.get(), 0, SEEK_END) < 0) {
    return Result<FrameLogWriter>::failed(errno_message("cannot cut", file));
  }
  return Result<FrameLogWriter>::of(std::move(writer));
}

IoError FrameLogWriter::append_header(const FrameHeader& header) {
  if (has_header()) return file_.string() + " already has its header";
  if (const std::string why = header_flaw(header); !why.empty()) return file_.string() + ": unusable header: " + why;
  const std::string payload = encode_header(header);
  RecordHead head{RecordKind::header, RecordEncoding::topology, 0, 0.0, payload.size()};
  if (IoError error = append(head, payload.data()); !error.empty()) return error;
  num_coords_ = header.topology.num_coords();
  return sync();
}

IoError FrameLogWriter::append_frame(const Frame& frame) {
  if (frame.index != num_frames_ || frame.q.size() != num_coords_) {
    return "frame " + std::to_string(frame.index) + " with " + std::to_string(frame.q.size()) +
           " coordinates does not continue " + file_.string() + ": expected frame " + std::to_string(num_frames_) +
           " with " + std::to_string(num_coords_);
  }
  const std::uint64_t length = static_cast<std::uint64_t>(frame.q.size()) * sizeof(double);
  const RecordHead head{RecordKind::frame, RecordEncoding::raw_f64, frame.index, frame.t, length};
  if (IoError error = append(head, frame.q.data()); !error.empty()) return error;
  ++num_frames_;
  return {};
}

IoError FrameLogWriter::append_end(double t) {
  if (!has_header()) return file_.string() + " has no header yet";
  if (IoError error = append({RecordKind::end, RecordEncoding::none, num_frames_, t, 0}, nullptr); !error.empty()) {
    return error;
  }
  return sync();
}

IoError FrameLogWriter::append(RecordHead head, const void* payload) {
  const RecordHeadBytes bytes = encode_head(head, payload);
  if (write_all(fd_.get(), bytes.data(), bytes.size()) && write_all(fd_.get(), payload, head.length)) {
    size_ += bytes.size() + head.length;
    return {};
  }
  IoError error = errno_message("cannot append to", file_);
  if (::ftruncate(fd_.get(), static_cast<off_t>(size_)) != 0 || ::lseek(fd_.get(), 0, SEEK_END) < 0) {
    error += "; its last record is torn";
  }
  return error;
}

IoError FrameLogWriter::sync() { return ::fdatasync(fd_.get()) == 0 ? IoError{} : errno_message("cannot sync", file_); }

}  // namespace slipstitch
