// SPDX-License-Identifier: MIT
#include "force/stick_slip.h"

namespace slipstitch {

StickSlip::Pull StickSlip::pull(const Vec3& x) const {
  const Mat3 along = Mat3::Identity() - normal * normal.transpose();
  Pull pull;
  pull.way = along * (x - anchor);
  const double way = pull.way.norm();
  const bool sticks = k * way <= limit;
  pull.force_over_way = sticks ? k : limit / way;
  pull.value = sticks ? 0.5 * k * way * way : limit * way - limit * limit / (2.0 * k);
  if (sticks) {
    pull.stiffness = k * along;
  } else {  // across the way only; as a square, which round-off leaves positive
    const Vec3 across = normal.cross(pull.way) / way;
    pull.stiffness = pull.force_over_way * across * across.transpose();
  }
  return pull;
}

Vec3 StickSlip::dragged(const Vec3& x) const {
  const Vec3 way = x - anchor - normal * normal.dot(x - anchor);
  const double length = way.norm(), reach = limit / k;
  return x - (length > reach ? reach / length : 1.0) * way;
}

}  // namespace slipstitch
