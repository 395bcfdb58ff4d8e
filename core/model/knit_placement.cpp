// SPDX-License-Identifier: MIT
#include "model/knit_placement.h"

#include <cmath>
#include <random>

namespace slipstitch {
namespace {

// Columns: course, wale, right side.
Mat3 directions(const Placement& placement) {
  const Vec3 course = placement.course_direction.normalized();
  const Vec3 wale = (placement.wale_direction - placement.wale_direction.dot(course) * course).normalized();
  Mat3 axes;
  axes << course, wale, course.cross(wale);
  return axes;
}

}  // namespace

void place_flat(const Placement& placement, std::vector<Vec3>& positions) {
  const Mat3 axes = directions(placement);
  for (Vec3& x : positions) x = placement.origin_m + axes * x;
}

void place_tube(const Placement& placement, double circumference_m, std::vector<Vec3>& positions) {
  const Mat3 axes = directions(placement);
  const double radius = circumference_m / (2.0 * kPi);
  for (Vec3& x : positions) {
    const double angle = x.x() / radius, from_axis = radius + x.z();
    const Vec3 rolled(from_axis * std::sin(angle), x.y(), from_axis * std::cos(angle) - radius);
    x = placement.origin_m + axes * rolled;
  }
}

void add_noise(double amplitude_m, std::uint64_t seed, std::vector<Vec3>& positions) {
  if (amplitude_m == 0.0) return;
  std::mt19937_64 bits(seed);
  constexpr double kUnit = 0x1p-53;
  for (Vec3& x : positions) {
    for (int c = 0; c < 3; ++c) {
      const double in_0_1 = static_cast<double>(bits() >> 11) * kUnit;
      x[c] += amplitude_m * (2.0 * in_0_1 - 1.0);
    }
  }
}

}  // namespace slipstitch
