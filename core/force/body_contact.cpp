// SPDX-License-Identifier: MIT
#include "force/body_contact.h"

#include <algorithm>
#include <utility>

#include "collide/closest_point.h"
#include "collide/shape_distance.h"
#include "force/script_push.h"
#include "force/scripted_nodes.h"
#include "force/weighted_point.h"
#include "math/bytes.h"

namespace slipstitch {
namespace {

std::array<double, 3> weights(double share) { return {1.0 - share, share, -1.0}; }

Vec3 from_centre(const std::array<double, 3>& w, const Vec<9>& q) {
  return w[0] * q.segment<3>(0) + w[1] * q.segment<3>(3) + w[2] * q.segment<3>(6);
}

Distance distance_to_ball(double radius, const Vec3& p) { return distance_to(Sphere{Vec3::Zero(), radius}, p); }

}  // namespace

BodyContact::BodyContact(const Model& model, SharedTouchParts parts) : parts_(std::move(parts)), bodies_(model.bodies) {
  if (bodies_.empty()) return;
  held_ = scripted_nodes(model);
  paired_.assign(static_cast<std::size_t>(parts_->all_samples.size()) * bodies_.size(), 0);
}

std::array<int, 9> BodyContact::coords_of(const Pair& pair) const {
  std::array<int, 9> coords{};
  std::copy(sample(pair).coords.begin(), sample(pair).coords.end(), coords.begin());
  for (int c = 0; c < 3; ++c) coords[static_cast<std::size_t>(6 + c)] = 3 * body(pair.body).node + c;
  return coords;
}

Vec3 BodyContact::from_centre(const Pair& pair, const VecX& q) const {
  return place_of(sample(pair), q) - q.segment<3>(3 * body(pair.body).node);
}

double BodyContact::normal_force(const Pair& pair, const VecX& q) const {
  return -gap_energy(parts_->k, parts_->ball_depth, from_centre(pair, q).norm() - touching(pair)).slope;
}

double BodyContact::eval(int k, const Vec<9>& q, Vec<9>* g, Mat<9>* hess) const {
  const Pair& pair = pairs_[static_cast<std::size_t>(k)];
  const auto w = weights(share_of(pair));
  const Distance d = distance_to_ball(touching(pair), slipstitch::from_centre(w, q));
  const GapEnergy e = gap_energy(parts_->k, parts_->ball_depth, d.phi);
  if (g)
    for (std::size_t i = 0; i < 3; ++i) g->segment<3>(static_cast<Eigen::Index>(3 * i)) = w[i] * e.slope * d.normal;
  if (hess) spread(w, e.curvature * d.normal * d.normal.transpose() + e.slope * d.curvature, *hess);
  return e.value;
}

void BodyContact::convex_hessian(int k, const Vec<9>& q, Mat<9>& hess) const {
  const Pair& pair = pairs_[static_cast<std::size_t>(k)];
  const auto w = weights(share_of(pair));
  const Distance d = distance_to_ball(touching(pair), slipstitch::from_centre(w, q));
  spread(w, gap_energy(parts_->k, parts_->ball_depth, d.phi).curvature * d.normal * d.normal.transpose(), hess);
}

void BodyContact::begin_step(const StepContext& step) {
  if (bodies_.empty()) return;
  const std::vector<Pair> before = std::exchange(pairs_, {});
  const long revision = revision_;
  parts_->all_samples.follow(step.start.t, step.start.q, parts_->ball_depth, [&](const Vec3& x) {
    double overlap = 0.0;
    for (const Body& body : bodies_)
      overlap = std::max(overlap, body.radius_m + parts_->radius - (x - step.start.q.segment<3>(3 * body.node)).norm());
    return overlap;
  });
  paired_.assign(static_cast<std::size_t>(parts_->all_samples.size()) * bodies_.size(), 0);
  watch(step.start.q, step.start.v, kTouchReachOfMove * step.duration);
  revision_ = pairs_ == before ? revision : revision + 1;
}

long BodyContact::search_bytes() const { return parts_->all_samples.bytes() + bytes_of(bodies_, pairs_, paired_); }

void BodyContact::watch(const VecX& q, const VecX& dq, double a) {
  if (!bodies_.empty()) ++searches_;
  std::size_t at = 0;
  for (int s = 0; s < parts_->all_samples.size(); ++s)
    for (int b = 0; b < static_cast<int>(bodies_.size()); ++b, ++at) {
      const Pair pair{s, b};
      const double reach = touching(pair) + kTouchReach * parts_->radius + a * from_centre(pair, dq).norm();
      if (paired_[at] || !sample(pair).in_use || from_centre(pair, q).norm() > reach) continue;
      paired_[at] = 1;
      pairs_.push_back(pair);
      ++revision_;
    }
}

double BodyContact::max_step(const VecX& q, const VecX& dq, double a) const {
  for (const Pair& pair : pairs_) {
    const Vec3 p = from_centre(pair, q), dp = from_centre(pair, dq);
    const double deepest = touching(pair) - parts_->ball_depth, left = p.norm() - deepest;
    a *= first_reach(p, a * dp, deepest + kTouchKeep * std::min(left, parts_->ball_depth));
  }
  return a;
}

bool BodyContact::outgrown(const VecX& q) const {
  return parts_->all_samples.outgrown(q, [&](const Vec3& x, double within) {
    return std::any_of(bodies_.begin(), bodies_.end(), [&](const Body& body) {
      return (x - q.segment<3>(3 * body.node)).norm() < body.radius_m + within + 2.0 * parts_->radius;
    });
  });
}

bool BodyContact::push_apart(const Pair& pair, const VecX& q0, VecX& q) const {
  const Distance d = distance_to_ball(touching(pair), from_centre(pair, q));
  if (d.phi > -kPushedOverlap * parts_->ball_depth) return false;
  const double gap0 = from_centre(pair, q0).norm() - touching(pair);
  const double push = push_needed(parts_->ball_depth, d.phi, gap0);
  if (push == 0.0) return false;
  const auto coords = coords_of(pair);
  auto w = weights(share_of(pair));
  for (std::size_t i = 0; i < 2; ++i)
    if (held_[static_cast<std::size_t>(coords[3 * i] / 3)]) w[i] = 0.0;
  if (w[0] != 0.0 || w[1] != 0.0) w[2] = 0.0;
  const double norm = w[0] * w[0] + w[1] * w[1] + w[2] * w[2];
  for (std::size_t i = 0; i < 3; ++i) q.segment<3>(coords[3 * i]) += w[i] / norm * push * d.normal;
  return true;
}

void BodyContact::push_out(const VecX& q0, VecX& q) {
  if (bodies_.empty()) return;
  watch(q0, q - q0, 1.0);
  for (int i = 0; i < kMaxPushes; ++i) {
    bool moved = false;
    for (const Pair& pair : pairs_) moved = push_apart(pair, q0, q) || moved;
    if (!moved) return;
  }
}

}  // namespace slipstitch
