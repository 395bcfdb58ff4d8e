// SPDX-License-Identifier: MIT
#include "force/touch_samples.h"

#include <algorithm>
#include <cmath>

#include "force/scripted_nodes.h"
#include "force/segments.h"
#include "math/bytes.h"

namespace slipstitch {
namespace {

constexpr double kFarApart = 1.2;  // spacings
constexpr double kOutgrown = 1.5;
constexpr double kTooMany = 3.0;  // times the pieces that would do

// In shares of the deepest overlap: what a new point has of it, at least, so that it is given next to no push, and at
// most; and which share of the rest it takes up in a step.
constexpr double kLeastFirst = 0.1, kMostFirst = 0.9, kTightened = 0.5;

}  // namespace

double first_slack(double overlap, double before, double deepest) {
  return std::max(0.0, overlap - std::clamp(before, kLeastFirst * deepest, kMostFirst * deepest));
}

double next_slack(double slack, double overlap, double deepest) {
  const double left = std::max(0.0, kMostFirst * deepest - (overlap - slack));
  return std::clamp(slack - kTightened * left, 0.0, std::max(0.0, overlap));
}

TouchSamples::TouchSamples(const Model& model, double spacing, TouchPoints points) : spacing_(spacing) {
  const Topology& topology = model.topology;
  std::vector<char> scripted = scripted_nodes(model);
  if (points == TouchPoints::all) scripted.assign(scripted.size(), 0);
  std::vector<char> taken(scripted.size(), 0);
  for_each_owned_segment(topology, [&](int, int i) {
    const auto v = static_cast<std::size_t>(i);
    const int n0 = topology.visit_node[v], n1 = topology.visit_node[v + 1];
    const int x0 = topology.x_coord(n0), x1 = topology.x_coord(n1);
    Segment segment{i, topology.arc_coord(i), {x0, x0 + 1, x0 + 2, x1, x1 + 1, x1 + 2}, 0, {}};
    const auto add_node = [&](int node, double share) {
      const auto n = static_cast<std::size_t>(node);
      if (!taken[n] && !scripted[n]) samples_.push_back({i, share, segment.coords});
      taken[n] = 1;
    };
    add_node(n0, 0.0);
    add_node(n1, 1.0);
    if (scripted[static_cast<std::size_t>(n0)] && scripted[static_cast<std::size_t>(n1)]) return;
    divide(segment, pieces_for(rest_length(topology, i)));
    segments_.push_back(segment);
  });
}

int TouchSamples::pieces_for(double arc) const {
  return std::max(1, static_cast<int>(std::ceil(arc / spacing_ - 1e-9)));
}

double TouchSamples::arc_of(const Segment& segment, const VecX& q) const {
  const double length = (q.segment<3>(segment.coords[3]) - q.segment<3>(segment.coords[0])).norm();
  return std::max(length, q[segment.arc_coord + 1] - q[segment.arc_coord]);
}

void TouchSamples::divide(Segment& segment, int pieces) {
  for (const int i : segment.points) samples_[static_cast<std::size_t>(i)].in_use = false;
  segment.pieces = pieces;
  segment.points.clear();
  for (int k = 1; k < pieces; ++k) add_point(segment, static_cast<double>(k) / pieces);
}

/// Halves the pieces until there are as many. The points that there were stay, and bear what they bore: where all were
/// new ones with slack, a body would come deeper each time.
void TouchSamples::refine(Segment& segment, int pieces) {
  while (segment.pieces < pieces) {
    for (int k = 0; k < segment.pieces; ++k) add_point(segment, (k + 0.5) / segment.pieces);
    segment.pieces *= 2;
  }
}

void TouchSamples::add_point(Segment& segment, double share) {
  segment.points.push_back(size());
  samples_.push_back({segment.visit, share, segment.coords});
}

void TouchSamples::tighten(const VecX& q, double deepest, const std::function<double(const Vec3& x)>& overlap) {
  for (const int i : slack_) {
    TouchSample& sample = samples_[static_cast<std::size_t>(i)];
    sample.slack = next_slack(sample.slack, overlap(place_of(sample, q)), deepest);
  }
  std::erase_if(slack_, [&](int i) { return (*this)[i].slack == 0.0 || !(*this)[i].in_use; });
}

void TouchSamples::follow(double t, const VecX& q, double deepest,
                          const std::function<double(const Vec3& x)>& overlap) {
  if (t != tightened_at_) tighten(q, deepest, overlap);
  tightened_at_ = t;
  for (Segment& segment : segments_) {
    const double arc = arc_of(segment, q);
    const int wanted = pieces_for(arc);
    const bool far_apart = arc > kFarApart * spacing_ * segment.pieces;
    if (!far_apart && kTooMany * wanted >= segment.pieces) continue;
    double before = std::max(overlap(q.segment<3>(segment.coords[0])), overlap(q.segment<3>(segment.coords[3])));
    for (const int i : segment.points) before = std::max(before, overlap(place_of((*this)[i], q)) - (*this)[i].slack);
    const int first_new = size();
    if (far_apart) {
      refine(segment, wanted);
    } else {
      divide(segment, wanted);
    }
    for (int i = first_new; i < size(); ++i) {
      TouchSample& sample = samples_[static_cast<std::size_t>(i)];
      sample.slack = first_slack(overlap(place_of(sample, q)), before, deepest);
      if (sample.slack > 0.0) slack_.push_back(i);
    }
  }
}

bool TouchSamples::outgrown(const VecX& q, const std::function<bool(const Vec3& x, double within)>& near) const {
  return std::any_of(segments_.begin(), segments_.end(), [&](const Segment& segment) {
    if (arc_of(segment, q) <= kOutgrown * spacing_ * segment.pieces) return false;
    const Vec3 x0 = q.segment<3>(segment.coords[0]), x1 = q.segment<3>(segment.coords[3]);
    return near(0.5 * (x0 + x1), 0.5 * (x1 - x0).norm());
  });
}

long TouchSamples::bytes() const { return bytes_of(segments_, samples_, slack_); }

}  // namespace slipstitch
