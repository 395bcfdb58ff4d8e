// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "model/effects.h"
#include "model/material.h"
#include "model/topology.h"

namespace slipstitch {

/// What every frame of a run has in common.
struct FrameHeader {
  Topology topology;
  YarnMaterial yarn;
  double frames_per_s = 0.0;
  int num_frames = 0;  // planned, frame 0 (the start) included
  std::vector<LengthKeyframe> shrinkage;  // of ShrinkageEffect; empty: rest length = arc length
};

/// The full state at an output time. q: full coordinates (topology.h), num_coords.
struct Frame {
  int index = 0;
  double t = 0.0;  // [s]
  VecX q;
};

/// What can be told from one frame.
struct Derived {
  std::vector<double> tension_n;   // per segment, by first visit; 0 where there is no segment (num_visits)
  std::vector<double> wrap_rad;    // signed psi of diagonal (q4,q3) and of (q5,q2): NaN where there is none (2 x contacts)
  std::vector<double> slid_m;      // arc length now minus at the reference frame (num_visits)
};

/// `reference` is the frame that sliding is counted from (usually frame 0).
Derived derive(const FrameHeader& header, const Frame& frame, const Frame& reference);

}  // namespace slipstitch
