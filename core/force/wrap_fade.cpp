// SPDX-License-Identifier: MIT
#include "force/wrap_fade.h"

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
  if (!(s >= kWrapGoneSine)) return {};  // also where the angle is not a number
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

}  // namespace

double wrap_fade(const Vec3& x0, const Vec3& x1, const Vec3& x3, const Vec3& x4) {
  return side_fade(Cosine(x1 - x0, x4 - x0)).f * side_fade(Cosine(x1 - x0, x3 - x1)).f;
}

double wrap_fade_derivatives(const Vec<12>& q, Vec<12>* g, Mat<12>* hess) {
  const Vec3 axis = q.segment<3>(3) - q.segment<3>(0);
  const Cosine a(axis, q.segment<3>(9) - q.segment<3>(0)), b(axis, q.segment<3>(6) - q.segment<3>(3));
  const SideFade A = side_fade(a), B = side_fade(b);
  if (g) g->setZero();
  if (hess) hess->setZero();
  if (!(A.f * B.f > 0.0)) return 0.0;
  if (!g && !hess) return A.f * B.f;
  const Vec<12> da = to_nodes(a.gradient(), 0, 9), db = to_nodes(b.gradient(), 3, 6);
  if (g) *g = (A.c * B.f) * da + (A.f * B.c) * db;
  if (hess) {
    add_side_hessian(A.c * B.f * a.hessian(), 0, 9, *hess);
    add_side_hessian(A.f * B.c * b.hessian(), 3, 6, *hess);
    const Vec<12> mixed = (A.c * B.c) * db;
    *hess += (A.cc * B.f) * da * da.transpose() + (A.f * B.cc) * db * db.transpose();
    *hess += da * mixed.transpose() + mixed * da.transpose();
  }
  return A.f * B.f;
}

}  // namespace slipstitch
