// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "knit_helpers.h"
#include "model/effect_list.h"
#include "support/collider_shapes.h"

namespace slipstitch {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

// A scene that uses everything and is right.
Scene good_scene() {
  Scene scene;
  scene.knit = test::stockinette(3, 4);
  scene.knit->gauge.yarn_per_stitch_m = 11.28e-3;
  for (int y = 0; y < 2; ++y) {
    BareYarn yarn;
    for (int i = 0; i < 5; ++i) yarn.points.emplace_back(0.01 * i, 0.1 * y, 0.0);
    scene.yarns.push_back(yarn);
  }
  scene.yarns[1].arc_lengths_m = {0, 1, 2, 3, 4};
  scene.guides = {{0, 1}};
  scene.crossings = {{0, 2, 1, 2}};
  Effects& on = scene.effects;
  on.inertia.emplace();
  on.gravity.emplace();
  on.stretch.emplace();
  on.bending.emplace();
  on.bending_jamming.emplace();
  on.wrapping.emplace();
  on.contact_length.emplace();
  on.parallel_contact.emplace();
  on.sliding.emplace();
  on.sliding_friction.emplace();
  on.damping.emplace();
  on.air_drag.emplace();
  on.wind.emplace();
  on.plasticity.emplace();
  on.shrinkage.emplace().keyframes = {{0.0, 1.0}, {1.0, 0.9}};
  on.self_collision.emplace();
  on.colliders.emplace().colliders = {{Plane{}, 0.3, {{0.0}, {1.0, Vec3::UnitY()}}},
                                      {Sphere{Vec3::Zero(), 0.1}, 0.0, {}},
                                      {Capsule{Vec3::Zero(), Vec3::UnitX(), 0.1}, 0.3, {}},
                                      {Box{Vec3::Zero(), Vec3::Ones(), Vec3::Zero()}, 0.3, {}},
                                      {test::box_mesh(Vec3::Zero(), Vec3::Ones()), 0.3, {}},
                                      {Sphere{Vec3::Ones(), 0.1}, 0.3, {}, DynamicBody{0.01, Vec3::UnitX()}}};
  scene.handles = {{Corner::top_left, {{0.0, {}, {}}, {1.0, {0, 1, 0}, {}}}, false}, {YarnPoint{2, -1}, {}, false}};
  for (Keyframe& key : scene.handles[0].motion) key.rotation_rad = key.translation_m = Vec3::Zero();
  scene.loads = {{StitchRange{1, 3, 1, 4}, {0, -1, 0}}};
  scene.initial_velocities = {{AllNodes{}, {1, 0, 0}}};
  return scene;
}

template <class S>
S& body(Scene& scene, std::size_t i) {
  return std::get<S>(scene.effects.colliders->colliders[i].shape);
}

DynamicBody& dynamic(Scene& scene) { return *scene.effects.colliders->colliders[5].dynamic; }

struct Bad {
  std::string path;  // of the one issue
  std::function<void(Scene&)> spoil;
  bool too_big = false;
};

const std::vector<Bad>& bad_scenes() {
  static const std::vector<Bad> all{
      {"", [](Scene& s) { s = Scene{}; }},
      {"knit",
       [](Scene& s) {
         s.knit->pattern = {};
         s.handles.clear();
         s.loads.clear();
       }},
      {"knit", [](Scene& s) { s.knit->pattern.cells.pop_back(); }},
      {"knit", [](Scene& s) { s.knit->pattern.courses = s.knit->pattern.wales = 50000; }, true},
      {"knit.gauge", [](Scene& s) { s.knit->gauge = {}; }},
      {"knit.gauge",
       [](Scene& s) {
         s.knit->gauge = {3e-3, {}, {}};
       }},
      {"knit.gauge",
       [](Scene& s) {
         s.knit->gauge = {{}, 3e-3, {}};
       }},
      {"knit.gauge",
       [](Scene& s) {
         s.knit->gauge = {3e-3, 2e-3, 1e-2};
       }},
      {"knit.gauge.course_spacing_m",
       [](Scene& s) {
         s.knit->gauge = {-3e-3, 2e-3, {}};
       }},
      {"knit.gauge.wale_spacing_m",
       [](Scene& s) {
         s.knit->gauge = {3e-3, kNan, {}};
       }},
      {"knit.gauge.yarn_per_stitch_m", [](Scene& s) { s.knit->gauge.yarn_per_stitch_m = 0.0; }},
      {"knit.placement.origin_m[2]", [](Scene& s) { s.knit->placement.origin_m.z() = kInf; }},
      {"knit.placement.course_direction", [](Scene& s) { s.knit->placement.course_direction.setZero(); }},
      {"knit.placement.wale_direction", [](Scene& s) { s.knit->placement.wale_direction.setZero(); }},
      {"knit.placement.wale_direction",
       [](Scene& s) {
         s.knit->placement.wale_direction = {-3, 0, 0};
       }},
      {"knit.placement.wale_direction[0]", [](Scene& s) { s.knit->placement.wale_direction.x() = kNan; }},
      {"knit.noise_m", [](Scene& s) { s.knit->noise_m = -1e-9; }},
      {"yarns[0].points_m",
       [](Scene& s) {
         s.yarns[0].points.resize(1);
         s.guides.clear();
         s.crossings.clear();
       }},
      {"yarns[1].points_m[7]", [](Scene& s) { s.yarns[1].points[2].y() = kNan; }},
      {"yarns[1].points_m[9]", [](Scene& s) { s.yarns[1].points[3] = s.yarns[1].points[2]; }},
      {"yarns[0].prestretch", [](Scene& s) { s.yarns[0].prestretch = 0.0; }},
      {"yarns[1].arc_lengths_m", [](Scene& s) { s.yarns[1].arc_lengths_m.pop_back(); }},
      {"yarns[1].arc_lengths_m[2]", [](Scene& s) { s.yarns[1].arc_lengths_m[2] = 1.0; }},
      {"yarns[0].velocity_m_per_s[1]", [](Scene& s) { s.yarns[0].velocity_m_per_s.y() = kInf; }},
      {"guides[0].yarn", [](Scene& s) { s.guides[0].yarn = 2; }},
      {"guides[0].point", [](Scene& s) { s.guides[0].point = 0; }},
      {"guides[0].point", [](Scene& s) { s.guides[0].point = 4; }},
      {"guides[1].point", [](Scene& s) { s.guides.push_back(s.guides[0]); }},
      {"crossings[0].yarn_b",
       [](Scene& s) {
         s.crossings[0] = {0, 1, 0, 3};
       }},
      {"crossings[0].yarn_a", [](Scene& s) { s.crossings[0].yarn_a = -1; }},
      {"crossings[0].point_b", [](Scene& s) { s.crossings[0].point_b = 9; }},
      {"crossings[1].point_a",
       [](Scene& s) {
         s.crossings.push_back({0, 2, 1, 3});
       }},
      {"crossings[0].point_b", [](Scene& s) { s.yarns[1].points[3] = s.yarns[0].points[2]; }},
      {"yarn.radius_m", [](Scene& s) { s.yarn.radius_m = -1.0; }},
      {"yarn.linear_density_kg_per_m", [](Scene& s) { s.yarn.linear_density_kg_per_m = 0.0; }},
      {"yarn.stretch_n", [](Scene& s) { s.yarn.stretch_n = kNan; }},
      {"yarn.bending_nm2", [](Scene& s) { s.yarn.bending_nm2 = kInf; }},
      {"effects.inertia.sliding_mass_fraction", [](Scene& s) { s.effects.inertia->sliding_mass_fraction = -1.0; }},
      {"effects.gravity.acceleration_m_per_s2[1]",
       [](Scene& s) { s.effects.gravity->acceleration_m_per_s2.y() = kNan; }},
      {"effects.bending_jamming.max_factor", [](Scene& s) { s.effects.bending_jamming->max_factor = 0.5; }},
      {"effects.bending_jamming.full_at", [](Scene& s) { s.effects.bending_jamming->full_at = 1.0; }},
      {"effects.bending_jamming",
       [](Scene& s) {
         s.effects.bending.reset();
         s.effects.plasticity.reset();
       }},
      {"effects.plasticity",
       [](Scene& s) {
         s.effects.bending.reset();
         s.effects.bending_jamming.reset();
       }},
      {"effects.plasticity.yield_angle_rad", [](Scene& s) { s.effects.plasticity->yield_angle_rad = -0.1; }},
      {"effects.plasticity.relaxation_time_s", [](Scene& s) { s.effects.plasticity->relaxation_time_s = 0.0; }},
      {"effects.wrapping.alpha", [](Scene& s) { s.effects.wrapping->alpha = -1.0; }},
      {"effects.wrapping.stiffness_n", [](Scene& s) { s.effects.wrapping->stiffness_n = kNan; }},
      {"effects.wrapping.rest_angle_rad", [](Scene& s) { s.effects.wrapping->rest_angle_rad = kPi; }},
      {"effects.contact_length.stiffness_n", [](Scene& s) { s.effects.contact_length->stiffness_n = 0.0; }},
      {"effects.parallel_contact.stiffness_n_per_m2",
       [](Scene& s) { s.effects.parallel_contact->stiffness_n_per_m2 = -1.0; }},
      {"effects.parallel_contact.rest_ratio", [](Scene& s) { s.effects.parallel_contact->rest_ratio = 1.1; }},
      {"effects.sliding_friction.coefficient", [](Scene& s) { s.effects.sliding_friction->coefficient = -0.1; }},
      {"effects.sliding_friction.stick_stiffness_n_per_m",
       [](Scene& s) { s.effects.sliding_friction->stick_stiffness_n_per_m = 0.0; }},
      {"effects.sliding_friction.normal_force_n", [](Scene& s) { s.effects.sliding_friction->normal_force_n = -1.0; }},
      {"effects.damping.stretch_ns", [](Scene& s) { s.effects.damping->stretch_ns = -1.0; }},
      {"effects.damping.bending_nm2s", [](Scene& s) { s.effects.damping->bending_nm2s = kInf; }},
      {"effects.damping.wrapping_ns", [](Scene& s) { s.effects.damping->wrapping_ns = -1.0; }},
      {"effects.damping.sliding_ns_per_m", [](Scene& s) { s.effects.damping->sliding_ns_per_m = -1.0; }},
      {"effects.damping.sliding_ns_per_m",
       [](Scene& s) {
         s.effects.damping->sliding_ns_per_m = 1.0;
         for (const char* effect : {"contact_length", "parallel_contact", "sliding_friction"})
           find_effect(effect)->remove(s.effects);
         s.effects.sliding.reset();
       }},
      {"effects.auto.tolerance_m", [](Scene& s) { s.effects.automatic = AutoEffects{0.0, {}}; }},
      {"effects.auto.window_s", [](Scene& s) { s.effects.automatic = AutoEffects{{}, kNan}; }},
      {"effects.self_collision.stiffness_n", [](Scene& s) { s.effects.self_collision->stiffness_n = 0.0; }},
      {"effects.colliders.colliders", [](Scene& s) { s.effects.colliders->colliders.clear(); }},
      {"effects.colliders.stiffness_n", [](Scene& s) { s.effects.colliders->stiffness_n = -1.0; }},
      {"effects.colliders.stick_stiffness_n_per_m",
       [](Scene& s) { s.effects.colliders->stick_stiffness_n_per_m = kInf; }},
      {"effects.colliders.colliders[0].plane.normal", [](Scene& s) { body<Plane>(s, 0).normal.setZero(); }},
      {"effects.colliders.colliders[0].friction_coefficient",
       [](Scene& s) { s.effects.colliders->colliders[0].friction = -0.1; }},
      {"effects.colliders.colliders[0].motion[1].t",
       [](Scene& s) { s.effects.colliders->colliders[0].motion[1].t = 0.0; }},
      {"effects.colliders.colliders[1].sphere.radius_m", [](Scene& s) { body<Sphere>(s, 1).radius = kNan; }},
      {"effects.colliders.colliders[2].capsule.b_m", [](Scene& s) { body<Capsule>(s, 2).b.setZero(); }},
      {"effects.colliders.colliders[2].capsule.radius_m", [](Scene& s) { body<Capsule>(s, 2).radius = 0.0; }},
      {"effects.colliders.colliders[3].box.half_size_m", [](Scene& s) { body<Box>(s, 3).half_size.z() = 0.0; }},
      {"effects.colliders.colliders[4].mesh.triangles",
       [](Scene& s) { body<TriangleMesh>(s, 4).triangles.pop_back(); }},
      {"effects.colliders.colliders[4].mesh.triangles[2]",
       [](Scene& s) { body<TriangleMesh>(s, 4).triangles[0][2] = 8; }},
      {"effects.colliders.colliders[4].mesh.triangles",
       [](Scene& s) {
         for (auto& triangle : body<TriangleMesh>(s, 4).triangles) std::swap(triangle[0], triangle[1]);  // inside out
       }},
      {"effects.colliders.colliders[5].dynamic.mass_kg", [](Scene& s) { dynamic(s).mass_kg = 0.0; }},
      {"effects.colliders.colliders[5].dynamic.mass_kg", [](Scene& s) { dynamic(s).mass_kg = kInf; }},
      {"effects.colliders.colliders[5].dynamic.velocity_m_per_s[1]",
       [](Scene& s) { dynamic(s).velocity_m_per_s.y() = kNan; }},
      {"effects.colliders.colliders[5].dynamic", [](Scene& s) { s.effects.colliders->colliders[5].motion = {{1.0}}; }},
      {"effects.colliders.colliders[2].dynamic",
       [](Scene& s) { s.effects.colliders->colliders[2].dynamic = DynamicBody{0.01}; }},
      {"effects.colliders.colliders[5].dynamic",
       [](Scene& s) {
         s.effects.air_drag.reset();
         s.effects.wind.reset();
         s.effects.inertia.reset();
       }},
      {"effects.air_drag.linear_ns_per_m2", [](Scene& s) { s.effects.air_drag->linear_ns_per_m2 = -1.0; }},
      {"effects.air_drag.quadratic_ns2_per_m3", [](Scene& s) { s.effects.air_drag->quadratic_ns2_per_m3 = kNan; }},
      {"effects.air_drag",
       [](Scene& s) {
         s.effects.colliders.reset();
         s.effects.inertia.reset();
       }},
      {"effects.wind", [](Scene& s) { s.effects.air_drag.reset(); }},
      {"effects.wind.velocity_m_per_s[0]", [](Scene& s) { s.effects.wind->velocity_m_per_s.x() = kInf; }},
      {"effects.wind.gust_velocity_m_per_s[2]", [](Scene& s) { s.effects.wind->gust_velocity_m_per_s.z() = kNan; }},
      {"effects.wind.gust_period_s", [](Scene& s) { s.effects.wind->gust_period_s = 0.0; }},
      {"effects.shrinkage", [](Scene& s) { s.effects.stretch.reset(); }},
      {"effects.shrinkage.keyframes", [](Scene& s) { s.effects.shrinkage->keyframes.clear(); }},
      {"effects.shrinkage.keyframes[0].t", [](Scene& s) { s.effects.shrinkage->keyframes[0].t = -1.0; }},
      {"effects.shrinkage.keyframes[1].t", [](Scene& s) { s.effects.shrinkage->keyframes[1].t = 0.0; }},
      {"effects.shrinkage.keyframes[1].factor", [](Scene& s) { s.effects.shrinkage->keyframes[1].factor = 0.0; }},
      {"handles[0].where",
       [](Scene& s) {
         s.knit.reset();
         s.handles.resize(1);
         s.loads.clear();
       }},
      {"handles[1].where.yarn_point.yarn",
       [](Scene& s) {
         s.handles[1].where = YarnPoint{3, 0};
       }},
      {"handles[1].where.yarn_point.point",
       [](Scene& s) {
         s.handles[1].where = YarnPoint{0, -6};
       }},
      {"handles[1].where.yarn_point.point",
       [](Scene& s) {
         s.handles[1].where = YarnPoint{2, 8 * 12 + 4 + 2};
       }},
      {"handles[0].motion[1].t", [](Scene& s) { s.handles[0].motion[1].t = 0.0; }},
      {"handles[0].motion[0].translation_m[0]", [](Scene& s) { s.handles[0].motion[0].translation_m.x() = kNan; }},
      {"handles[0].motion[1].rotation_rad[2]", [](Scene& s) { s.handles[0].motion[1].rotation_rad.z() = kInf; }},
      {"handles[0].velocity_m_per_s", [](Scene& s) { s.handles[0].velocity_m_per_s = Vec3(1.0, 0.0, 0.0); }},
      {"handles[1].velocity_m_per_s[1]", [](Scene& s) { s.handles[1].velocity_m_per_s = Vec3(0.0, kNan, 0.0); }},
      {"loads[0].where.stitches.last_course",
       [](Scene& s) {
         s.loads[0].where = StitchRange{1, 4, 1, 4};
       }},
      {"loads[0].where.stitches.first_wale",
       [](Scene& s) {
         s.loads[0].where = StitchRange{1, 3, 0, 4};
       }},
      {"loads[0].where.stitches.last_wale",
       [](Scene& s) {
         s.loads[0].where = StitchRange{1, 3, 3, 2};
       }},
      {"loads[0].force_n[1]", [](Scene& s) { s.loads[0].force_n.y() = kNan; }},
      {"initial_velocities[0].velocity_m_per_s[0]",
       [](Scene& s) { s.initial_velocities[0].velocity_m_per_s.x() = kNan; }},
      {"duration_s", [](Scene& s) { s.duration_s = -1.0; }},
      {"frames_per_s", [](Scene& s) { s.frames_per_s = 0.0; }},
      {"frames_per_s", [](Scene& s) { s.frames_per_s = 1e9; }, true},
      {"accuracy.tolerance_m", [](Scene& s) { s.numerics = AccuracyNumerics{0.0}; }},
      {"accuracy.tolerance_m", [](Scene& s) { s.numerics = AccuracyNumerics{kNan}; }},
      {"accuracy.budget_s", [](Scene& s) { s.numerics = BudgetNumerics{0.0}; }},
      {"accuracy.budget_s", [](Scene& s) { s.numerics = BudgetNumerics{kNan}; }},
      {"fixed.time_step_s",
       [](Scene& s) {
         s.numerics = FixedNumerics{0.0, 1e-4, 1e-9, 60, 1e-7};
       }},
      {"fixed.velocity_tolerance_m_per_s",
       [](Scene& s) {
         s.numerics = FixedNumerics{1e-3, kNan, 1e-9, 60, 1e-7};
       }},
      {"fixed.force_tolerance_n",
       [](Scene& s) {
         s.numerics = FixedNumerics{1e-3, 1e-4, -1.0, 60, 1e-7};
       }},
      {"fixed.max_newton_iterations",
       [](Scene& s) {
         s.numerics = FixedNumerics{1e-3, 1e-4, 1e-9, 0, 1e-7};
       }},
      {"fixed.smallest_step_s", [](Scene& s) { std::get<FixedNumerics>(s.numerics).smallest_step_s = 1.0; }},
      {"fixed.time_step_s",
       [](Scene& s) {
         s.duration_s = 1.0;
         std::get<FixedNumerics>(s.numerics).time_step_s = 0.99e-9;
         std::get<FixedNumerics>(s.numerics).smallest_step_s = 1e-10;
       }},
      {"fixed.smallest_step_s",
       [](Scene& s) {
         s.numerics = FixedNumerics{1e-3, 1e-4, 1e-9, 60, kInf};
       }},
  };
  return all;
}

TEST(Check, AGoodSceneHasNoProblem) {
  for (const Issue& issue : check(good_scene())) ADD_FAILURE() << issue.path << ": " << issue.value;
  Scene gauge = good_scene();
  gauge.knit->gauge = {2.9e-3, 2.03e-3, {}};
  EXPECT_TRUE(check(gauge).empty());
}

TEST(Check, NamesEachProblemOnceAtItsPlace) {
  for (std::size_t i = 0; i < bad_scenes().size(); ++i) {
    const Bad& bad = bad_scenes()[i];
    Scene scene = good_scene();
    bad.spoil(scene);
    const Issues issues = check(scene);
    ASSERT_EQ(issues.size(), 1u) << "case " << i << " " << bad.path;
    EXPECT_EQ(issues[0].path, bad.path);
    EXPECT_EQ(issues[0].too_big, bad.too_big) << bad.path;
    EXPECT_FALSE(issues[0].value.empty());
    EXPECT_FALSE(issues[0].expected.empty());
  }
}

TEST(Check, LeavesPrerequisitesToTheChoiceWhereItIsLeftToTheProgram) {
  Scene scene = good_scene();
  scene.effects.sliding.reset();
  EXPECT_FALSE(check(scene).empty());
  scene.effects.automatic.emplace();
  EXPECT_TRUE(check(scene).empty());
}

TEST(Check, NamesAreShortAndPrintable) {
  for (const std::string& name :
       {std::string(201, 'n'), std::string("two\nlines"), std::string("\x1b[31mred"), std::string("\x7f")}) {
    Scene scene = good_scene();
    scene.name = name;
    const Issues issues = check(scene);
    ASSERT_EQ(issues.size(), 1u);
    EXPECT_EQ(issues[0].path, "name");
  }
  Scene scene = good_scene();
  scene.name = std::string(198, 'n') + "\xc3\xa9";
  EXPECT_TRUE(check(scene).empty());
}

TEST(Check, NamesAllProblemsAtOnce) {
  Scene scene = good_scene();
  scene.yarn.radius_m = -1.0;
  scene.effects.sliding.reset();  // friction, contact length and parallel contact need it
  scene.handles[0].motion[1].t = kNan;
  scene.duration_s = kInf;
  std::vector<std::string> paths;
  for (const Issue& issue : check(scene)) paths.push_back(issue.path);
  EXPECT_EQ(paths, (std::vector<std::string>{"yarn.radius_m", "effects.contact_length", "effects.parallel_contact",
                                             "effects.sliding_friction", "handles[0].motion[1].t", "duration_s"}));
}

TEST(Check, HoldsTheLimitsItIsGiven) {
  const Scene scene = good_scene();
  SceneLimits limits;
  limits.max_stitches = 12;
  limits.max_yarn_points = 10;
  limits.max_frames = 31;
  EXPECT_TRUE(check(scene, limits).empty());
  limits = {11, 9, 30};
  const Issues issues = check(scene, limits);
  ASSERT_EQ(issues.size(), 3u);
  for (std::size_t i = 0; i < issues.size(); ++i) {
    EXPECT_TRUE(issues[i].too_big) << issues[i].path;
    EXPECT_EQ(issues[i].limit, std::vector<long>({11, 9, 30})[i]) << issues[i].path;
  }
}

TEST(Check, CountsFramesBeyondEveryNumber) {
  Scene scene = good_scene();
  scene.duration_s = scene.frames_per_s = 1e200;
  const Issues issues = check(scene);
  ASSERT_EQ(issues.size(), 1u);
  EXPECT_EQ(issues[0].value, "too many frames");
}

}  // namespace
}  // namespace slipstitch
