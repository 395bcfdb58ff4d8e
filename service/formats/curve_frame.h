// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "sim/frame.h"

namespace slipstitch {

/// A frame as every format shows it: one open polyline a yarn, one point a visit, in yarn order. The points are the
/// node positions themselves, so the exact state can be read back; a contact appears once in each of its yarns.
struct CurveFrame {
  int index = 0;
  double t = 0.0;  // [s]
  double radius_m = 0.0;
  std::vector<int> first;                       // first point of each yarn, closed by the number of points
  std::vector<Vec3> points;                     // [m]
  std::vector<double> arc_length_m;             // per point
  std::vector<double> slid_m;                   // per point, since the reference frame
  std::vector<double> tension_n;                // per point: mean of the segments that meet there
  std::vector<std::array<double, 2>> wrap_rad;  // per contact, as in Derived; NaN where there is none

  int num_yarns() const { return static_cast<int>(first.size()) - 1; }
};

CurveFrame make_curve_frame(const FrameHeader& header, const Frame& frame, const Frame& reference);

}  // namespace slipstitch
