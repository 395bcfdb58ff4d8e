// SPDX-License-Identifier: MIT
#include "model/check_parts.h"

namespace slipstitch {
namespace {

// Visits of the knit's yarn: eight a stitch, two a turn, two tail ends or the slip knot's.
int knit_visits(const Knit& knit) {
  const Pattern& pattern = knit.pattern;
  const int turns = pattern.in_the_round ? 0 : 2 * (pattern.courses - 1);
  return 8 * pattern.courses * pattern.wales + turns + (knit.ends_woven_in ? 1 : 2);
}

struct CheckSelector {
  const Scene& scene;
  const std::string& path;
  Checker& check;

  bool has_knit() const {
    if (!scene.knit) check.fail(path, "stitches in a scene without a knit", "a yarn_point or all");
    return scene.knit.has_value();
  }
  void operator()(Corner) const { has_knit(); }
  void operator()(Edge) const { has_knit(); }
  void operator()(const AllNodes&) const {}

  void operator()(const StitchRange& range) const {
    if (!has_knit()) return;
    const std::string at = path + ".stitches.";
    const Pattern& pattern = scene.knit->pattern;
    check.require_index(at + "first_course", range.first_course, 1, pattern.courses);
    check.require_index(at + "last_course", range.last_course, 1, pattern.courses);
    check.require_index(at + "first_wale", range.first_wale, 1, pattern.wales);
    check.require_index(at + "last_wale", range.last_wale, 1, pattern.wales);
    if (range.last_course < range.first_course) {
      check.fail(at + "last_course", std::to_string(range.last_course), "not below first_course");
    }
    if (range.last_wale < range.first_wale) {
      check.fail(at + "last_wale", std::to_string(range.last_wale), "not below first_wale");
    }
  }

  void operator()(const YarnPoint& point) const {
    const int bare = static_cast<int>(scene.yarns.size()), yarns = bare + (scene.knit ? 1 : 0);
    if (yarns == 0) return;  // reported for the scene
    check.require_index(path + ".yarn_point.yarn", point.yarn, 0, yarns - 1);
    if (point.yarn < 0 || point.yarn >= yarns) return;
    const int points = point.yarn < bare
                           ? static_cast<int>(scene.yarns[static_cast<std::size_t>(point.yarn)].points.size())
                           : knit_visits(*scene.knit);
    check.require_index(path + ".yarn_point.point", point.point, -points, points - 1);
  }
};

void check_selector(const Scene& scene, const Selector& where, const std::string& path, Checker& check) {
  std::visit(CheckSelector{scene, path, check}, where);
}

}  // namespace

void check_motion(const std::vector<Keyframe>& motion, const std::string& path, Checker& check) {
  for (std::size_t i = 0; i < motion.size(); ++i) {
    const std::string at = element(path, i);
    const bool later = i == 0 || !std::isfinite(motion[i - 1].t) || motion[i].t > motion[i - 1].t;
    check.require(later, at + ".t", motion[i].t, "a finite number, greater than the one before");
    check.finite(at + ".translation_m", motion[i].translation_m);
    check.finite(at + ".rotation_rad", motion[i].rotation_rad);
  }
}

void check_actions(const Scene& scene, Checker& check) {
  for (std::size_t i = 0; i < scene.handles.size(); ++i) {
    const std::string path = element("handles", i);
    check_selector(scene, scene.handles[i].where, path + ".where", check);
    check_motion(scene.handles[i].motion, path + ".motion", check);
    if (const auto& velocity = scene.handles[i].velocity_m_per_s) {
      check.finite(path + ".velocity_m_per_s", *velocity);
      if (!scene.handles[i].motion.empty()) {
        check.fail(path + ".velocity_m_per_s", "given", "either motion or velocity_m_per_s, not both");
      }
    }
  }
  for (std::size_t i = 0; i < scene.loads.size(); ++i) {
    const std::string path = element("loads", i);
    check_selector(scene, scene.loads[i].where, path + ".where", check);
    check.finite(path + ".force_n", scene.loads[i].force_n);
  }
  for (std::size_t i = 0; i < scene.initial_velocities.size(); ++i) {
    const std::string path = element("initial_velocities", i);
    check_selector(scene, scene.initial_velocities[i].where, path + ".where", check);
    check.finite(path + ".velocity_m_per_s", scene.initial_velocities[i].velocity_m_per_s);
  }
}

}  // namespace slipstitch
