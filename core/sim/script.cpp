// SPDX-License-Identifier: MIT
#include <algorithm>

#include "sim/simulation.h"

namespace slipstitch {
namespace {

/// Linear in time between keyframes; before the first one from rest at t = 0, after the last one held.
Keyframe interpolate(const std::vector<Keyframe>& motion, double t) {
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

Vec3 centroid(const std::vector<int>& nodes, const VecX& q) {
  Vec3 sum = Vec3::Zero();
  for (int n : nodes) sum += q.segment<3>(3 * n);
  return sum / static_cast<double>(std::max<std::size_t>(1, nodes.size()));
}

}  // namespace

void apply_scripts(const Model& model, double t, VecX& offset) {
  for (const ScriptedNodes& handle : model.handles) {
    if (handle.motion.empty()) {
      if (handle.velocity_m_per_s.isZero(0.0)) continue;
      for (int n : handle.nodes)
        offset.segment<3>(3 * n) = model.start_q.segment<3>(3 * n) + t * handle.velocity_m_per_s;
      continue;
    }
    const Keyframe pose = interpolate(handle.motion, t);
    const double angle = pose.rotation_rad.norm();
    const Mat3 turn =
        angle > 0.0 ? Eigen::AngleAxisd(angle, pose.rotation_rad / angle).toRotationMatrix() : Mat3(Mat3::Identity());
    const Vec3 centre = centroid(handle.nodes, model.start_q);
    for (int n : handle.nodes)
      offset.segment<3>(3 * n) = centre + turn * (model.start_q.segment<3>(3 * n) - centre) + pose.translation_m;
  }
}

}  // namespace slipstitch
