// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "math/types.h"

namespace slipstitch {

/// A loop as it is drawn before anything relaxes: the centreline
///   x = W/(2 pi) (t + a sin 2t),  y = H cos t,  z = -s D cos 2t,   t in [-pi, pi], sinker middles at the ends,
/// W the wale pitch, a = kLean, H = kReach * course pitch, s = +1 where the stitch shows its legs (knit), -1 purl.
/// Curve family: Crane, "A simple parametric model of plain-knit yarns" (2023, keenancrane/plain-knit-yarn).
/// With O the loop of the course below and N this one, yarns cross at P1 = (O leg) x (N sinker) and P2 = (N leg) x
/// (O head); D keeps them 2R apart there.
struct DrawnLoop {
  double width_m = 0.0, height_m = 0.0;  // cell: wale pitch, course pitch
  double depth_m = 0.0;                  // D
  double sinker_t = 0.0;                 // P1 on N: t = -+(pi - sinker_t); P2 on O: t = -+sinker_t
  double leg_t = 0.0;                    // P1 on O: t = -+leg_t;           P2 on N: t = -+(pi - leg_t)

  // The shared nodes, at the ends of the zone where the loops touch, from the wale's middle and from the height of P1
  // at the loop's base. z for a knit clasp.
  double p1_x = 0.0, p2_x = 0.0;  // half distances between left and right clasp
  double p2_y = 0.0;              // P2 above P1
  double z = 0.0;                 // mean of the two centrelines
};

DrawnLoop draw_loop(double width_m, double height_m, double radius_m);

/// Which way the yarn lies, +1 knit and -1 purl: at this loop's base, at its head (the kind of the stitch above) and
/// at the bases of its left and right neighbours.
struct LoopFaces {
  double base = 1.0, head = 1.0, left = 1.0, right = 1.0;
};

/// Point of the centreline, origin at the wale's middle and the curve's mean height. Between clasps of different
/// kinds the depth blends smoothly.
Vec3 centreline(const DrawnLoop& loop, const LoopFaces& faces, double t);

/// Length of the centreline of one loop [m].
double centreline_length(const DrawnLoop& loop, const LoopFaces& faces);

}  // namespace slipstitch
