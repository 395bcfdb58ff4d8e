// SPDX-License-Identifier: MIT
#include "force/self_collision.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "collide/closest_point.h"
#include "force/gap_energy.h"
#include "force/script_push.h"
#include "force/scripted_nodes.h"
#include "force/segments.h"
#include "force/touch_samples.h"
#include "math/bytes.h"
#include "model/pattern_places.h"

namespace slipstitch {
namespace {

constexpr double kStiffness = 1e-3;  // of EA
constexpr double kDeepest = 0.1;     // overlap, of d and at most of R
constexpr double kWatched = 0.5;     // radii beyond d from which pairs become stencils along with those that must
constexpr double kMargin = 0.5;      // radii of relative motion that a search of boxes lasts for
constexpr double kGrown = 1.2, kOutgrown = 1.5,
                 kShrunk = 3.0;         // times its length that a segment may be before it gets other points
constexpr double kClosestPoints = 0.1;  // radii between two points of a segment, where yarn starts that close
constexpr int kPatternReach = 3;        // courses and wales
constexpr double kRoundOff = 1e-9;      // share of 2R by which yarns that are laid to touch may overlap
constexpr double kKeep = 0.1;           // share of the way to the deepest overlap that one Newton step leaves

Vec3 at(const std::array<int, 6>& coords, double share, const VecX& q) {
  return (1.0 - share) * q.segment<3>(coords[0]) + share * q.segment<3>(coords[3]);
}

/// How much two segments can come closer while q moves by dq.
double approach(const std::array<int, 6>& a, const std::array<int, 6>& b, const VecX& dq) {
  double most = 0.0;
  for (int i : {0, 3})
    for (int j : {0, 3})
      most = std::max(
          most, (dq.segment<3>(a[static_cast<std::size_t>(i)]) - dq.segment<3>(b[static_cast<std::size_t>(j)])).norm());
  return most;
}

/// Whether segments with ends q come within `reach` of each other.
bool touches(const Vec<12>& q, double reach) {
  const Vec3 a0 = q.segment<3>(0), a1 = q.segment<3>(3), b0 = q.segment<3>(6), b1 = q.segment<3>(9);
  const SegmentPair close = closest_of_segments(a0, a1, b0, b1);
  return (a0 + close.s * (a1 - a0) - b0 - close.t * (b1 - b0)).squaredNorm() <= reach * reach;
}

/// Adds the block of a point pair with weights w on x0, x1, y0, y1.
void spread(const std::array<double, 4>& w, const Mat3& block, Mat<12>& hess) {
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      hess.block<3, 3>(3 * i, 3 * j) += w[static_cast<std::size_t>(i)] * w[static_cast<std::size_t>(j)] * block;
}

Vec3 weighted(const std::array<double, 4>& w, const Vec<12>& q) {
  return w[0] * q.segment<3>(0) + w[1] * q.segment<3>(3) + w[2] * q.segment<3>(6) + w[3] * q.segment<3>(9);
}

}  // namespace

SelfCollision::SelfCollision(const Model& model) {
  const auto& effect = model.effects.self_collision;
  if (!effect) return;
  const Topology& topology = model.topology;
  radius_ = model.yarn.radius_m;
  k_ = effect->stiffness_n.value_or(kStiffness * model.yarn.stretch_n);
  const std::vector<char> held = scripted_nodes(model);
  for_each_owned_segment(topology, [&](int, int i) {
    const auto v = static_cast<std::size_t>(i);
    const int x0 = position_coord(topology, i), x1 = position_coord(topology, i + 1);
    Segment segment{i, {x0, x0 + 1, x0 + 2, x1, x1 + 1, x1 + 2}};
    for (std::size_t end : {0, 1})
      segment.held[end] = held[static_cast<std::size_t>(topology.visit_node[v + end])] != 0;
    segment.arc_coord = topology.arc_coord(i);
    segment.sampled = rest_length(topology, i);
    segments_.push_back(segment);
  });
  if (segments_.empty()) return;
  find_neighbours(topology);
  find_start_distances(model);
  near_ = NearSegments(segment_ends(), (2.0 + kWatched) * radius_, kMargin * radius_);
}

void SelfCollision::find_neighbours(const Topology& topology) {
  joined_.resize(static_cast<std::size_t>(topology.num_nodes));
  for (int n = 0; n < topology.num_nodes; ++n) joined_[static_cast<std::size_t>(n)] = {n};
  for (const Segment& segment : segments_) {
    const int n0 = segment.coords[0] / 3, n1 = segment.coords[3] / 3;
    joined_[static_cast<std::size_t>(n0)].push_back(n1);
    joined_[static_cast<std::size_t>(n1)].push_back(n0);
  }
  for (auto& nodes : joined_) std::sort(nodes.begin(), nodes.end());
}

bool SelfCollision::neighbours(const Segment& a, const Segment& b) const {
  for (int i : {a.coords[0] / 3, a.coords[3] / 3})
    for (int j : {b.coords[0] / 3, b.coords[3] / 3})
      if (std::binary_search(joined_[static_cast<std::size_t>(i)].begin(), joined_[static_cast<std::size_t>(i)].end(),
                             j))
        return true;
  return false;
}

std::vector<std::array<int, 6>> SelfCollision::segment_ends() const {
  std::vector<std::array<int, 6>> ends;
  for (const Segment& segment : segments_) ends.push_back(segment.coords);
  return ends;
}

bool SelfCollision::can_touch(int a, int b) const {
  const Segment &sa = segments_[static_cast<std::size_t>(a)], &sb = segments_[static_cast<std::size_t>(b)];
  const bool held = sa.held[0] && sa.held[1] && sb.held[0] && sb.held[1];
  return !held && !neighbours(sa, sb);
}

void SelfCollision::find_start_distances(const Model& model) {
  const PatternPlaces places(model.topology);
  const double diameter = 2.0 * radius_;
  NearSegments start(segment_ends(), diameter, 0.0);
  start.cover(model.start_q, VecX::Zero(model.start_q.size()),
              [&](int a, int b) { return can_touch(a, b) ? diameter : -1.0; });
  for (const NearSegments::Pair& pair : start.pairs()) {
    if (pair.distance >= diameter) continue;
    start_distance_[key(pair.a, pair.b)] = pair.distance;
    const int i = segments_[static_cast<std::size_t>(pair.a)].visit,
              j = segments_[static_cast<std::size_t>(pair.b)].visit;
    const bool related = places.near_in_pattern(i, j, kPatternReach) || places.near_on_yarn(i, j, kPi * radius_);
    if (!related && pair.distance < (1.0 - kRoundOff) * diameter) ++start_overlaps_;
  }
}

double SelfCollision::contact_distance(int a, int b) const {
  const auto start = start_distance_.find(key(a, b));
  return start == start_distance_.end() ? 2.0 * radius_ : start->second;
}

long SelfCollision::search_bytes() const {
  return near_.bytes() + bytes_of(segments_, joined_, pairs_) +
         static_cast<long>(start_distance_.size() * sizeof(*start_distance_.begin()) + taken_.size() * sizeof(long));
}

double SelfCollision::depth(const Pair& pair) const { return kDeepest * std::min(pair.distance, radius_); }

template <class F>
void SelfCollision::for_each_point_pair(const Pair& pair, F&& f) const {
  for (int i = 0; i < pair.pieces_a; ++i)
    for (int j = 0; j < pair.pieces_b; ++j) {
      const double s = (i + 0.5) / pair.pieces_a, t = (j + 0.5) / pair.pieces_b;
      f(std::array<double, 4>{1.0 - s, s, t - 1.0, -t});
    }
}

std::array<int, 12> SelfCollision::coords(int k) const {
  const Pair& pair = pairs_[static_cast<std::size_t>(k)];
  std::array<int, 12> all;
  std::copy_n(segments_[static_cast<std::size_t>(pair.a)].coords.begin(), 6, all.begin());
  std::copy_n(segments_[static_cast<std::size_t>(pair.b)].coords.begin(), 6, all.begin() + 6);
  return all;
}

double SelfCollision::eval(int k, const Vec<12>& q, Vec<12>* g, Mat<12>* hess) const {
  const Pair& pair = pairs_[static_cast<std::size_t>(k)];
  if (g) g->setZero();
  if (hess) hess->setZero();
  if (!touches(q, pair.distance)) return 0.0;  // most pairs are only watched
  double sum = 0.0;
  for_each_point_pair(pair, [&](const std::array<double, 4>& w) {
    const Vec3 p = weighted(w, q);
    const double length = p.norm();
    if (length >= pair.distance) return;
    const GapEnergy e = gap_energy(k_, depth(pair), length - pair.distance);
    sum += e.value;
    if (!std::isfinite(e.value)) return;
    const Vec3 n = p / length;
    if (g)
      for (int i = 0; i < 4; ++i) g->segment<3>(3 * i) += w[static_cast<std::size_t>(i)] * e.slope * n;
    if (hess)
      spread(w, (e.curvature - e.slope / length) * n * n.transpose() + e.slope / length * Mat3::Identity(), *hess);
  });
  return sum;
}

void SelfCollision::convex_hessian(int k, const Vec<12>& q, Mat<12>& hess) const {
  const Pair& pair = pairs_[static_cast<std::size_t>(k)];
  hess.setZero();
  for_each_point_pair(pair, [&](const std::array<double, 4>& w) {
    const Vec3 p = weighted(w, q);
    const double length = p.norm();
    if (length >= pair.distance) return;
    const Vec3 n = p / length;
    spread(w, gap_energy(k_, depth(pair), length - pair.distance).curvature * n * n.transpose(), hess);
  });
}

int SelfCollision::pieces(const Segment& segment, double distance) const {
  const double apart = std::clamp(distance, kClosestPoints * radius_, radius_);
  return 1 + static_cast<int>(std::ceil(segment.sampled / apart));
}

double SelfCollision::length_of(const Segment& segment, const VecX& q) {
  const double length = (q.segment<3>(segment.coords[3]) - q.segment<3>(segment.coords[0])).norm();
  return std::max(length, q[segment.arc_coord + 1] - q[segment.arc_coord]);
}

/// Gives segments that have become much longer or shorter, by sliding or stretching, other points. Returns whether
/// there were any.
bool SelfCollision::follow(const VecX& q) {
  std::vector<char> changed(segments_.size(), 0);
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    Segment& segment = segments_[i];
    const double arc = length_of(segment, q);
    const double least = std::max(segment.sampled, radius_);
    if (arc <= kGrown * least && kShrunk * arc >= segment.sampled - radius_) continue;
    segment.sampled = arc;
    changed[i] = 1;
  }
  if (std::find(changed.begin(), changed.end(), 1) == changed.end()) return false;
  renew_points(q, changed);
  return true;
}

/// Of the stencils, which are all that touch.
void SelfCollision::renew_points(const VecX& q, const std::vector<char>& changed) {
  for (const Pair& old : pairs_) {
    if (!changed[static_cast<std::size_t>(old.a)] && !changed[static_cast<std::size_t>(old.b)]) continue;
    slack_.erase(key(old.a, old.b));
    const Pair pair = pair_of(old.a, old.b, contact_distance(old.a, old.b));
    const double before = old.distance - closest_points(old, q), now = pair.distance - closest_points(pair, q);
    const double slack = first_slack(now, before, depth(pair));
    if (slack > 0.0) slack_[key(old.a, old.b)] = slack;
  }
}

/// Makes up for slack.
void SelfCollision::tighten(const VecX& q) {
  if (slack_.empty()) return;
  const long num = static_cast<long>(segments_.size());
  for (auto& [key, slack] : slack_) {
    const int a = static_cast<int>(key / num), b = static_cast<int>(key % num);
    const Pair pair = pair_of(a, b, contact_distance(a, b));
    slack = next_slack(slack, pair.distance + slack - closest_points(pair, q), depth(pair));
  }
  for (Pair& pair : pairs_)
    if (slack_.contains(key(pair.a, pair.b))) pair = pair_of(pair.a, pair.b, contact_distance(pair.a, pair.b));
  std::erase_if(slack_, [](const auto& entry) { return entry.second == 0.0; });
}

double SelfCollision::closest_points(const Pair& pair, const VecX& q) const {
  const auto &a = segments_[static_cast<std::size_t>(pair.a)].coords,
             &b = segments_[static_cast<std::size_t>(pair.b)].coords;
  double least = std::numeric_limits<double>::infinity();
  for_each_point_pair(pair, [&](const std::array<double, 4>& w) {
    least = std::min(least, (at(a, w[1], q) - at(b, -w[3], q)).norm());
  });
  return least;
}

SelfCollision::Pair SelfCollision::pair_of(int a, int b, double touch) const {
  const auto slack = slack_.find(key(a, b));
  return {a, b, pieces(segments_[static_cast<std::size_t>(a)], touch),
          pieces(segments_[static_cast<std::size_t>(b)], touch), touch - (slack == slack_.end() ? 0.0 : slack->second)};
}

void SelfCollision::drop_idle(const VecX& q) {
  const auto idle = std::count_if(pairs_.begin(), pairs_.end(), [&](const Pair& pair) {
    return distance_of_segments(segments_[static_cast<std::size_t>(pair.a)].coords,
                                segments_[static_cast<std::size_t>(pair.b)].coords,
                                q) > pair.distance + kWatched * radius_;
  });
  if (2 * idle > static_cast<long>(pairs_.size())) forget_pairs();
}

void SelfCollision::forget_pairs() {
  pairs_.clear();
  taken_.clear();
  ++revision_;
}

void SelfCollision::begin_step(const StepContext& step) {
  if (segments_.empty()) return;
  if (step.start.t != tightened_at_) tighten(step.start.q);  // attempts that fail are no steps
  tightened_at_ = step.start.t;
  if (follow(step.start.q)) {
    forget_pairs();
  } else {
    drop_idle(step.start.q);
  }
  watch(step.start.q, step.start.q, 0.0);
}

void SelfCollision::watch(const VecX& q, const VecX& way, double share) {
  if (segments_.empty()) return;
  const VecX dq = share * way;
  near_.cover(q, dq, [&](int a, int b) { return can_touch(a, b) ? contact_distance(a, b) : -1.0; });
  std::vector<NearSegments::Pair> close;
  bool must = false;
  for (const NearSegments::Pair& pair : near_.pairs()) {
    const double watched = pair.touch + kWatched * radius_;
    if (near_.at_least(pair) > watched || taken_.contains(key(pair.a, pair.b))) continue;
    const auto &a = segments_[static_cast<std::size_t>(pair.a)].coords,
               &b = segments_[static_cast<std::size_t>(pair.b)].coords;
    const double least = distance_of_segments(a, b, q) - approach(a, b, dq);
    if (least <= watched) close.push_back(pair);
    must = must || least <= pair.touch;
  }
  if (!must) return;
  for (const NearSegments::Pair& pair : close) {
    pairs_.push_back(pair_of(pair.a, pair.b, pair.touch));
    taken_.insert(key(pair.a, pair.b));
  }
}

double SelfCollision::max_step(const VecX& q, const VecX& dq, double a) const {
  for (const Pair& pair : pairs_) {
    const auto &ca = segments_[static_cast<std::size_t>(pair.a)].coords,
               &cb = segments_[static_cast<std::size_t>(pair.b)].coords;
    const double way = a * approach(ca, cb, dq);
    if (!(way > 0.0) || distance_of_segments(ca, cb, q) - way > pair.distance) continue;
    for_each_point_pair(pair, [&](const std::array<double, 4>& w) {
      const Vec3 p = at(ca, w[1], q) - at(cb, -w[3], q), dp = at(ca, w[1], dq) - at(cb, -w[3], dq);
      const double left = p.norm() - room(pair);
      a *= first_reach(p, a * dp, room(pair) + kKeep * std::min(left, depth(pair)));
    });
  }
  return a;
}

bool SelfCollision::outgrown(const VecX& q) const {
  const auto grown = [&](int i) {
    const Segment& segment = segments_[static_cast<std::size_t>(i)];
    return length_of(segment, q) > kOutgrown * std::max(segment.sampled, radius_);
  };
  return std::any_of(pairs_.begin(), pairs_.end(), [&](const Pair& pair) {
    if (!grown(pair.a) && !grown(pair.b)) return false;
    return distance_of_segments(segments_[static_cast<std::size_t>(pair.a)].coords,
                                segments_[static_cast<std::size_t>(pair.b)].coords, q) < pair.distance;
  });
}

bool SelfCollision::passes(const VecX& q0, const VecX& q) {
  if (segments_.empty()) return false;
  const VecX dq = q - q0;
  watch(q0, dq, 1.0);
  return std::any_of(pairs_.begin(), pairs_.end(), [&](const Pair& pair) {
    const auto &a = segments_[static_cast<std::size_t>(pair.a)].coords,
               &b = segments_[static_cast<std::size_t>(pair.b)].coords;
    bool passed = false;
    for_each_point_pair(pair, [&](const std::array<double, 4>& w) {
      const Vec3 p = at(a, w[1], q0) - at(b, -w[3], q0), dp = at(a, w[1], dq) - at(b, -w[3], dq);
      passed = passed || first_reach(p, dp, 0.5 * pair.distance) < 1.0;
    });
    return passed;
  });
}

bool SelfCollision::push_apart(const Pair& pair, const VecX& q0, VecX& q) const {
  const Segment &a = segments_[static_cast<std::size_t>(pair.a)], &b = segments_[static_cast<std::size_t>(pair.b)];
  const std::array<int, 4> x{a.coords[0], a.coords[3], b.coords[0], b.coords[3]};
  const std::array<bool, 4> held{a.held[0], a.held[1], b.held[0], b.held[1]};
  bool moved = false;
  for_each_point_pair(pair, [&](std::array<double, 4> w) {
    const Vec3 p = at(a.coords, w[1], q) - at(b.coords, -w[3], q);
    const double gap = p.norm() - pair.distance;
    if (gap > -kPushedOverlap * depth(pair)) return;
    const double gap0 = (at(a.coords, w[1], q0) - at(b.coords, -w[3], q0)).norm() - pair.distance;
    const double push = push_needed(depth(pair), gap, gap0);
    if (push == 0.0) return;
    double norm = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
      if (held[i]) w[i] = 0.0;
      norm += w[i] * w[i];
    }
    if (!(norm > 0.0)) return;
    for (std::size_t i = 0; i < 4; ++i) q.segment<3>(x[i]) += w[i] / norm * push * p.normalized();
    moved = true;
  });
  return moved;
}

void SelfCollision::push_out(const VecX& q0, VecX& q) {
  if (segments_.empty() || q0 == q) return;
  for (int i = 0; i < kMaxPushes; ++i) {
    watch(q0, q - q0, 1.0);
    bool moved = false;
    for (const Pair& pair : pairs_) moved = push_apart(pair, q0, q) || moved;
    if (!moved) return;
  }
}

}  // namespace slipstitch
