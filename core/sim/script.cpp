// SPDX-License-Identifier: MIT
#include <algorithm>

#include "sim/simulation.h"

namespace slipstitch {
namespace {

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
    const Keyframe pose = motion_at(handle.motion, t);
    const Mat3 turn = turn_by(pose.rotation_rad);
    const Vec3 centre = centroid(handle.nodes, model.start_q);
    for (int n : handle.nodes)
      offset.segment<3>(3 * n) = centre + turn * (model.start_q.segment<3>(3 * n) - centre) + pose.translation_m;
  }
}

}  // namespace slipstitch
