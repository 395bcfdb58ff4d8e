// SPDX-License-Identifier: MIT
#include <algorithm>
#include <set>
#include <utility>

#include "model/check_parts.h"

namespace slipstitch {
namespace {

std::string point_text(const Vec3& x) {
  return "[" + number_text(x.x()) + ", " + number_text(x.y()) + ", " + number_text(x.z()) + "]";
}

void check_points(const BareYarn& yarn, const std::string& path, Checker& check) {
  const auto& x = yarn.points;
  if (x.size() < 2) check.fail(path, std::to_string(x.size()) + " points", "at least 2 points");
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) check.finite(element(path, 3 * i + c), x[i][static_cast<Eigen::Index>(c)]);
    if (i > 0 && x[i].allFinite() && (x[i] - x[i - 1]).isZero(0.0)) {
      check.fail(element(path, 3 * i), point_text(x[i]), "another place than the point before");
    }
  }
}

void check_arc_lengths(const BareYarn& yarn, const std::string& path, Checker& check) {
  const auto& arcs = yarn.arc_lengths_m;
  if (!arcs.empty() && arcs.size() != yarn.points.size()) {
    check.fail(path, std::to_string(arcs.size()) + " arc lengths",
               std::to_string(yarn.points.size()) + ", one per point");
  }
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    const bool ordered = i == 0 || !std::isfinite(arcs[i - 1]) || arcs[i] > arcs[i - 1];
    check.require(ordered, element(path, i), arcs[i], "a finite number, greater than the one before");
  }
}

// An inner point of a bare yarn; true when it is one.
bool check_point(const Scene& scene, const std::string& path, const char* suffix, int yarn, int point, Checker& check) {
  const int yarns = static_cast<int>(scene.yarns.size());
  if (yarns == 0) {
    check.fail(path, "in a scene without yarns", "a scene with yarns");
    return false;
  }
  const bool yarn_exists = yarn >= 0 && yarn < yarns;
  check.require_index(path + ".yarn" + suffix, yarn, 0, yarns - 1);
  if (!yarn_exists) return false;
  const int last = static_cast<int>(scene.yarns[static_cast<std::size_t>(yarn)].points.size()) - 1;
  const bool inner = point >= 1 && point < last;
  if (!inner) {
    check.fail(path + ".point" + suffix, std::to_string(point),
               last >= 2 ? "an inner point, 1 to " + std::to_string(last - 1) : "a yarn with an inner point");
  }
  return inner;
}

void check_guides(const Scene& scene, Checker& check) {
  std::set<std::pair<int, int>> used;
  for (std::size_t i = 0; i < scene.guides.size(); ++i) {
    const Guide& guide = scene.guides[i];
    const std::string path = element("guides", i);
    if (!check_point(scene, path, "", guide.yarn, guide.point, check)) continue;
    if (!used.insert({guide.yarn, guide.point}).second) {
      check.fail(path + ".point", std::to_string(guide.point), "a point without another guide");
    }
  }
}

// Point b moves to point a and must not land on its own neighbours.
void check_landing(const Scene& scene, const Crossing& c, const std::string& path, Checker& check) {
  const Vec3& place = scene.yarns[static_cast<std::size_t>(c.yarn_a)].points[static_cast<std::size_t>(c.point_a)];
  const auto& x = scene.yarns[static_cast<std::size_t>(c.yarn_b)].points;
  const auto b = static_cast<std::size_t>(c.point_b);
  if ((x[b - 1] - place).isZero(0.0) || (x[b + 1] - place).isZero(0.0)) {
    check.fail(path + ".point_b", std::to_string(c.point_b), "a point whose neighbours are not where point_a is");
  }
}

void check_crossings(const Scene& scene, Checker& check) {
  std::set<std::pair<int, int>> used;
  for (std::size_t i = 0; i < scene.crossings.size(); ++i) {
    const Crossing& c = scene.crossings[i];
    const std::string path = element("crossings", i);
    const bool a = check_point(scene, path, "_a", c.yarn_a, c.point_a, check);
    const bool b = check_point(scene, path, "_b", c.yarn_b, c.point_b, check);
    if (!a || !b) continue;
    if (c.yarn_a == c.yarn_b) check.fail(path + ".yarn_b", std::to_string(c.yarn_b), "another yarn than yarn_a");
    check_landing(scene, c, path, check);
    if (!used.insert({c.yarn_a, c.point_a}).second) {
      check.fail(path + ".point_a", std::to_string(c.point_a), "a point in no other crossing");
    }
    if (!used.insert({c.yarn_b, c.point_b}).second) {
      check.fail(path + ".point_b", std::to_string(c.point_b), "a point in no other crossing");
    }
  }
}

}  // namespace

void check_yarns(const Scene& scene, const SceneLimits& limits, Checker& check) {
  std::size_t points = 0;
  for (const BareYarn& yarn : scene.yarns) points += yarn.points.size();
  if (points > static_cast<std::size_t>(std::max(limits.max_yarn_points, 0))) {
    check.too_big("yarns", std::to_string(points), limits.max_yarn_points, "points");
    return;
  }
  for (std::size_t i = 0; i < scene.yarns.size(); ++i) {
    const BareYarn& yarn = scene.yarns[i];
    const std::string path = element("yarns", i);
    check_points(yarn, path + ".points_m", check);
    check.positive(path + ".prestretch", yarn.prestretch);
    check_arc_lengths(yarn, path + ".arc_lengths_m", check);
    check.finite(path + ".velocity_m_per_s", yarn.velocity_m_per_s);
  }
  check_guides(scene, check);
  check_crossings(scene, check);
}

}  // namespace slipstitch
