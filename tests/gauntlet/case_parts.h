// SPDX-License-Identifier: MIT
#pragma once

#include "gauntlet/gauntlet_case.h"
#include "support/knit_scene.h"

namespace slipstitch::gauntlet {

GauntletCase named(const std::string& name, const std::string& about, Scene scene);
Handle pin(Selector where);
Collider body(Shape shape, double friction = 0.3);

/// A stockinette swatch of the demo's feel, free, without weight.
Scene swatch(int courses, int wales);

/// Pins at the upper two corners, and weight.
void hang(Scene& scene);

/// Rigid bodies that the yarn touches.
void put(Scene& scene, std::vector<Collider> colliders);

/// Changes the positions at the start.
std::function<void(Model&)> placed(std::function<Vec3(const Vec3& x)> place);

}  // namespace slipstitch::gauntlet
