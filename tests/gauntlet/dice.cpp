// SPDX-License-Identifier: MIT
#include "gauntlet/dice.h"

#include <algorithm>
#include <cmath>

namespace slipstitch::gauntlet {

double Dice::unit() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }

double Dice::uniform(double low, double high) { return low + (high - low) * unit(); }

double Dice::log_uniform(double low, double high) {
  // Even within an octave: libraries round exponentials differently.
  const double octaves = std::log2(high / low) * unit(), whole = std::floor(octaves);
  return std::min(high, std::ldexp(low * (1.0 + (octaves - whole)), static_cast<int>(whole)));
}

int Dice::between(int low, int high) { return std::min(high, low + static_cast<int>(unit() * (high - low + 1))); }

bool Dice::chance(double share) { return unit() < share; }

Vec3 Dice::direction() {
  while (true) {
    const double x = uniform(-1.0, 1.0), y = uniform(-1.0, 1.0), z = uniform(-1.0, 1.0);
    const Vec3 inside(x, y, z);
    const double length = inside.norm();
    if (length > 0.1 && length <= 1.0) return inside / length;
  }
}

}  // namespace slipstitch::gauntlet
