// SPDX-License-Identifier: MIT
#include "force/wrap_fade.h"

#include <cmath>

#include "math/cosine.h"
#include "math/smoothstep.h"

namespace slipstitch {
namespace {

// S(sin/0.3) as a function of the cosine c: with s = sqrt(1 - c^2), ds/dc = -c/s, d2s/dc2 = -1/s^3.
struct SideFade {
  double f = 0.0, c = 0.0, cc = 0.0;
};

SideFade side_fade(const Cosine& cosine) {
  const double s = cosine.s;
  if (!(s >= kWrapGone)) return {};
  const Jet2 S = smoothstep(s / kWrapFadeSine);
  const double d = S.d / kWrapFadeSine, dd = S.dd / (kWrapFadeSine * kWrapFadeSine);
  const double slope = -cosine.c / s;
  return {S.f, d * slope, dd * slope * slope - d / (s * s * s)};
}

// Columns of x0, x1 and the far node (slot `far`) of a vector pair (axis, arm from `root` to `far`).
template <class Block>
void add_vector(const Vec<6>& d, int root, int far, Block&& out) {
  out.template segment<3>(0) -= d.head<3>();
  out.template segment<3>(3) += d.head<3>();
  out.template segment<3>(root) -= d.tail<3>();
  out.template segment<3>(far) += d.tail<3>();
}

Vec<12> to_nodes(const Vec<6>& d, int root, int far) {
  Vec<12> g = Vec<12>::Zero();
  add_vector(d, root, far, g);
  return g;
}

void add_side_hessian(const Mat<6>& h, int root, int far, Mat<12>& hess) {
  Eigen::Matrix<double, 6, 12> half = Eigen::Matrix<double, 6, 12>::Zero();
  for (int i = 0; i < 6; ++i) half.row(i) = to_nodes(h.col(i), root, far).transpose();
  for (int j = 0; j < 12; ++j) hess.col(j) += to_nodes(half.col(j), root, far);
}

// The edges: slots of their ends in q.
struct Edge {
  int root, far;
  Vec3 of(const Vec<12>& q) const { return q.segment<3>(far) - q.segment<3>(root); }
};
constexpr Edge kAxis{0, 3}, kArmA{0, 9}, kArmB{3, 6};

// S(1000 |v|/L) and its derivatives by |v|.
Jet2 length_fade(const Vec3& v, double L) {
  const double full = kWrapFadeLength * L, squared = v.squaredNorm();
  if (squared >= full * full) return {1.0, 0.0, 0.0};
  const double x = std::sqrt(squared) / full;
  if (!(x >= kWrapGone)) return {};
  const Jet2 S = smoothstep(x);
  return {S.f, S.d / full, S.dd / (full * full)};
}

// Of the three edges; 0 also where sides have no angle.
double length_fades(const Vec<12>& q, double L) {
  return length_fade(kAxis.of(q), L).f * length_fade(kArmA.of(q), L).f * length_fade(kArmB.of(q), L).f;
}

// Multiplies f, of derivatives g and hess, by the fade of an edge.
void multiply(const Edge& edge, const Vec<12>& q, double L, double& f, Vec<12>& g, Mat<12>& hess) {
  const Vec3 v = edge.of(q);
  const Jet2 S = length_fade(v, L);
  if (!(S.f < 1.0)) return;
  const double length = v.norm();
  const Vec3 t = v / length;
  Vec<12> slope = Vec<12>::Zero();
  slope.segment<3>(edge.root) = -S.d * t;
  slope.segment<3>(edge.far) = S.d * t;
  hess *= S.f;
  hess += g * slope.transpose() + slope * g.transpose();
  const Mat3 along = t * t.transpose();
  const Mat3 curvature = f * (S.dd * along + (S.d / length) * (Mat3::Identity() - along));
  hess.block<3, 3>(edge.root, edge.root) += curvature;
  hess.block<3, 3>(edge.far, edge.far) += curvature;
  hess.block<3, 3>(edge.root, edge.far) -= curvature;
  hess.block<3, 3>(edge.far, edge.root) -= curvature;
  g = S.f * g + f * slope;
  f *= S.f;
}

// Of the two sines alone.
double sine_fade_derivatives(const Vec<12>& q, Vec<12>& g, Mat<12>& hess) {
  const Vec3 axis = kAxis.of(q);
  const Cosine a(axis, kArmA.of(q)), b(axis, kArmB.of(q));
  const SideFade A = side_fade(a), B = side_fade(b);
  g.setZero();
  hess.setZero();
  if (!(A.f * B.f > 0.0)) return 0.0;
  const Vec<12> da = to_nodes(a.gradient(), kArmA.root, kArmA.far), db = to_nodes(b.gradient(), kArmB.root, kArmB.far);
  g = (A.c * B.f) * da + (A.f * B.c) * db;
  add_side_hessian(A.c * B.f * a.hessian(), kArmA.root, kArmA.far, hess);
  add_side_hessian(A.f * B.c * b.hessian(), kArmB.root, kArmB.far, hess);
  const Vec<12> mixed = (A.c * B.c) * db;
  hess += (A.cc * B.f) * da * da.transpose() + (A.f * B.cc) * db * db.transpose();
  hess += da * mixed.transpose() + mixed * da.transpose();
  return A.f * B.f;
}

}  // namespace

double wrap_fade(const Vec<12>& q, double L) {
  const double lengths = length_fades(q, L);
  if (!(lengths > 0.0)) return 0.0;
  const Vec3 axis = kAxis.of(q);
  return lengths * side_fade(Cosine(axis, kArmA.of(q))).f * side_fade(Cosine(axis, kArmB.of(q))).f;
}

double wrap_fade_derivatives(const Vec<12>& q, double L, Vec<12>* g, Mat<12>* hess) {
  Vec<12> slope = Vec<12>::Zero();
  Mat<12> curvature = Mat<12>::Zero();
  double f = 0.0;
  if (length_fades(q, L) > 0.0) {
    f = sine_fade_derivatives(q, slope, curvature);
    for (const Edge& edge : {kAxis, kArmA, kArmB}) multiply(edge, q, L, f, slope, curvature);
  }
  if (g) *g = slope;
  if (hess) *hess = curvature;
  return f;
}

}  // namespace slipstitch
