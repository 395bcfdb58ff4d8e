// SPDX-License-Identifier: MIT
#include "force/bend_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace slipstitch {
namespace {

constexpr double kSmallestSine = 1e-12;  // keeps the cone at theta = pi finite
constexpr std::array<int, 3> kX{0, 4, 7};  // x2, x0, x1
constexpr int kU2 = 3, kU1 = 10;

// d1 = x0 - x2, d2 = x1 - x0.
Vec<9> to_nodes(const Vec<6>& d) {
  Vec<9> x;
  x << -d.head<3>(), d.head<3>() - d.tail<3>(), d.tail<3>();
  return x;
}

}  // namespace

SquaredAngle squared_angle(const Cosine& cosine, double theta) {
  if (theta < 0.05) {  // Taylor in theta^2; the closed forms cancel
    const double x = theta * theta;
    return {-2.0 * (1.0 + x * (1.0 / 6 + x * (7.0 / 360 + x * (31.0 / 15120 + x * 127.0 / 604800)))),
            2.0 / 3 + x * (4.0 / 15 + x * (4.0 / 63 + x * (8.0 / 675 + x * 4.0 / 2079)))};
  }
  const double s = std::max(cosine.s, kSmallestSine);
  return {-2.0 * theta / s, 2.0 * (s - theta * cosine.c) / (s * s * s)};
}

void bend_derivatives(const BendFunction& f, const Cosine& cosine, Vec<11>* g, Mat<11>* hess) {
  const Vec<6> dc = cosine.gradient();
  if (g) {
    const Vec<9> x = to_nodes(f.c * dc);
    *g << x.head<3>(), -f.W, x.tail<6>(), f.W;
  }
  if (hess) {
    const Mat<6> h = f.cc * dc * dc.transpose() + f.c * cosine.hessian();
    const Mat3 A = h.block<3, 3>(0, 0), B = h.block<3, 3>(0, 3), C = h.block<3, 3>(3, 3);
    const Mat3 Bt = B.transpose();
    hess->block<3, 3>(0, 0) = A;
    hess->block<3, 3>(0, 4) = B - A;
    hess->block<3, 3>(0, 7) = -B;
    hess->block<3, 3>(4, 4) = A - B - Bt + C;
    hess->block<3, 3>(4, 7) = B - C;
    hess->block<3, 3>(7, 7) = C;
    hess->block<3, 3>(4, 0) = hess->block<3, 3>(0, 4).transpose();
    hess->block<3, 3>(7, 0) = -Bt;
    hess->block<3, 3>(7, 4) = hess->block<3, 3>(4, 7).transpose();
    const Vec<9> mixed = to_nodes(f.cW * dc);
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 m = mixed.segment<3>(3 * static_cast<Eigen::Index>(i));
      hess->block<3, 1>(kX[i], kU1) = m;
      hess->block<3, 1>(kX[i], kU2) = -m;
      hess->block<1, 3>(kU1, kX[i]) = m.transpose();
      hess->block<1, 3>(kU2, kX[i]) = -m.transpose();
    }
    (*hess)(kU1, kU1) = (*hess)(kU2, kU2) = f.WW;
    (*hess)(kU1, kU2) = (*hess)(kU2, kU1) = -f.WW;
  }
}

void convex_bend_hessian(const ConvexBend& f, const Cosine& cosine, double theta, Mat<11>& hess) {
  const bool straight = !(cosine.s > kSmallestSine);
  const Vec3 e1 = straight ? cosine.t1.unitOrthogonal() : Vec3(cosine.s1 / cosine.s);  // across t1, in the plane
  const Vec3 e2 = straight ? Vec3(-e1) : Vec3(cosine.s2 / cosine.s);                   // across t2, in the plane
  const Vec3 n = straight ? cosine.t1.cross(e1) : Vec3(cosine.t1.cross(cosine.t2) / cosine.s);
  const auto turning = [&](const Vec3& a, const Vec3& b, double arc) {
    Vec<6> d;
    d << a / cosine.l1, b / cosine.l2;
    const Vec<9> x = to_nodes(d);
    Vec<11> v;
    v << x.head<3>(), arc, x.tail<6>(), -arc;
    return v;
  };
  const Vec<11> in_plane = turning(-e1, -e2, f.arc), out_of_plane = turning(n, -n, 0.0);
  // slope cot(theta/2)/2, which tends to slope/theta at 0
  const double normal = theta > kSmallestSine ? 0.5 * std::max(f.slope, 0.0) / std::tan(0.5 * theta) : f.second;
  hess = (f.second * in_plane) * in_plane.transpose();
  hess += (normal * out_of_plane) * out_of_plane.transpose();
}

}  // namespace slipstitch
