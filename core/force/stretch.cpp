// SPDX-License-Identifier: MIT
#include "force/stretch.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "force/segments.h"
#include "force/shrinkage.h"
#include "math/log_barrier.h"

namespace slipstitch {

namespace {

struct Segment {
  double D, length, lambda;
  Vec3 t;

  explicit Segment(const Vec<8>& q) : D(q[7] - q[3]) {
    const Vec3 d = q.segment<3>(4) - q.segment<3>(0);
    length = d.norm();
    lambda = length / D;
    t = d / std::max(length, 1e-12 * D);
  }
  /// D times the derivative of lambda.
  Vec<8> slope() const {
    Vec<8> a;
    a << -t, lambda, t, -lambda;
    return a;
  }
};

/// Of V = D f(lambda): f' is the tension, f'' the stiffness.
Mat<8> stretch_hessian(double stiffness, double tension, const Segment& s) {
  const Vec<8> a = s.slope();
  Mat<8> hess = (stiffness / s.D * a) * a.transpose();
  const Mat3 turn = (tension / std::max(s.length, 1e-12 * s.D)) * (Mat3::Identity() - s.t * s.t.transpose());
  hess.block<3, 3>(0, 0) += turn;
  hess.block<3, 3>(4, 4) += turn;
  hess.block<3, 3>(0, 4) -= turn;
  hess.block<3, 3>(4, 0) -= turn;
  return hess;
}

Jet2 crush(double lambda) {
  const Jet2 b = log_barrier(lambda / kCrushed);
  return {b.f, b.d / kCrushed, b.dd / (kCrushed * kCrushed)};
}

double crushed_energy(double k_s, const Segment& s, Vec<8>* g, Mat<8>* hess) {
  const Jet2 b = crush(s.lambda);
  if (g) g->setZero();
  if (hess) hess->setZero();
  if (!std::isfinite(b.f)) return b.f;
  const double strain = s.lambda - 1.0, density = k_s * (0.5 * strain * strain + b.f), tension = k_s * (strain + b.d);
  const double arc_force = s.lambda * tension - density;
  if (g) *g << -tension * s.t, arc_force, tension * s.t, -arc_force;
  if (hess) *hess = stretch_hessian(k_s * (1.0 + b.dd), tension, s);
  return s.D * density;
}

double guarded_energy(double k_s, const Vec<8>& q, Vec<8>* g, Mat<8>* hess) {
  const bool ordered = q[7] > q[3];
  if (ordered && Segment(q).lambda < kCrushed) [[unlikely]]
    return crushed_energy(k_s, Segment(q), g, hess);
  return stretch_energy(k_s, q, g, hess);
}

}  // namespace

double stretch_energy(double k_s, const Vec<8>& q, Vec<8>* g, Mat<8>* hess) {
  if (!(q[7] > q[3])) {
    if (g) g->setZero();
    if (hess) hess->setZero();
    return std::numeric_limits<double>::infinity();
  }
  const Segment s(q);
  const double tension = k_s * ((s.length - s.D) / s.D);
  if (g) {
    const double arc_force = 0.5 * tension * (s.lambda + 1.0);
    *g << -tension * s.t, arc_force, tension * s.t, -arc_force;
  }
  if (hess) *hess = stretch_hessian(k_s, tension, s);
  return 0.5 * tension * (s.length - s.D);
}

double Stretch::eval(int, const Vec<8>& q, Vec<8>* g, Mat<8>* hess) const {
  if (factor_ == 1.0) return guarded_energy(k_s_, q, g, hess);
  const double value = guarded_energy(k_s_, scaled_arcs(q, factor_), g, hess);
  if (g) scale_arc_rows(factor_, *g);
  if (hess) scale_arc_rows(factor_, *hess);
  return value;
}

double Stretch::stress(int, const Vec<8>& q, const Vec<8>& dq) const {
  const Segment s(scaled_arcs(q, factor_));
  const Jet2 b = crush(s.lambda);
  return k_s_ * (s.lambda - 1.0 + b.d + (1.0 + b.dd) * s.slope().dot(scaled_arcs(dq, factor_)) / s.D);
}

void Stretch::hessian_at(int, const Vec<8>& q, double tension, Mat<8>& hess) const {
  const Segment s(scaled_arcs(q, factor_));
  hess = stretch_hessian(k_s_ * (1.0 + crush(s.lambda).dd), tension, s);
  if (factor_ != 1.0) scale_arc_rows(factor_, hess);
}

void Stretch::convex_hessian(int, const Vec<8>& q, Mat<8>& hess) const {
  const Segment s(scaled_arcs(q, factor_));
  hess = stretch_hessian(k_s_ * (1.0 + crush(s.lambda).dd), std::max(0.0, k_s_ * (s.lambda - 1.0)), s);
  if (factor_ != 1.0) scale_arc_rows(factor_, hess);
}

Stretch::Stretch(const Model& model)
    : model_(&model), factor_(slipstitch::length_factor(model.effects, 0.0)), k_s_(model.yarn.stretch_n) {
  if (!model.effects.stretch) return;
  for_each_owned_segment(model.topology, [&](int, int i) { coords_.push_back(segment_coords(model.topology, i)); });
}

void Stretch::begin_step(const StepContext& step) {
  factor_ = slipstitch::length_factor(model_->effects, step.end_t());
}

}  // namespace slipstitch
