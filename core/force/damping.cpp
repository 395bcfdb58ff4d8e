// SPDX-License-Identifier: MIT
#include "force/damping.h"

#include <cmath>

#include "force/bend_geometry.h"
#include "force/segments.h"
#include "force/wrapping.h"

namespace slipstitch {
namespace {

template <int N>
Vec<N> gather(const std::array<int, static_cast<std::size_t>(N)>& coords, const VecX& q) {
  Vec<N> local;
  for (int i = 0; i < N; ++i) local[i] = q[coords[static_cast<std::size_t>(i)]];
  return local;
}

double stretch_of(const Vec<8>& q) { return (q.segment<3>(4) - q.segment<3>(0)).norm() / (q[7] - q[3]); }

double smoothed_angle(double theta) { return std::hypot(theta, DampingBending::kSmoothing); }

}  // namespace

DampingStretch::DampingStretch(const Model& model) {
  if (!model.effects.damping || !(model.effects.damping->stretch_ns > 0.0)) return;
  for_each_owned_segment(model.topology, [&](int, int i) {
    coords_.push_back(segment_coords(model.topology, i));
    eta_length_.push_back(model.effects.damping->stretch_ns * rest_length(model.topology, i));
  });
  start_.resize(coords_.size());
}

void DampingStretch::begin_step(const StepContext& step) {
  h_ = step.h;
  for (std::size_t k = 0; k < coords_.size(); ++k)
    start_[k] = step.measured(0.0, [&](const VecX& q) { return stretch_of(gather<8>(coords_[k], q)); });
}

double DampingStretch::eval(int k, const Vec<8>& q, Vec<8>* g, Mat<8>* hess) const {
  const auto i = static_cast<std::size_t>(k);
  const Vec3 d = q.segment<3>(4) - q.segment<3>(0);
  const double D = q[7] - q[3], length = d.norm(), lambda = length / D;
  const double eta = eta_length_[i] / h_, change = lambda - start_[i];
  const Vec3 t = d / length;
  Vec<8> slope;
  slope << -t / D, lambda / D, t / D, -lambda / D;
  if (g) *g = eta * change * slope;
  if (hess) {
    *hess = eta * slope * slope.transpose();
    const double c = eta * change;
    const Mat3 turn = c * (Mat3::Identity() - t * t.transpose()) / (length * D);
    const Vec3 mixed = c * t / (D * D);
    const double arc = c * 2.0 * lambda / (D * D);
    for (int a : {0, 4}) {
      for (int b : {0, 4}) {
        const double sign = a == b ? 1.0 : -1.0;
        hess->block<3, 3>(a, b) += sign * turn;
        hess->block<3, 1>(a, b + 3) -= sign * mixed;
        hess->block<1, 3>(a + 3, b) -= sign * mixed.transpose();
        (*hess)(a + 3, b + 3) += sign * arc;
      }
    }
  }
  return 0.5 * eta * change * change;
}

void DampingStretch::convex_hessian(int k, const Vec<8>& q, Mat<8>& hess) const {
  const auto i = static_cast<std::size_t>(k);
  const Vec3 d = q.segment<3>(4) - q.segment<3>(0);
  const double D = q[7] - q[3], lambda = d.norm() / D;
  Vec<8> slope;
  slope << -d / d.norm(), lambda, d / d.norm(), -lambda;
  hess = (eta_length_[i] / (h_ * D * D) * slope) * slope.transpose();
}

DampingBending::DampingBending(const Model& model) {
  if (!model.effects.damping || !(model.effects.damping->bending_nm2s > 0.0)) return;
  for_each_owned_bend(model.topology, [&](int, int i) {
    const double rest = rest_length(model.topology, i - 1) + rest_length(model.topology, i);
    coords_.push_back(bend_coords(model.topology, i));
    eta_by_length_.push_back(model.effects.damping->bending_nm2s / rest);
  });
  start_.resize(coords_.size());
}

void DampingBending::begin_step(const StepContext& step) {
  h_ = step.h;
  for (std::size_t k = 0; k < coords_.size(); ++k)
    start_[k] = step.measured(
        0.0, [&](const VecX& q) { return smoothed_angle(bend_cosine(gather<11>(coords_[k], q)).theta()); });
}

double DampingBending::eval(int k, const Vec<11>& q, Vec<11>* g, Mat<11>* hess) const {
  const auto i = static_cast<std::size_t>(k);
  const Cosine cosine = bend_cosine(q);
  const double theta = cosine.theta(), m = smoothed_angle(theta), change = m - start_[i];
  const double eta = 2.0 * eta_by_length_[i] / h_;  // E = 1/2 eta change^2
  if (g || hess) {
    const SquaredAngle square = squared_angle(cosine, theta);
    const double mc = square.c / (2.0 * m);  // m = sqrt(theta^2 + const)
    const double mcc = square.cc / (2.0 * m) - square.c * square.c / (4.0 * m * m * m);
    BendFunction f;
    f.c = eta * change * mc;
    f.cc = eta * (mc * mc + change * mcc);
    bend_derivatives(f, cosine, g, hess);
  }
  return 0.5 * eta * change * change;
}

void DampingBending::convex_hessian(int k, const Vec<11>& q, Mat<11>& hess) const {
  const auto i = static_cast<std::size_t>(k);
  const Cosine cosine = bend_cosine(q);
  const double theta = cosine.theta(), m = smoothed_angle(theta), slope = theta / m;
  const double eta = 2.0 * eta_by_length_[i] / h_;
  convex_bend_hessian({eta * slope * slope, eta * (m - start_[i]) * slope, 0.0}, cosine, theta, hess);
}

DampingWrapping::DampingWrapping(const Model& model) {
  if (!model.effects.damping || !(model.effects.damping->wrapping_ns > 0.0)) return;
  const Wrapping wraps(model);
  for (int k = 0; k < wraps.size(); ++k) {
    coords_.push_back(wraps.coords(k));
    length_.push_back(wraps.wrap(k).L);
    eta_length_.push_back(model.effects.damping->wrapping_ns * length_.back());
  }
  start_.resize(coords_.size());
}

void DampingWrapping::begin_step(const StepContext& step) {
  h_ = step.h;
  for (std::size_t k = 0; k < coords_.size(); ++k)
    start_[k] = step.measured(
        0.0, [&](const VecX& q) { return wrap_angle_derivatives(gather<12>(coords_[k], q), nullptr, nullptr); });
}

double DampingWrapping::eval(int k, const Vec<12>& q, Vec<12>* g, Mat<12>* hess) const {
  const auto i = static_cast<std::size_t>(k);
  return wrapping_energy({eta_length_[i] / h_, start_[i], length_[i]}, 0.0, q, g, hess);
}

void DampingWrapping::convex_hessian(int k, const Vec<12>& q, Mat<12>& hess) const {
  const auto i = static_cast<std::size_t>(k);
  convex_wrapping_hessian({eta_length_[i] / h_, start_[i], length_[i]}, q, hess);
}

DampingSliding::DampingSliding(const Model& model) {
  if (!model.effects.damping || !model.effects.sliding) return;
  d_f_ = model.effects.damping->sliding_ns_per_m.value_or(DampingEffect::kDefaultSliding);
  if (!(d_f_ > 0.0)) return;
  for (int i = 0; i < model.topology.num_visits(); ++i)
    if (model.topology.visit_slides[static_cast<std::size_t>(i)] && model.topology.owned(i))
      coord_.push_back(model.topology.arc_coord(i));
  start_.resize(coord_.size());
}

void DampingSliding::begin_step(const StepContext& step) {
  h_ = step.h;
  for (std::size_t k = 0; k < coord_.size(); ++k)
    start_[k] = step.measured(0.0, [&](const VecX& q) { return q[coord_[k]]; });
}

double DampingSliding::eval(int k, const Vec<1>& q, Vec<1>* g, Mat<1>* hess) const {
  const double change = q[0] - start_[static_cast<std::size_t>(k)];
  if (g) (*g)[0] = d_f_ / h_ * change;
  if (hess) (*hess)(0, 0) = d_f_ / h_;
  return 0.5 * d_f_ / h_ * change * change;
}

}  // namespace slipstitch
