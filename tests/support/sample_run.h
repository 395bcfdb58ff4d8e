// SPDX-License-Identifier: MIT
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include "sim/frame.h"

namespace slipstitch::test {

/// Two yarns of 4 and 3 visits that share nodes 1 and 2, and a body; every field differs from its default.
inline FrameHeader sample_header() {
  FrameHeader header;
  Topology& topology = header.topology;
  topology.num_nodes = 6;
  topology.num_bodies = 1;
  topology.yarn_first = {0, 4, 7};
  topology.visit_node = {0, 1, 2, 3, 4, 2, 1};
  topology.visit_slides = {0, 1, 1, 0, 0, 1, 1};
  topology.visit_owned = {1, 1, 1, 0, 1, 1, 1};
  topology.visit_extra = {0, 0, 0, 1, 0, 0, 0};
  topology.segment_kind = {SegmentKind::free, SegmentKind::contact, SegmentKind::free, SegmentKind::none,
                           SegmentKind::free, SegmentKind::contact, SegmentKind::none};
  topology.rest_arc = {0.0, 1e-3, 1.7e-3, 3e-3, 0.0, 1.1e-3, 2e-3};
  topology.yarn_material = {0, 1};
  topology.density_scale = {1.3, 1.4};
  topology.contacts = {{1, 2, 0, 3, 4, -1, {1, 2}, {6, 5}, -1, StitchKind::purl, ClaspSide::right, 0, false}};
  topology.stitches = {{1, 2, StitchKind::purl, -1, 0, 0, -1, {0, 1, 2, 3, 4, 2, 1, 0}}};
  topology.num_courses = 1;
  topology.num_wales = 2;
  header.yarn = {0.6e-3, 0.08e-3, 70.0, 5e-8};
  header.frames_per_s = 30.0;
  header.num_frames = 61;
  header.shrinkage = {{0.5, 0.9}};
  return header;
}

/// Coordinates that need every digit of a double; arc lengths increase along each yarn.
inline Frame sample_frame(const FrameHeader& header, int index) {
  std::mt19937_64 random(static_cast<std::uint64_t>(index) + 7);
  std::uniform_real_distribution<double> uniform(-0.1, 0.1);
  Frame frame{index, index / header.frames_per_s, VecX(header.topology.num_coords())};
  for (double& value : frame.q) value = uniform(random);
  for (int visit = 0; visit < header.topology.num_visits(); ++visit) {
    frame.q[header.topology.arc_coord(visit)] =
        header.topology.rest_arc[static_cast<std::size_t>(visit)] + 1e-3 * uniform(random);
  }
  return frame;
}

/// A folder of its own, removed with its content.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "slipstitch-test-XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~TemporaryFolder() {
    std::error_code error;
    std::filesystem::remove_all(path_, error);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline std::string read_bytes(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

inline void write_bytes(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace slipstitch::test
