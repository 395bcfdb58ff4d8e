// SPDX-License-Identifier: MIT
#pragma once

#include "model/model.h"

namespace slipstitch::gauntlet {

struct RigidMove {
  Mat3 turn = Mat3::Identity();
  Vec3 shift = Vec3::Zero();
  Vec3 point(const Vec3& x) const { return turn * x + shift; }
};

/// The same model elsewhere: fabric, scripts, bodies, weight, loads and wind all turned and shifted.
Model moved_rigidly(Model model, const RigidMove& move);

}  // namespace slipstitch::gauntlet
