// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "model/effects.h"
#include "model/issue.h"
#include "model/material.h"
#include "model/motion.h"
#include "model/pattern.h"

namespace slipstitch {

/// Size of a stitch: exactly one of the two groups. Both give the drawn loop; the rest shape comes from relaxation.
struct Gauge {
  std::optional<double> course_spacing_m;  // wale pitch: width of one stitch along the course (x) > 0
  std::optional<double> wale_spacing_m;    // height of one stitch along the wale (y) > 0
  std::optional<double> yarn_per_stitch_m; // true length of yarn in one stitch > 0
};

/// Where the fabric lies. Right-handed: wale direction x course direction orthonormalised by check(); +z = course x wale.
struct Placement {
  Vec3 origin_m = Vec3::Zero();  // lower left corner of the relaxed fabric
  Vec3 course_direction = Vec3::UnitX();
  Vec3 wale_direction = Vec3::UnitY();
};

struct Knit {
  Pattern pattern;
  Gauge gauge;
  Placement placement;
  bool relax_repeat = true;     // start from the relaxed periodic repeat; false: the drawn loops
  double noise_m = 0.0;         // uniform noise per coordinate on start positions, amplitude >= 0
  std::uint64_t noise_seed = 0;
  int refine = 0;               // nodes more in every free segment of the yarn, 0 to 8
  bool ends_woven_in = false;   // true: no tails, knit_topology.h
};

/// A yarn given as a polyline of plain nodes. Rest arc lengths are the polyline's lengths / prestretch unless given.
struct BareYarn {
  std::vector<Vec3> points;                // >= 2, no two consecutive equal
  double prestretch = 1.0;                 // > 0
  std::vector<double> arc_lengths_m;       // optional, strictly increasing, one per point
  Vec3 velocity_m_per_s = Vec3::Zero();    // initial, of all points
};

/// A fixed point in space that a yarn slides over: position held, arc length free. Not an end of the yarn.
struct Guide {
  int yarn = 0, point = 0;  // into Scene::yarns
};

/// Two bare yarns sharing one sliding contact node (no wrapping); point_b takes point_a's position.
/// Inner points of two different yarns, each in one crossing at most.
struct Crossing {
  int yarn_a = 0, point_a = 0, yarn_b = 0, point_b = 0;
};

enum class Corner { bottom_left, bottom_right, top_left, top_right };
enum class Edge { bottom, top, left, right };
struct StitchRange {  // inclusive, 1-based
  int first_course = 1, last_course = 1, first_wale = 1, last_wale = 1;
};
struct YarnPoint {  // point of Scene::yarns[yarn], or visit of the knit's yarn, which counts as one more yarn behind
                    // them (the only one, yarn 0, where there are none); negative points count from the end
  int yarn = 0, point = 0;
};
struct AllNodes {};  // of the yarn

/// Which nodes. A corner is its corner stitch's nodes, an edge its outermost stitches.
using Selector = std::variant<Corner, Edge, StitchRange, YarnPoint, AllNodes>;

/// Nodes whose positions are prescribed, turned about the group's start centroid. No keyframes and no velocity: a pin.
/// Linear interpolation, held after the last keyframe.
struct Handle {
  Selector where;
  std::vector<Keyframe> motion;
  bool fix_arc_length = false;           // also hold the arc lengths of these nodes
  std::optional<Vec3> velocity_m_per_s = std::nullopt;  // constant, from the start on; not together with motion
};

/// Dead load, divided equally over the selected nodes.
struct Load {
  Selector where;
  Vec3 force_n = Vec3::Zero();
};

/// Initial velocity of selected nodes' positions (material velocity when nothing slides).
struct InitialVelocity {
  Selector where;
  Vec3 velocity_m_per_s = Vec3::Zero();
};

enum class Integrator {
  implicit_euler,    // first order
  bdf2,              // second order, two-step
  sdirk2,            // second order, two solves a step
  implicit_midpoint, // second order, undamped: keeps what stiff yarn oscillates
  linearised_euler,  // implicit Euler by one Newton iteration a step, whatever it leaves
};

struct FixedNumerics {
  double time_step_s = 1.0 / 240;               // largest step > 0; shortened so that frames fall on steps
  double velocity_tolerance_m_per_s = 1e-4;     // Newton stops when max |Newton step| / h is below; dynamic steps
  double force_tolerance_n = 1e-9;              // quasi-static steps stop when max |gradient| is below [N]
  int max_newton_iterations = 200;              // a step that needs more is cut in half
  double smallest_step_s = 1e-7;                // below: the run fails
  Integrator integrator = Integrator::implicit_euler;  // of dynamic scenes; static ones have none
};

/// Numerics chosen by the run itself.
struct AccuracyNumerics {
  static constexpr double kLeastTolerance_m = 1e-9;  // round-off and Newton's tolerances are what is left below
  double tolerance_m = 0.0;  // largest error of a node's position at the times of frames, >= kLeastTolerance_m
};

/// The same, as accurate as fits into a wall time. Not reproducible to the bit: what fits is seen while it runs.
struct BudgetNumerics {
  double budget_s = 0.0;  // of the whole run from its start, the choice of effects and the rest shape included > 0
};

struct Scene {
  std::string name;
  std::optional<Knit> knit;
  std::vector<BareYarn> yarns;
  std::vector<Guide> guides;
  std::vector<Crossing> crossings;
  YarnMaterial yarn;
  Effects effects;
  std::vector<Handle> handles;
  std::vector<Load> loads;
  std::vector<InitialVelocity> initial_velocities;
  double duration_s = 1.0;      // >= 0
  double frames_per_s = 30.0;   // > 0
  std::variant<FixedNumerics, AccuracyNumerics, BudgetNumerics> numerics;
};

struct SceneLimits {
  int max_stitches = 250000;
  int max_yarn_points = 1000000;
  int max_frames = 1000000;
  double max_steps = 1e9;
};

/// Every problem at once: ranges, finiteness, prerequisites of effects, indices, limits. Empty: the scene can run.
Issues check(const Scene& scene, const SceneLimits& limits = {});

}  // namespace slipstitch
