// SPDX-License-Identifier: MIT
#include "model/check_parts.h"

namespace slipstitch {
namespace {

constexpr int kMostExtraNodes = 8;

// What reads patterns names the row; here only what it cannot have let through.
void check_pattern(const Pattern& pattern, const SceneLimits& limits, Checker& check) {
  const long stitches = static_cast<long>(pattern.courses) * pattern.wales;
  const std::string size = std::to_string(pattern.courses) + " courses of " + std::to_string(pattern.wales) + " wales";
  if (pattern.courses < 2 || pattern.wales < 2) {
    check.fail("knit", size, "a pattern of at least 2 courses and 2 wales");
  } else if (stitches > limits.max_stitches) {
    check.too_big("knit", std::to_string(stitches), limits.max_stitches, "stitches");
  } else if (pattern.cells.size() != static_cast<std::size_t>(stitches)) {
    check.fail("knit", std::to_string(pattern.cells.size()) + " stitches", size);
  }
}

void check_gauge(const Gauge& gauge, Checker& check) {
  const std::string path = "knit.gauge";
  if (gauge.course_spacing_m) check.positive(path + ".course_spacing_m", *gauge.course_spacing_m);
  if (gauge.wale_spacing_m) check.positive(path + ".wale_spacing_m", *gauge.wale_spacing_m);
  if (gauge.yarn_per_stitch_m) check.positive(path + ".yarn_per_stitch_m", *gauge.yarn_per_stitch_m);

  const int spacings = (gauge.course_spacing_m ? 1 : 0) + (gauge.wale_spacing_m ? 1 : 0);
  const std::string expected = "either course_spacing_m and wale_spacing_m, or yarn_per_stitch_m";
  if (spacings > 0 && gauge.yarn_per_stitch_m) check.fail(path, "both", expected);
  if (spacings == 1 && !gauge.yarn_per_stitch_m) {
    check.fail(path, gauge.course_spacing_m ? "course_spacing_m alone" : "wale_spacing_m alone", expected);
  }
  if (spacings == 0 && !gauge.yarn_per_stitch_m) check.fail(path, "empty", expected);
}

void check_placement(const Placement& placement, Checker& check) {
  const std::string path = "knit.placement.";
  check.finite(path + "origin_m", placement.origin_m);
  check.finite(path + "course_direction", placement.course_direction);
  check.finite(path + "wale_direction", placement.wale_direction);
  const Vec3& course = placement.course_direction;
  const Vec3& wale = placement.wale_direction;
  if (!course.allFinite() || !wale.allFinite()) return;
  const double lengths = course.stableNorm() * wale.stableNorm();
  if (course.isZero(0.0)) check.fail(path + "course_direction", "[0, 0, 0]", "a direction, not zero");
  if (wale.isZero(0.0)) check.fail(path + "wale_direction", "[0, 0, 0]", "a direction, not zero");
  if (course.isZero(0.0) || wale.isZero(0.0)) return;
  constexpr double kSmallestSine = 1e-6;
  if (!std::isfinite(lengths) || lengths < 1e-200) {
    check.fail(path + "wale_direction", "out of range", "directions of length about 1");
  } else if (course.cross(wale).norm() < kSmallestSine * lengths) {
    check.fail(path + "wale_direction", "parallel to course_direction", "a direction across the course");
  }
}

}  // namespace

void check_knit(const Knit& knit, const SceneLimits& limits, Checker& check) {
  check_pattern(knit.pattern, limits, check);
  check_gauge(knit.gauge, check);
  check_placement(knit.placement, check);
  check.not_negative("knit.noise_m", knit.noise_m);
  if (knit.refine < 0 || knit.refine > kMostExtraNodes)
    check.fail("knit.refine", std::to_string(knit.refine), "0 to " + std::to_string(kMostExtraNodes));
}

}  // namespace slipstitch
