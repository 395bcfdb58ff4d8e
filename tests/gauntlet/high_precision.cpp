// SPDX-License-Identifier: MIT
#include "gauntlet/high_precision.h"

namespace slipstitch::testing {

Real3 operator-(const Real3& a, const Real3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Real dot(const Real3& a, const Real3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Real3 cross(const Real3& a, const Real3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Real length(const Real3& a) { return sqrt(dot(a, a)); }

Real3 point(const Reals& q, int first) {
  const auto i = static_cast<std::size_t>(first);
  return {q[i], q[i + 1], q[i + 2]};
}

Real angle_between(const Real3& a, const Real3& b) { return atan2(length(cross(a, b)), dot(a, b)); }

Reference reference(const RealEnergy& energy, const VecX& q, double near) {
  const Reals at(q.begin(), q.end());
  const auto n = at.size();
  const Real h = Real(near) * Real(1e-12), here = energy(at);
  const auto moved = [&](std::size_t i, int a, std::size_t j, int b) {
    Reals x = at;
    x[i] += a * h;
    x[j] += b * h;
    return energy(x);
  };
  Reference r{static_cast<double>(here), VecX(q.size()), Eigen::MatrixXd(q.size(), q.size())};
  const auto index = [](std::size_t i) { return static_cast<Eigen::Index>(i); };
  for (std::size_t i = 0; i < n; ++i) {
    const Real up = moved(i, 1, i, 0), down = moved(i, -1, i, 0);
    r.g[index(i)] = static_cast<double>((up - down) / (2 * h));
    r.hess(index(i), index(i)) = static_cast<double>((up - 2 * here + down) / (h * h));
    for (std::size_t j = 0; j < i; ++j) {
      const Real mixed = moved(i, 1, j, 1) - moved(i, 1, j, -1) - moved(i, -1, j, 1) + moved(i, -1, j, -1);
      r.hess(index(i), index(j)) = r.hess(index(j), index(i)) = static_cast<double>(mixed / (4 * h * h));
    }
  }
  return r;
}

}  // namespace slipstitch::testing
