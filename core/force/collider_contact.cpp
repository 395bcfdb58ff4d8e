// SPDX-License-Identifier: MIT
#include "force/collider_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "force/script_push.h"
#include "force/scripted_nodes.h"
#include "force/weighted_point.h"
#include "math/bytes.h"

namespace slipstitch {
namespace {

constexpr int kMaxAdvances = 60;

Vec3 place(double share, const Vec<6>& q) { return (1.0 - share) * q.head<3>() + share * q.tail<3>(); }

std::array<double, 2> weights(double share) { return {1.0 - share, share}; }

}  // namespace

ColliderContact::ColliderContact(const Model& model, SharedTouchParts parts)
    : parts_(std::move(parts)), radius_(parts_->radius), depth_(parts_->depth), k_(parts_->k), bodies_(parts_->bodies) {
  if (!bodies_.empty()) held_ = scripted_nodes(model);
}

double ColliderContact::gap(const Pair& pair, const VecX& q) const {
  return body(pair.body).distance(place_of(sample(pair.sample), q)).phi - touching(pair.sample);
}

double ColliderContact::normal_force(const Pair& pair, const VecX& q) const {
  return -gap_energy(k_, depth_, gap(pair, q)).slope;
}

void ColliderContact::begin_step(const StepContext& step) {
  if (bodies_.empty()) return;
  ++searches_;
  start_t_ = step.start.t;
  for (RigidBody& body : bodies_) body.move_to(start_t_);
  parts_->samples.follow(step.start.t, step.start.q, depth_, [&](const Vec3& x) {
    double overlap = 0.0;
    for (const RigidBody& body : bodies_) overlap = std::max(overlap, radius_ - body.distance(x).phi);
    return overlap;
  });
  for (RigidBody& body : bodies_) body.move_to(step.end_t());
  const std::vector<Pair> before = std::exchange(pairs_, {});
  const auto num_samples = static_cast<std::size_t>(parts_->samples.size());
  clear_.assign(num_samples, std::numeric_limits<double>::infinity());
  start_.resize(num_samples);
  paired_.assign(num_samples * bodies_.size(), 0);
  for (int s = 0; s < parts_->samples.size(); ++s) {
    if (!sample(s).in_use) continue;
    const double move = kTouchReachOfMove * step.duration * place_of(sample(s), step.start.v).norm();
    look_around(s, place_of(sample(s), step.start.q), kTouchReach * radius_ + move);
  }
  if (pairs_ != before) ++revision_;
}

/// Pairs sample s, at x, with all bodies within `reach`.
void ColliderContact::look_around(int s, const Vec3& x, double reach) {
  const auto i = static_cast<std::size_t>(s);
  start_[i] = x;
  clear_[i] = std::numeric_limits<double>::infinity();
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    char& paired = paired_[i * bodies_.size() + b];
    if (paired) continue;
    const double gap = bodies_[b].distance(x).phi - radius_;
    if (gap <= reach) {
      paired = 1;
      pairs_.push_back({s, static_cast<int>(b)});
    } else {
      clear_[i] = std::min(clear_[i], gap);
    }
  }
}

void ColliderContact::watch(const VecX& q, const VecX& dq, double a) {
  if (bodies_.empty()) return;
  for (int s = 0; s < parts_->samples.size(); ++s) {
    const auto i = static_cast<std::size_t>(s);
    if (!std::isfinite(clear_[i])) continue;
    const Vec3 x = place_of(sample(s), q);
    const double way = a * place_of(sample(s), dq).norm();
    if ((x - start_[i]).norm() + way > clear_[i]) look_around(s, x, kTouchReach * radius_ + way);
  }
}

long ColliderContact::search_bytes() const {
  return parts_->samples.bytes() + bytes_of(bodies_, pairs_, clear_, start_, paired_);
}

double ColliderContact::eval(int k, const Vec<6>& q, Vec<6>* g, Mat<6>* hess) const {
  const Pair& pair = pairs_[static_cast<std::size_t>(k)];
  const double share = sample_of(k).share;
  const Distance d = body(pair.body).distance(place(share, q));
  const GapEnergy e = gap_energy(k_, depth_, d.phi - touching(pair.sample));
  if (g) *g << (1.0 - share) * e.slope * d.normal, share * e.slope * d.normal;
  if (hess) spread(weights(share), e.curvature * d.normal * d.normal.transpose() + e.slope * d.curvature, *hess);
  return e.value;
}

void ColliderContact::convex_hessian(int k, const Vec<6>& q, Mat<6>& hess) const {
  const Pair& pair = pairs_[static_cast<std::size_t>(k)];
  const double share = sample_of(k).share;
  const Distance d = body(pair.body).distance(place(share, q));
  const GapEnergy e = gap_energy(k_, depth_, d.phi - touching(pair.sample));
  spread(weights(share), e.curvature * d.normal * d.normal.transpose(), hess);
}

/// Conservative advancement: a distance grows no faster than its point moves.
double ColliderContact::keep_apart(const Pair& pair, const VecX& q, const VecX& dq, double a) const {
  const Vec3 x = place_of(sample(pair.sample), q), dx = place_of(sample(pair.sample), dq);
  const double way = dx.norm();
  if (!(way > 0.0)) return a;
  const double deepest = touching(pair.sample) - depth_;
  const double room = body(pair.body).distance(x).phi - deepest;  // > 0
  if (a * way < (1.0 - kTouchKeep) * room) return a;
  const double floor = kTouchKeep * std::min(room, depth_);
  double done = 0.0, left = room - floor;
  for (int i = 0; i < kMaxAdvances && left > 1e-3 * floor; ++i) {
    done += left / way;
    if (done >= a) return a;
    left = body(pair.body).distance(x + done * dx).phi - deepest - floor;
  }
  return std::min(a, done);
}

double ColliderContact::max_step(const VecX& q, const VecX& dq, double a) const {
  for (int s = 0; s < parts_->samples.size(); ++s) {
    const auto i = static_cast<std::size_t>(s);
    if (!std::isfinite(clear_[i])) continue;
    const double way = place_of(sample(s), dq).norm(), gone = (place_of(sample(s), q) - start_[i]).norm();
    if (gone + a * way > clear_[i]) a = std::max(0.0, clear_[i] - gone) / way;
  }
  for (const Pair& pair : pairs_) a = keep_apart(pair, q, dq, a);
  return a;
}

bool ColliderContact::outgrown(const VecX& q) const {
  return parts_->samples.outgrown(q, [&](const Vec3& x, double within) {
    return std::any_of(bodies_.begin(), bodies_.end(),
                       [&](const RigidBody& body) { return body.distance(x).phi < within + 2.0 * radius_; });
  });
}

bool ColliderContact::push_out_once(std::span<const RigidBody> before, const VecX& q0, VecX& q) const {
  bool moved = false;
  for (const Pair& pair : pairs_) {
    const TouchSample& at = sample(pair.sample);
    const Distance d = body(pair.body).distance(place_of(at, q));
    const double gap = d.phi - touching(pair.sample);
    if (gap > -kPushedOverlap * depth_) continue;
    const double gap0 =
        before[static_cast<std::size_t>(pair.body)].distance(place_of(at, q0)).phi - touching(pair.sample);
    const double push = push_needed(depth_, gap, gap0);
    if (push == 0.0) continue;
    const double w0 = held_[static_cast<std::size_t>(at.coords[0] / 3)] ? 0.0 : 1.0 - at.share;
    const double w1 = held_[static_cast<std::size_t>(at.coords[3] / 3)] ? 0.0 : at.share;
    const double norm = w0 * w0 + w1 * w1;
    if (!(norm > 0.0)) continue;
    q.segment<3>(at.coords[0]) += w0 / norm * push * d.normal;
    q.segment<3>(at.coords[3]) += w1 / norm * push * d.normal;
    moved = true;
  }
  return moved;
}

void ColliderContact::push_out(const VecX& q0, VecX& q) const {
  std::vector<RigidBody> before = bodies_;
  for (RigidBody& body : before) body.move_to(start_t_);
  for (int i = 0; i < kMaxPushes; ++i)
    if (!push_out_once(before, q0, q)) return;
}

}  // namespace slipstitch
