// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "model/model.h"

namespace slipstitch {

/// Slack of a new point that begins `overlap` deep in something that lets none deeper than `deepest`, where the points
/// that it stands in for were `before` deep: it takes over what they bear. [m]
double first_slack(double overlap, double before, double deepest);
/// That slack a step later: half of what is left to nearly the deepest is made up for, and what is not made use of is
/// gone. To nearly: yarn that is jammed and cannot give way would be pressed ever harder.
double next_slack(double slack, double overlap, double deepest);

/// A point of a yarn's centreline where it can touch something: x = (1 - share) x0 + share x1 on segment `visit`.
struct TouchSample {
  int visit = 0;
  double share = 0.0;           // in [0, 1]
  std::array<int, 6> coords{};  // x0, x1
  bool in_use = true;           // false: others have taken its place
  double slack = 0.0;           // overlap that it came with and may keep, [m]
};

enum class TouchPoints { free, all };  // free: without those that handles move, which go where the script says

/// Every node once, and points between the nodes of every owned segment, at most `spacing` [m] apart at rest.
class TouchSamples {
 public:
  TouchSamples() = default;
  TouchSamples(const Model& model, double spacing, TouchPoints points);

  const TouchSample& operator[](int i) const { return samples_[static_cast<std::size_t>(i)]; }
  int size() const { return static_cast<int>(samples_.size()); }
  bool empty() const { return samples_.empty(); }

  /// Replaces the points of segments that have become so long since, by sliding or stretching, that theirs are more
  /// than 1.2 spacings apart; or that need no third of theirs. Indices stay those of the same points; new ones come
  /// last. `overlap` is how deep a point at x is in what it touches [m], at most `deepest` for a point without slack.
  /// New ones can come deeper, as the old ones let an edge between them: they get slack, which then only shrinks, once
  /// a time `t` [s], however many attempts at the step from there fail.
  void follow(double t, const VecX& q, double deepest, const std::function<double(const Vec3& x)>& overlap);
  /// Whether points of a segment are more than 1.5 spacings apart at q, where it is near(middle, half its length).
  bool outgrown(const VecX& q, const std::function<bool(const Vec3& x, double within)>& near) const;
  long bytes() const;

 private:
  struct Segment {
    int visit = 0, arc_coord = 0;  // of u0; u1 is the next
    std::array<int, 6> coords{};
    int pieces = 0;           // all alike
    std::vector<int> points;  // between them: indices of samples
  };
  double arc_of(const Segment& segment, const VecX& q) const;  // of its yarn, stretched [m]
  void divide(Segment& segment, int pieces);
  void refine(Segment& segment, int pieces);
  void add_point(Segment& segment, double share);
  void tighten(const VecX& q, double deepest, const std::function<double(const Vec3& x)>& overlap);
  int pieces_for(double arc) const;

  double spacing_ = 0.0;
  std::vector<Segment> segments_;  // those that have points between their nodes, or may have
  std::vector<TouchSample> samples_;
  std::vector<int> slack_;  // those with slack
  double tightened_at_ = -1.0;  // time of start [s]; -1: never
};

inline Vec3 place_of(const TouchSample& sample, const VecX& q) {
  return (1.0 - sample.share) * q.segment<3>(sample.coords[0]) + sample.share * q.segment<3>(sample.coords[3]);
}

}  // namespace slipstitch
