// SPDX-License-Identifier: MIT
// Yarn that is pressed against something keeps the contact while it grows, stretches or is levered aside.
#include "no_passage.h"

namespace slipstitch::testing {
namespace {

// At the points a tenth of a radius; between them, as far apart as growing yarn takes them within a step, more.
constexpr double kDeepest = 0.6 * kR;

/// let_down(), by `pull` N, while something 1.5 mm below the guide presses its hanging end 0.8 mm aside, before it
/// grows.
Scene pressed_let_down(double pull) {
  Scene scene = let_down();
  scene.effects.damping->sliding_ns_per_m = 0.1;
  scene.loads[0].force_n = {0, -pull, 0};
  scene.handles[0].motion = {{0.1, Vec3::Zero(), Vec3::Zero()}, {0.15, {0.06, 0, 0}, Vec3::Zero()}};
  return scene;
}

/// 0.8 mm towards the yarn, and much later 12 mm on.
std::vector<Keyframe> press() {
  return {
      {0.1, {-8e-4, 0, 0}, Vec3::Zero()}, {0.3, {-8e-4, 0, 0}, Vec3::Zero()}, {0.7, {-12.8e-3, 0, 0}, Vec3::Zero()}};
}

TEST(NoPassage, ABallPressesYarnAsideThatThenGrows) {
  for (const double radius : {3e-4, 1e-3}) {
    Scene scene = pressed_let_down(0.05);
    Collider ball;
    ball.shape = Sphere{{radius + kR, -1.5e-3, 0}, radius};
    ball.motion = press();
    scene.effects.colliders.emplace().colliders = {ball};
    EXPECT_LT(deepest(scene, 0.7), kDeepest) << radius;
  }
}

TEST(NoPassage, YarnPressesYarnAsideThatThenGrows) {
  Scene scene = pressed_let_down(0.05);
  scene.yarns.push_back(straight_yarn({1.05e-3, -1.5e-3, -0.01}, {1.05e-3, -1.5e-3, 0.01}, 10));
  scene.effects.self_collision.emplace();
  for (int point = 0; point <= 10; ++point) {
    scene.handles.push_back(pin(1, point));
    scene.handles.back().motion = press();
  }
  double least = 1.0, reached = 0.0;
  run_watched(scene, 0.7, [&](const Simulation& sim) {
    const Vec3 y = position(sim, 1, 5), x0 = position(sim, 0, -2), x1 = position(sim, 0, -1);
    for (int k = 0; k <= 2000; ++k)
      least = std::min(least, (y - (1.0 - k / 2000.0) * x0 - k / 2000.0 * x1).head<2>().norm());
    reached = x0.x() + (y.y() - x0.y()) / (x1.y() - x0.y()) * (x1.x() - x0.x()) - y.x();
  });
  EXPECT_GT(least, 1.35 * kR);
  EXPECT_LT(reached, -1.35 * kR);  // it still is on its side
}

TEST(NoPassage, ABarPressesYarnAsideThatThenStretches) {
  Scene scene;
  BareYarn yarn;
  yarn.points = {{0, 0, 0}, {0.01, 0, 0}, {0.012, 0, 0}};
  scene.yarns = {yarn};
  scene.yarn.stretch_n = 0.5;
  scene.effects.inertia.emplace();
  scene.effects.stretch.emplace();
  Collider bar;
  bar.shape = Capsule{{4e-3, -0.02, 1e-3 + kR}, {4e-3, 0.02, 1e-3 + kR}, 1e-3};
  bar.motion = {
      {0.1, {0, 0, -2e-3}, Vec3::Zero()}, {0.6, {0, 0, -2e-3}, Vec3::Zero()}, {0.8, {0, 0, -0.012}, Vec3::Zero()}};
  scene.effects.colliders.emplace().colliders = {bar};
  scene.effects.colliders->stiffness_n = 0.068;
  scene.handles = {pin(0, 0), pin(0, 2)};
  scene.handles[1].motion = {{0.1, Vec3::Zero(), Vec3::Zero()}, {0.5, {0.03, 0, 0}, Vec3::Zero()}};
  RigidBody body(bar);
  double depth = -1.0;
  run_watched(scene, 0.8, [&](const Simulation& sim) {
    body.move_to(sim.state().t);
    for (int k = 0; k <= 400; ++k) {
      const double s = k / 400.0;
      const Vec3 x = (1.0 - s) * position(sim, 0, 0) + s * position(sim, 0, 1);
      depth = std::max(depth, kR - body.distance(x).phi);
    }
  });
  EXPECT_LT(depth, kDeepest);
}

/// A segment of 10 mm that hangs from a pin, a bar of yarn that comes down on it 0.8 mm from there, and a yarn 2 mm
/// below its far end.
TEST(NoPassage, ALeverCarriesNoYarnThroughYarn) {
  for (const double speed : {0.1, 0.4}) {
    Scene scene;
    BareYarn lever;
    lever.points = {{0, 0, 0}, {0.01, 0, 0}, {0.012, 0, 0}};
    scene.yarns = {lever, straight_yarn({8e-4, -0.01, 1.5e-3}, {8e-4, 0.01, 1.5e-3}, 20),
                   straight_yarn({9e-3, -0.01, -2e-3}, {9e-3, 0.01, -2e-3}, 20)};
    list_yarn_effects(scene);
    scene.effects.self_collision.emplace();
    scene.handles = {pin(0, 0), pin(2, 0), pin(2, -1)};
    for (int point = 0; point <= 20; ++point) {
      scene.handles.push_back(pin(1, point));
      scene.handles.back().motion = {{9e-4 / speed, {0, 0, -9e-4}, Vec3::Zero()}};
    }
    double least = 1.0;
    run_watched(scene, 9e-4 / speed, [&](const Simulation& sim) {
      const Vec3 x0 = position(sim, 0, 0), x1 = position(sim, 0, 1), y = position(sim, 2, 10);
      const double s = (y.x() - x0.x()) / (x1.x() - x0.x());
      least = std::min(least, x0.z() + s * (x1.z() - x0.z()) - y.z());
    });
    EXPECT_GT(least, 1.5 * kR) << speed;
  }
}

TEST(NoPassage, AWireCarriesYarnAlong) {
  for (const double radius : {4e-5, 1e-4})
    for (const double speed : {0.1, 2.0}) {
      Scene scene;
      scene.yarns = {straight_yarn({-0.012, 0, 0}, {0.012, 0, 0}, 10)};
      list_yarn_effects(scene);
      scene.handles = {pin(0, 0), pin(0, -1)};
      Collider wire;
      wire.shape = Capsule{{6e-4, -0.02, 3e-3}, {6e-4, 0.02, 3e-3}, radius};
      wire.motion = {{0.01 / speed, {0, 0, -0.01}, Vec3::Zero()}};
      scene.effects.colliders.emplace().colliders = {wire};
      double lowest = 1.0;
      run_watched(scene, 0.01 / speed, [&](const Simulation& sim) { lowest = position(sim, 0, 5).z(); });
      EXPECT_LT(lowest, -6e-3) << radius << " m, " << speed << " m/s";
    }
}

// Points that the yarn gets as it grows begin beyond the wire, as the wire lies deep between those that bear it.
TEST(NoPassage, AWirePressesYarnAsideThatThenGrows) {
  struct Case {
    double radius, pull, below;  // [m], [N], [m]
  };
  for (const Case& c : {Case{1e-4, 0.434, 1.312e-3}, Case{1.5e-4, 1.5, 1.4e-3}}) {
    Scene scene = pressed_let_down(c.pull);
    scene.effects.damping->sliding_ns_per_m = 0.02;
    scene.handles[0].motion = {{0.1, Vec3::Zero(), Vec3::Zero()}, {0.4, {0.06, 0, 0}, Vec3::Zero()}};
    Collider wire;
    const double x = c.radius + kR;
    wire.shape = Capsule{{x, -c.below, -0.02}, {x, -c.below, 0.02}, c.radius};
    wire.friction = 0.0;
    wire.motion = {{0.1, {-9.9e-4, 0, 0}, Vec3::Zero()}};
    scene.effects.colliders.emplace().colliders = {wire};
    double least = 1.0;
    run_watched(scene, 0.45, [&](const Simulation& sim) {
      const Vec3 end = position(sim, 0, -1);
      if (sim.state().t > 0.1 && end.y() < -c.below) least = std::min(least, x - 9.9e-4 + c.below * end.x() / end.y());
    });
    EXPECT_GT(least, 0.0) << c.radius;
    EXPECT_LT(least, x);  // it was pressed
  }
}

/// The third yarn is held at every point: there is no way on, and the run has to say so.
TEST(NoPassage, NoFirstStepTakesALeverThroughHeldYarn) {
  Scene scene;
  BareYarn lever;
  lever.points = {{0, 0, 0}, {0.02, 0, 0}, {0.022, 0, 0}};
  scene.yarns = {lever, straight_yarn({8e-4, -0.01, 1.3e-3}, {8e-4, 0.01, 1.3e-3}, 10),
                 straight_yarn({0.0156, -0.01, -3e-3}, {0.0156, 0.01, -3e-3}, 4)};
  scene.effects.inertia.emplace();
  scene.effects.stretch.emplace();
  scene.effects.self_collision.emplace();
  scene.handles = {pin(0, 0)};
  for (int point = 0; point <= 4; ++point) scene.handles.push_back(pin(2, point));
  for (int point = 0; point <= 10; ++point) {
    scene.handles.push_back(pin(1, point));
    scene.handles.back().motion = {{0.02, {0, 0, -2e-3}, Vec3::Zero()}};
  }
  scene.duration_s = 0.02;
  double least = 1.0;
  RunHooks hooks;
  hooks.on_step = [&](Simulation& sim, const StepReport& report) {
    const Vec3 x0 = position(sim, 0, 0), x1 = position(sim, 0, 1);
    if (report.accepted) least = std::min(least, x0.z() + 0.0156 / x1.x() * (x1.z() - x0.z()) + 3e-3);
  };
  const RunSummary summary = run(scene, 1, hooks);
  EXPECT_EQ(summary.status, RunStatus::failed);
  EXPECT_NE(summary.message.find("scripts"), std::string::npos) << summary.message;
  EXPECT_GT(least, 1.5 * kR);
}

}  // namespace
}  // namespace slipstitch::testing
