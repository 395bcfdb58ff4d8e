// SPDX-License-Identifier: MIT
#include "study/trace_difference.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slipstitch {
namespace {

constexpr double kPartedShare = 1.0 / 3.0;  // of an error, from which on two runs have parted

double or_infinite(double value) { return std::isfinite(value) ? value : std::numeric_limits<double>::infinity(); }

constexpr double kMostNodes = 0.95;

/// The smallest value that most of the others do not exceed; 0 of nothing.
double quantile(std::vector<double>& values) {
  if (values.empty()) return 0.0;
  const auto rank = static_cast<std::size_t>(std::ceil(kMostNodes * static_cast<double>(values.size()))) - 1;
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

void raise(double& most, double a, double b) { most = std::max(most, or_infinite(std::abs(a - b))); }

}  // namespace

TraceDifference difference(const FrameTrace& a, const FrameTrace& b) {
  TraceDifference result;
  for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) {
    const Eigen::Index coords = std::min(a.x[k].size(), b.x[k].size());
    double most = 0.0, sum = 0.0;
    std::vector<double> squares;
    int node = 0;
    for (Eigen::Index i = 0; i < coords; i += 3) {
      const double square = or_infinite((a.x[k].segment<3>(i) - b.x[k].segment<3>(i)).squaredNorm());
      if (square > most) {
        most = square;
        node = static_cast<int>(i / 3);
      }
      sum += square;
      squares.push_back(square);
    }
    result.max_m.push_back(std::sqrt(most));
    result.node.push_back(node);
    result.most_m.push_back(std::sqrt(quantile(squares)));
    result.mean_m2.push_back(coords > 0 ? 3.0 * sum / static_cast<double>(coords) : 0.0);
    raise(result.stored_j, a.stored_j[k], b.stored_j[k]);
    raise(result.force_n, a.force_n[k], b.force_n[k]);
    raise(result.length_m, a.length_m[k], b.length_m[k]);
  }
  return result;
}

double largest(const std::vector<double>& by_frame, std::size_t frames) {
  double most = 0.0;
  for (std::size_t k = 0; k < std::min(frames, by_frame.size()); ++k) most = std::max(most, by_frame[k]);
  return most;
}

std::size_t place_of_largest(const std::vector<double>& by_frame, std::size_t frames) {
  const auto end = by_frame.begin() + static_cast<std::ptrdiff_t>(std::min(frames, by_frame.size()));
  return static_cast<std::size_t>(std::max_element(by_frame.begin(), end) - by_frame.begin());
}

double root_mean(const std::vector<double>& by_frame, std::size_t frames) {
  const std::size_t count = std::min(frames, by_frame.size());
  double sum = 0.0;
  for (std::size_t k = 0; k < count; ++k) sum += by_frame[k];
  return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0.0;
}

std::size_t predictable_frames(const std::vector<double>& error_m, const std::vector<double>& parting_m,
                               double least_m) {
  std::size_t frames = std::min(error_m.size(), parting_m.size());
  for (;;) {  // shorter by a frame at least
    const double allowed = kPartedShare * std::max(least_m, largest(error_m, frames));
    std::size_t first = 0;
    while (first < frames && parting_m[first] <= allowed) ++first;
    if (first == frames) return frames;
    frames = first;
  }
}

}  // namespace slipstitch
