// SPDX-License-Identifier: MIT
#include "formats/frame_exporter.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>

namespace slipstitch {
namespace fs = std::filesystem;

std::string FrameExporter::open() {
  std::error_code error;
  const fs::file_status status = fs::status(folder_, error);
  if (fs::exists(status) && !fs::is_directory(status)) return folder_.string() + " exists and is not a folder";
  if (fs::exists(status) && !force_ && !fs::is_empty(folder_, error)) {
    return folder_.string() + " exists and is not empty";
  }
  fs::create_directories(folder_, error);
  return error ? "cannot create " + folder_.string() + ": " + error.message() : "";
}

std::string FrameExporter::begin(FrameHeader header, Frame reference) {
  if (reference.q.size() != header.topology.num_coords()) return "the reference frame does not fit the topology";
  header_ = std::move(header);
  reference_ = std::move(reference);
  return {};
}

std::string FrameExporter::add(const Frame& frame) {
  if (frame.q.size() != reference_.q.size()) {
    return "frame " + std::to_string(frame.index) + " does not fit the topology";
  }
  if (num_frames_ == 0) {
    if (std::string error = open(); !error.empty()) return error;
  }
  const FrameFile file{frame_file_name(format_, frame.index), frame.t};
  std::string error = write(file.name, format_.write(make_curve_frame(header_, frame, reference_)));
  if (error.empty()) error = list(file);
  if (error.empty()) ++num_frames_;
  return error;
}

std::string FrameExporter::write(const std::string& name, const std::string& bytes) const {
  const fs::path path = folder_ / name;
  errno = 0;
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  return file ? "" : "cannot write " + path.string() + ": " + std::strerror(errno);
}

// Entry and foot take the place of the foot in a single write: a list that is whole becomes one that is whole.
std::string FrameExporter::list(const FrameFile& file) {
  if (format_.collection == nullptr) return {};
  const Collection& collection = *format_.collection;
  const fs::path path = folder_ / collection.file_name, started = path.string() + ".new";
  std::string text = collection.entry(file);
  errno = 0;
  if (num_frames_ == 0) {
    list_.open(started, std::ios::binary | std::ios::trunc);
    text.insert(0, collection.head);
  } else {
    list_.seekp(-static_cast<std::streamoff>(collection.foot.size()), std::ios::end);
  }
  text += collection.foot;
  list_.write(text.data(), static_cast<std::streamsize>(text.size())).flush();
  if (list_ && (num_frames_ > 0 || ::rename(started.c_str(), path.c_str()) == 0)) return {};
  return "cannot write " + path.string() + ": " + std::strerror(errno);
}

}  // namespace slipstitch
