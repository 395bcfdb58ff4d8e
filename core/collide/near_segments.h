// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "math/types.h"

namespace slipstitch {

/// Distance of two straight segments, each given by the coordinates of its ends, x0 and x1.
double distance_of_segments(const std::array<int, 6>& a, const std::array<int, 6>& b, const VecX& q);

/// Pairs of straight segments that a move could bring near each other. A search of boxes is good for every move that
/// leaves each end within a margin of where it was searched for, up to a translation of all: only the way of two
/// segments against each other counts. Where few segments leave theirs, as a loose end does, only they are searched
/// for.
class NearSegments {
 public:
  struct Pair {
    int a = 0, b = 0;       // a < b
    double touch = 0.0;     // distance at which they touch [m]
    double distance = 0.0;  // where they were searched for [m]
  };
  /// Distance at which segments a < b touch [m], at most `reach`; negative: never.
  using Touch = std::function<double(int a, int b)>;

  NearSegments() = default;
  /// Segments by the coordinates of their ends. reach, margin [m].
  NearSegments(std::vector<std::array<int, 6>> segments, double reach, double margin);

  /// Makes pairs() hold every pair that can touch and comes within reach anywhere on the way from q to q + dq.
  void cover(const VecX& q, const VecX& dq, const Touch& touch);

  const std::vector<Pair>& pairs() const { return pairs_; }

  long bytes() const;
  long searches() const { return searches_; }  // of boxes

  /// Lower bound of a pair's distance anywhere on the way last covered [m].
  double at_least(const Pair& pair) const {
    return pair.distance - moved_[static_cast<std::size_t>(pair.a)] - moved_[static_cast<std::size_t>(pair.b)];
  }

 private:
  using Ends = std::array<Vec3, 2>;
  struct Way {
    Vec3 from_mean, to_mean;  // translation of all since the search, at either end of the way
  };
  Ends ends_at(std::size_t segment, const VecX& q) const;
  Way measure(const VecX& q, const VecX& dq);
  void place(std::size_t segment, const VecX& q, const VecX& dq, const Way& way);
  void add(int a, int b, const Touch& touch);
  void search_all(const Touch& touch);
  void search_for(std::span<const int> strays, const Touch& touch);

  std::vector<std::array<int, 6>> segments_;
  double reach_ = 0.0, margin_ = 0.0;
  std::vector<Ends> place_;                 // where each was searched for (num_segments); empty: not yet
  std::vector<Eigen::AlignedBox3d> boxes_;  // around the way each was searched for, by half the reach and the margin
  std::vector<double> moved_;               // furthest that an end is from place_ on the way last covered [m]
  std::vector<Pair> pairs_;
  long searches_ = 0;
};

}  // namespace slipstitch
