// SPDX-License-Identifier: MIT
#include "model/drawn_loop.h"

#include <cmath>

namespace slipstitch {
namespace {

// Chosen so that the cell 2.9 mm x 2.03 mm of worsted acrylic with R = 0.524 mm takes 11.28 mm of yarn, the figures of
// Singal et al., Nat. Commun. 15, 2622 (2024) for stockinette.
constexpr double kLean = 0.9823;
constexpr double kReach = 0.75;

// Ends of the zone in which two loops touch, half distances between left and right clasp by the wale pitch and height
// by the course pitch. Chosen among about 100 drawn zones for free swatches at alpha = 1: tall stockinette curls back, wide
// stockinette to the front with hardly a yarn straight through an inner contact, garter lies flat, 1x1 rib narrows to
// 0.75. The piece between the crossings of the centrelines, (0.33, 0.20, 0.34), is too short: half of the inner wraps
// end straight. Zones like (0.34, 0.07, 0.52) make wide swatches roll sideways, (0.35, 0.04, 0.42) wide garter.
constexpr double kClaspP1X = 0.386;
constexpr double kClaspP2X = 0.030;
constexpr double kClaspP2Y = 0.482;

double across(double t) { return (t + kLean * std::sin(2.0 * t)) / (2.0 * kPi); }  // x / W

double sinker_of_leg(double leg_t) { return std::acos(1.0 / kReach - std::cos(leg_t)); }

// Where O's left leg meets N's sinker, in cell units: x(-leg_t) = x(-pi + sinker_t) at equal height.
double crossing_leg_t() {
  double low = 1.0, high = 1.22;  // brackets the one crossing for the constants above
  for (int i = 0; i < 60; ++i) {
    const double mid = 0.5 * (low + high);
    const double gap = across(-mid) - across(-kPi + sinker_of_leg(mid));
    (gap < 0.0 ? low : high) = mid;
  }
  return 0.5 * (low + high);
}

double blend(double from, double to, double s) {
  s = std::fmin(std::fmax(s, 0.0), 1.0);
  return from + (to - from) * s * s * s * (10.0 - 15.0 * s + 6.0 * s * s);
}

// +-1 at the clasps; neighbours meet half way in the sinker.
double face(const DrawnLoop& loop, const LoopFaces& faces, double t) {
  const double middle = 0.5 * (faces.base + (t < 0.0 ? faces.left : faces.right));
  const double from_end = kPi - std::fabs(t);
  if (from_end < loop.sinker_t) return blend(middle, faces.base, from_end / loop.sinker_t);
  return blend(faces.base, faces.head, (from_end - loop.leg_t) / (kPi - 2.0 * loop.leg_t));
}

}  // namespace

DrawnLoop draw_loop(double width_m, double height_m, double radius_m) {
  DrawnLoop loop;
  loop.width_m = width_m;
  loop.height_m = height_m;
  loop.leg_t = crossing_leg_t();
  loop.sinker_t = sinker_of_leg(loop.leg_t);
  const double leg_z = -std::cos(2.0 * loop.leg_t), sinker_z = -std::cos(2.0 * loop.sinker_t);
  loop.depth_m = 2.0 * radius_m / (leg_z - sinker_z);
  loop.p1_x = kClaspP1X * width_m;
  loop.p2_x = kClaspP2X * width_m;
  loop.p2_y = kClaspP2Y * height_m;
  loop.z = 0.5 * loop.depth_m * (leg_z + sinker_z);
  return loop;
}

Vec3 centreline(const DrawnLoop& loop, const LoopFaces& faces, double t) {
  return {loop.width_m * across(t), kReach * loop.height_m * std::cos(t),
          -face(loop, faces, t) * loop.depth_m * std::cos(2.0 * t)};
}

double centreline_length(const DrawnLoop& loop, const LoopFaces& faces) {
  constexpr int kPieces = 2000;  // chords of a smooth curve: relative error about 1e-6
  double length = 0.0;
  Vec3 last = centreline(loop, faces, -kPi);
  for (int i = 1; i <= kPieces; ++i) {
    const Vec3 next = centreline(loop, faces, -kPi + 2.0 * kPi * i / kPieces);
    length += (next - last).norm();
    last = next;
  }
  return length;
}

}  // namespace slipstitch
