// SPDX-License-Identifier: MIT
#include "force/self_collision.h"

#include <algorithm>
#include <cmath>

#include "collide/closest_point.h"
#include "collide/overlaps.h"
#include "force/gap_energy.h"
#include "force/scripted_nodes.h"
#include "force/segments.h"

namespace slipstitch {
namespace {

constexpr double kStiffness = 1e-3;  // of EA
constexpr double kDeepest = 0.1;     // overlap, of d and at most of R
constexpr double kWatched = 0.5;     // radii beyond d from which pairs are stencils
constexpr int kMaxPushes = 100;
constexpr std::size_t kFewMoving = 16;  // segments for which no tree is worth building
constexpr double kKeep = 0.1;           // share of the way to the deepest overlap that one Newton step leaves

Vec3 at(const std::array<int, 6>& coords, double share, const VecX& q) {
  return (1.0 - share) * q.segment<3>(coords[0]) + share * q.segment<3>(coords[3]);
}

template <class Vector>
double distance(const std::array<int, 6>& a, const std::array<int, 6>& b, const Vector& q) {
  const Vec3 a0 = q.template segment<3>(a[0]), a1 = q.template segment<3>(a[3]);
  const Vec3 b0 = q.template segment<3>(b[0]), b1 = q.template segment<3>(b[3]);
  const SegmentPair close = closest_of_segments(a0, a1, b0, b1);
  return (a0 + close.s * (a1 - a0) - b0 - close.t * (b1 - b0)).norm();
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
  start_q_ = model.start_q;
  const std::vector<char> held = scripted_nodes(model);
  for_each_owned_segment(topology, [&](int, int i) {
    const auto v = static_cast<std::size_t>(i);
    const int x0 = position_coord(topology, i), x1 = position_coord(topology, i + 1);
    Segment segment{{x0, x0 + 1, x0 + 2, x1, x1 + 1, x1 + 2}};
    for (std::size_t end : {0, 1})
      segment.held[end] = held[static_cast<std::size_t>(topology.visit_node[v + end])] != 0;
    segment.pieces = 1 + static_cast<int>(std::ceil(rest_length(topology, i) / radius_));
    segments_.push_back(segment);
  });
  find_neighbours(topology);
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

double SelfCollision::contact_distance(const Segment& a, const Segment& b) const {
  return std::min(2.0 * radius_, distance(a.coords, b.coords, start_q_));
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
  if (distance({0, 1, 2, 3, 4, 5}, {6, 7, 8, 9, 10, 11}, q) > pair.distance) return 0.0;  // most pairs are only watched
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

bool SelfCollision::add_pair(int a, int b) {
  const Segment &sa = segments_[static_cast<std::size_t>(a)], &sb = segments_[static_cast<std::size_t>(b)];
  const long key = static_cast<long>(a) * static_cast<long>(segments_.size()) + b;
  if (!pair_index_.emplace(key, size()).second) return false;
  pairs_.push_back({a, b, sa.pieces, sb.pieces, contact_distance(sa, sb)});
  return true;
}

void SelfCollision::begin_step(const StepContext& step) {
  if (segments_.empty()) return;
  pairs_.clear();
  pair_index_.clear();
  ++revision_;
  watch(step.start.q, step.start.q, 0.0);
}

Eigen::AlignedBox3d SelfCollision::swept_box(const Segment& segment, const VecX& q, const VecX& dq) const {
  Eigen::AlignedBox3d box;
  for (int c : {segment.coords[0], segment.coords[3]}) {
    box.extend(Vec3(q.segment<3>(c)));
    box.extend(Vec3(q.segment<3>(c) + dq.segment<3>(c)));
  }
  const double margin = 0.5 * (2.0 + kWatched) * radius_;
  box.min().array() -= margin;
  box.max().array() += margin;
  return box;
}

void SelfCollision::watch(const VecX& q, const VecX& way, double share) {
  if (segments_.empty()) return;
  const VecX dq = share * way;
  std::vector<Eigen::AlignedBox3d> boxes;
  std::vector<int> moving;
  for (int i = 0; i < static_cast<int>(segments_.size()); ++i) {
    const Segment& segment = segments_[static_cast<std::size_t>(i)];
    boxes.push_back(swept_box(segment, q, dq));
    if (!dq.segment<3>(segment.coords[0]).isZero(0.0) || !dq.segment<3>(segment.coords[3]).isZero(0.0))
      moving.push_back(i);
  }
  const auto before = pairs_.size();
  const auto consider = [&](int a, int b) {
    const Segment &sa = segments_[static_cast<std::size_t>(a)], &sb = segments_[static_cast<std::size_t>(b)];
    const bool held = sa.held[0] && sa.held[1] && sb.held[0] && sb.held[1];
    if (held || neighbours(sa, sb)) return;
    const double reach = contact_distance(sa, sb) + kWatched * radius_ + approach(sa.coords, sb.coords, dq);
    if (distance(sa.coords, sb.coords, q) <= reach) add_pair(a, b);
  };
  if (!moving.empty() && moving.size() <= kFewMoving) {
    for (int a : moving)
      for (int b = 0; b < static_cast<int>(boxes.size()); ++b)
        if (a != b && boxes[static_cast<std::size_t>(a)].intersects(boxes[static_cast<std::size_t>(b)]))
          consider(std::min(a, b), std::max(a, b));
  } else {
    for_each_overlap(boxes, consider);
  }
  if (pairs_.size() != before) ++revision_;
}

double SelfCollision::max_step(const VecX& q, const VecX& dq, double a) const {
  for (const Pair& pair : pairs_) {
    const auto &ca = segments_[static_cast<std::size_t>(pair.a)].coords,
               &cb = segments_[static_cast<std::size_t>(pair.b)].coords;
    const double way = a * approach(ca, cb, dq);
    if (!(way > 0.0) || distance(ca, cb, q) - way > pair.distance) continue;
    for_each_point_pair(pair, [&](const std::array<double, 4>& w) {
      const Vec3 p = at(ca, w[1], q) - at(cb, -w[3], q), dp = at(ca, w[1], dq) - at(cb, -w[3], dq);
      const double left = p.norm() - room(pair);
      a *= first_reach(p, a * dp, room(pair) + kKeep * std::min(left, depth(pair)));
    });
  }
  return a;
}

bool SelfCollision::push_apart(const Pair& pair, VecX& q) const {
  const Segment &a = segments_[static_cast<std::size_t>(pair.a)], &b = segments_[static_cast<std::size_t>(pair.b)];
  const std::array<int, 4> x{a.coords[0], a.coords[3], b.coords[0], b.coords[3]};
  const std::array<bool, 4> held{a.held[0], a.held[1], b.held[0], b.held[1]};
  bool moved = false;
  for_each_point_pair(pair, [&](std::array<double, 4> w) {
    const Vec3 p = at(a.coords, w[1], q) - at(b.coords, -w[3], q);
    const double gap = p.norm() - pair.distance;
    if (gap > -0.5 * depth(pair)) return;
    double norm = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
      if (held[i]) w[i] = 0.0;
      norm += w[i] * w[i];
    }
    if (!(norm > 0.0)) return;
    for (std::size_t i = 0; i < 4; ++i) q.segment<3>(x[i]) -= w[i] / norm * gap * p.normalized();
    moved = true;
  });
  return moved;
}

void SelfCollision::push_out(const VecX& q0, VecX& q) {
  if (segments_.empty() || q0 == q) return;
  watch(q0, q - q0, 1.0);
  for (int i = 0; i < kMaxPushes; ++i) {
    bool moved = false;
    for (const Pair& pair : pairs_) moved = push_apart(pair, q) || moved;
    if (!moved) return;
  }
}

}  // namespace slipstitch
