// SPDX-License-Identifier: MIT
#include "model/motion.h"

namespace slipstitch {

Keyframe motion_at(const std::vector<Keyframe>& motion, double t) {
  Keyframe before;
  for (const Keyframe& next : motion) {
    if (t < next.t) {
      const double f = (t - before.t) / (next.t - before.t);
      return {t, before.translation_m + f * (next.translation_m - before.translation_m),
              before.rotation_rad + f * (next.rotation_rad - before.rotation_rad)};
    }
    before = next;
  }
  return before;
}

Mat3 turn_by(const Vec3& rotation_rad) {
  const double angle = rotation_rad.norm();
  if (!(angle > 0.0)) return Mat3::Identity();
  return Eigen::AngleAxisd(angle, rotation_rad / angle).toRotationMatrix();
}

}  // namespace slipstitch
