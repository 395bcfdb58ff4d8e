// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "model/collider.h"
#include "study/growing_sets.h"

namespace slipstitch {

/// What stands still in a picture: bodies at a time.
struct PictureBodies {
  std::vector<Collider> colliders;
  double t = 0.0;
};

/// One panel a set, side by side at one scale: the yarns of the last frame as they look from the front and above, with
/// spheres and capsules; the bodies that a set does not know are drawn as outlines. SVG.
std::string growing_picture(const std::string& scene, const std::vector<GrowingSet>& sets, const PictureBodies& bodies);

}  // namespace slipstitch
