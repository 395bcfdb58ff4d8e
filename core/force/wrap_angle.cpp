// SPDX-License-Identifier: MIT
#include "force/wrap_angle.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace slipstitch {
namespace {

// Node slots in q: x0, x1, x3, x4.
constexpr std::array<double, 4> kAxisSign{-1.0, 1.0, 0.0, 0.0};  // de/dx_j = sign_j (I - ee^T)/l

constexpr double kTiny = 1e-300;  // makes the normal and the angle 0 where a triangle has no area

// One of the two triangles on the axis: area vector v = N n; x_j with dv/dx_j = cross matrix of x_j.
struct Triangle {
  std::array<int, 3> node;  // slots, the third off the axis
  double sign;              // with which it counts in d psi
  Vec3 n;
  double N;
  std::array<Vec3, 3> x, y;  // y_j = n x x_j
  std::array<double, 3> C;   // e.x_j/N
};

struct Hinge {
  Vec3 e;
  double l;
  Triangle a, b;
};

Triangle make_triangle(std::array<int, 3> node, double sign, const Vec3& v, const std::array<Vec3, 3>& x,
                       const Vec3& e) {
  Triangle t{node, sign, v, std::max(v.norm(), kTiny), x, {}, {}};
  t.n /= t.N;
  for (std::size_t j = 0; j < 3; ++j) {
    t.y[j] = t.n.cross(x[j]);
    t.C[j] = e.dot(x[j]) / t.N;
  }
  return t;
}

Hinge make_hinge(const Vec<12>& q) {
  const Vec3 x0 = q.segment<3>(0), x1 = q.segment<3>(3), x3 = q.segment<3>(6), x4 = q.segment<3>(9);
  const Vec3 axis = x1 - x0;
  const double l = std::max(axis.norm(), kTiny);
  const Vec3 e = axis / l;
  const Vec3 va = (x4 - x1).cross(x0 - x1), vb = (x0 - x1).cross(x3 - x1);
  return {e, l, make_triangle({0, 1, 3}, -1.0, va, {x4 - x1, x0 - x4, axis}, e),
          make_triangle({0, 1, 2}, 1.0, vb, {x1 - x3, x3 - x0, -axis}, e)};
}

void add_gradient(const Triangle& t, Vec<12>& g) {
  for (std::size_t j = 0; j < 3; ++j) g.segment<3>(3 * t.node[j]) += (t.sign * t.C[j]) * t.n;
}

// dx_i/dx_j = K_ij I within a triangle of cyclic edge vectors: antisymmetric, sign of the triangle's orientation.
constexpr double kEdge[3][3] = {{0, 1, -1}, {-1, 0, 1}, {1, -1, 0}};

// Adds sign * H_ij for slots i <= j, H_ij = n r_ij^T - (C_i/N) y_j n^T.
void add_hessian(const Triangle& t, const Hinge& hinge, Mat<12>& hess) {
  const double orientation = t.sign;  // b: d x_b0/dx1 = +I; a: d x_a0/dx1 = -I
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 p = t.x[i] - hinge.e * (t.C[i] * t.N);
    for (std::size_t j = 0; j < 3; ++j) {
      if (t.node[j] < t.node[i]) continue;
      const double axis_sign = kAxisSign[static_cast<std::size_t>(t.node[j])];
      const Vec3 r = ((axis_sign / hinge.l) * p + (orientation * kEdge[i][j]) * hinge.e - t.C[i] * t.y[j]) / t.N;
      hess.block<3, 3>(3 * t.node[i], 3 * t.node[j]) +=
          t.sign * (t.n * r.transpose() - (t.C[i] / t.N) * t.y[j] * t.n.transpose());
    }
  }
}

}  // namespace

double wrap_angle(const Vec3& x0, const Vec3& x1, const Vec3& x3, const Vec3& x4) {
  Vec<12> q;
  q << x0, x1, x3, x4;
  return wrap_angle_derivatives(q, nullptr, nullptr);
}

double wrap_angle_derivatives(const Vec<12>& q, Vec<12>* g, Mat<12>* hess) {
  const Hinge hinge = make_hinge(q);
  if (g) {
    g->setZero();
    add_gradient(hinge.a, *g);
    add_gradient(hinge.b, *g);
  }
  if (hess) {
    hess->setZero();
    add_hessian(hinge.a, hinge, *hess);
    add_hessian(hinge.b, hinge, *hess);
    hess->triangularView<Eigen::StrictlyLower>() = hess->transpose().triangularView<Eigen::StrictlyLower>();
  }
  return std::atan2(hinge.e.dot(hinge.a.n.cross(hinge.b.n)), hinge.a.n.dot(hinge.b.n));
}

}  // namespace slipstitch
