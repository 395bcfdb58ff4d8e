// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <cstdint>

#include "run_dir/header_codec.h"
#include "run_paths.h"
#include "sim/monitor.h"

namespace slipstitch::test {
namespace {

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

std::string coordinate_name(const Topology& topology, int coord) {
  const int arc = coord - topology.arc_coord(0);
  if (arc >= 0) return "arc length of visit " + std::to_string(arc);
  return "position of node " + std::to_string(coord / 3);
}

// Empty: none.
std::string frame_difference(const Topology& topology, const Frame& expected, const Frame& found) {
  if (found.index != expected.index) return "its number";
  if (!same_bits(found.t, expected.t)) return "its time";
  if (found.q.size() != topology.num_coords()) return "its length";
  for (int coord = 0; coord < topology.num_coords(); ++coord) {
    if (!same_bits(found.q[coord], expected.q[coord])) return coordinate_name(topology, coord);
  }
  return {};
}

// Visit by visit: positions, and arc lengths where the file has them.
std::string point_difference(const Topology& topology, const Frame& expected, const ParsedFrame& found) {
  std::size_t visit = 0;
  for (std::size_t yarn = 0; yarn < found.yarns.size(); ++yarn) {
    for (const auto& point : found.yarns[yarn]) {
      const int x = topology.x_coord(topology.visit_node[visit++]);
      for (int c = 0; c < 3; ++c) {
        const double exact = expected.q[x + c];
        const double kept = found.single ? rounded_to_float(exact) : exact;
        if (!same_bits(point[static_cast<std::size_t>(c)], kept)) {
          return "position at visit " + std::to_string(visit - 1) + " of yarn " + std::to_string(yarn);
        }
      }
    }
  }
  for (std::size_t i = 0; i < found.arc_length_m.size(); ++i) {
    const int coord = topology.arc_coord(static_cast<int>(i));
    if (!same_bits(found.arc_length_m[i], expected.q[coord])) return coordinate_name(topology, coord);
  }
  return {};
}

std::string file_difference(const Topology& topology, const Frame& expected, const std::optional<ParsedFrame>& found) {
  if (!found) return "malformed, or not called after its frame";
  if (found->t && !same_bits(*found->t, expected.t)) return "its time";
  if (found->yarns.size() != static_cast<std::size_t>(topology.num_yarns())) return "its number of yarns";
  for (std::size_t yarn = 0; yarn < found->yarns.size(); ++yarn) {
    const int visits = topology.yarn_first[yarn + 1] - topology.yarn_first[yarn];
    if (found->yarns[yarn].size() != static_cast<std::size_t>(visits)) return "points of yarn " + std::to_string(yarn);
  }
  const bool has_arcs = !found->arc_length_m.empty();
  if (has_arcs && found->arc_length_m.size() != topology.visit_node.size()) return "its number of arc lengths";
  return point_difference(topology, expected, *found);
}

// `difference(k)`: of frame k, empty when there is none.
template <class Difference>
std::vector<std::string> by_frame(std::size_t expected, std::size_t found, const Difference& difference) {
  std::vector<std::string> lines;
  if (found != expected) lines.push_back(std::to_string(found) + " frames, not " + std::to_string(expected));
  for (std::size_t k = 0; k < std::min(expected, found); ++k) {
    const std::string what = difference(k);
    if (!what.empty()) lines.push_back("frame " + std::to_string(k) + ": " + what);
  }
  return lines;
}

}  // namespace

std::vector<std::string> differences(const ShownRun& expected, const ShownRun& found) {
  if (encode_header(found.header) != encode_header(expected.header)) return {"the header"};
  const Topology& topology = expected.header.topology;
  std::vector<std::string> lines = by_frame(expected.frames.size(), found.frames.size(), [&](std::size_t k) {
    return frame_difference(topology, expected.frames[k], found.frames[k]);
  });
  if (found.state_hash != expected.state_hash) lines.push_back("the state hash reported");
  if (!found.frames.empty() && state_hash(found.frames.back().q) != expected.state_hash) {
    lines.push_back("the state hash of the last frame");
  }
  return lines;
}

std::vector<std::string> differences(const ShownRun& expected, const ParsedFrames& found) {
  const Topology& topology = expected.header.topology;
  return by_frame(expected.frames.size(), found.size(),
                  [&](std::size_t k) { return file_difference(topology, expected.frames[k], found[k]); });
}

PathDifferences differences(const ShownRun& expected, const RunPaths& paths) {
  PathDifferences result;
  for (const auto& [name, run] : paths.runs) result[name] = differences(expected, run);
  for (const auto& [name, frames] : paths.files) result[name] = differences(expected, frames);
  std::erase_if(result, [](const auto& path) { return path.second.empty(); });
  return result;
}

}  // namespace slipstitch::test
