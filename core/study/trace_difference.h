// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "study/frame_trace.h"

namespace slipstitch {

/// Between two runs, over the frames and nodes that both have. What is not finite counts as infinitely far.
struct TraceDifference {
  std::vector<double> max_m;                             // of any node, by frame
  std::vector<int> node;                                 // that one
  std::vector<double> most_m;                            // that 95 of 100 nodes keep to, by frame
  std::vector<double> mean_m2;                           // of squares, over nodes, by frame
  double stored_j = 0.0, force_n = 0.0, length_m = 0.0;  // of what a trace has of every frame, the largest
};
TraceDifference difference(const FrameTrace& a, const FrameTrace& b);

/// Over the first frames.
double largest(const std::vector<double>& by_frame, std::size_t frames);
std::size_t place_of_largest(const std::vector<double>& by_frame, std::size_t frames);
double root_mean(const std::vector<double>& by_frame, std::size_t frames);

/// Frames from the start on in which positions can be told to the largest error in them, or to `least_m` if that is
/// more: two runs that begin almost alike part by a third of it at most.
std::size_t predictable_frames(const std::vector<double>& error_m, const std::vector<double>& parting_m,
                               double least_m);

}  // namespace slipstitch
