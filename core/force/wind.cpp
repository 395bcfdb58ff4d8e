// SPDX-License-Identifier: MIT
#include "force/wind.h"

#include <cmath>

namespace slipstitch {

Vec3 air_velocity(const Effects& effects, double t) {
  if (!effects.wind) return Vec3::Zero();
  const WindEffect& wind = *effects.wind;
  return wind.velocity_m_per_s + std::sin(2.0 * kPi * t / wind.gust_period_s) * wind.gust_velocity_m_per_s;
}

}  // namespace slipstitch
