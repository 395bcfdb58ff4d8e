// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "math/types.h"
#include "model/scene.h"
#include "model/topology.h"

namespace slipstitch {

/// One stitch owns the four nodes of its two base clasps, in this order wherever nodes are counted by stitch.
enum BaseNode { kBaseLeft1, kBaseLeft2, kBaseRight1, kBaseRight2 };
inline constexpr int kNodesPerStitch = 4;
inline constexpr int kVisitsPerStitch = 8;

/// The loop's nodes in the yarn's geometric order BL1 BL2 HL1 HL2 HR2 HR1 BR2 BR1: the course above (0 or 1) and the
/// base node of the stitch there.
struct LoopNode {
  int course_above;
  BaseNode base;
};
inline constexpr std::array<LoopNode, kVisitsPerStitch> kLoopNodes{{{0, kBaseLeft1},
                                                                    {0, kBaseLeft2},
                                                                    {1, kBaseLeft1},
                                                                    {1, kBaseLeft2},
                                                                    {1, kBaseRight2},
                                                                    {1, kBaseRight1},
                                                                    {0, kBaseRight2},
                                                                    {0, kBaseRight1}}};

/// One repeat of a knit, drawn or relaxed, ready to be tiled. Stitch s = (course - 1) * repeat.wales + wale - 1.
/// Frame: x course, y wale, z to the right side; period_course along +x; P1 of the first course's bases at y >= 0.
struct RestCell {
  Repeat repeat;
  Vec3 period_course = Vec3::Zero();  // over all wales of the repeat [m]
  Vec3 period_wale = Vec3::Zero();    // over all courses of the repeat [m]
  std::vector<Vec3> node_position;    // (4 * stitches), stitch by stitch in the order of BaseNode
  /// Arc length of the segments that start at the loop's nodes in geometric order, the last one being the sinker to
  /// the right neighbour. rest: what the force terms take as L; start: where the yarn lies now. (8 * stitches) [m]
  std::vector<double> rest_length, start_length;
  /// Nodes in every free segment besides its ends, evenly spaced in arc length: of the segment s, as counted above,
  /// at between[s * extra_nodes], in geometric order. On contact segments, which are free
  /// where a knit begins, they lie straight.
  int extra_nodes = 0;
  std::vector<Vec3> between;   // (8 * stitches * extra_nodes)
  double density_scale = 1.0;  // 1/c_L = true yarn length / length of the polyline

  int stitches() const { return repeat.courses * repeat.wales; }
  /// Stitch of the repeat that the 1-based course and wale (any integers) fall on.
  int stitch_at(int course, int wale) const;
  /// By which the repeat that a stitch of the tiled plane lies in is moved.
  Vec3 shift_of(int course, int wale) const;
  /// Position of a base node of the tiled plane.
  Vec3 position(int course, int wale, BaseNode node) const;
  /// Position of the extra node `piece`, 1 to extra_nodes, of a segment of the tiled plane.
  Vec3 position_between(int course, int wale, int segment, int piece) const;
};

/// The unrelaxed repeat: classical loops in cells of the gauge's size, the extra nodes on straight lines.
RestCell drawn_cell(const Pattern& pattern, const Gauge& gauge, const YarnMaterial& yarn, int extra_nodes = 0);

}  // namespace slipstitch
