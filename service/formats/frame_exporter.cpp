// SPDX-License-Identifier: MIT
#include "formats/frame_exporter.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

namespace slipstitch {
namespace fs = std::filesystem;

std::string FrameExporter::open(bool force) {
  std::error_code error;
  const fs::file_status status = fs::status(folder_, error);
  if (fs::exists(status) && !fs::is_directory(status)) return folder_.string() + " exists and is not a folder";
  if (fs::exists(status) && !force && !fs::is_empty(folder_, error)) {
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
  const std::string name = frame_file_name(format_, frame.index);
  std::string error = write(name, format_.write(make_curve_frame(header_, frame, reference_)));
  if (error.empty()) files_.push_back({name, frame.t});
  return error;
}

std::string FrameExporter::finish() {
  if (format_.collection == nullptr) return {};
  return write(std::string(format_.collection_name), format_.collection(files_));
}

std::string FrameExporter::write(const std::string& name, const std::string& bytes) const {
  const fs::path path = folder_ / name;
  errno = 0;
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  return file ? "" : "cannot write " + path.string() + ": " + std::strerror(errno);
}

}  // namespace slipstitch
