// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/model.h"
#include "sim/body_motion.h"
#include "sim/budget_report.h"
#include "sim/clock.h"
#include "sim/effect_choice.h"
#include "sim/effect_cost.h"
#include "sim/frame.h"
#include "sim/frame_report.h"
#include "sim/handle_forces.h"
#include "solve/linear_solver.h"

namespace slipstitch {

class Simulation;
struct StepReport;

enum class RunStatus { succeeded, failed, cancelled };

struct Progress {
  double t = 0.0, duration_s = 0.0;  // simulated [s]
  int frames = 0, num_frames = 0;    // written, planned
  long steps = 0, newton_iterations = 0;
  double step_s = 0.0;    // current step
  double residual = 0.0;  // of the last accepted step; m/s, or N when quasi-static
  std::optional<double> error_estimate_m;
  double wall_s = 0.0;
  std::map<std::string, double> wall_by_phase_s = {};
  std::optional<double> budget_s = {};  // of wall_s; of a scene with one
  std::string doing = {};               // for people, before the simulation itself; empty: that
  double before_s = 0.0;                // of wall_s, before the simulation itself
};

struct RunHooks {
  std::function<void(const FrameHeader&)> on_header;        // once, before the first frame
  std::function<void(const Frame&)> on_frame;               // may be empty
  std::function<void(const FrameReport&)> on_frame_report;  // with every frame; costs an evaluation of the energies;
                                                            // may be empty
  std::function<void(double t, const std::vector<Vec3>&)> on_reactions;  // after every step of a scene with handles,
                                                                         // the force on each [N]; may be empty
  std::function<void(double t, const std::vector<Vec3>&)> on_bodies;  // at the start and after every step of a scene
                                                                      // with dynamic colliders, their centres [m]; may
                                                                      // be empty
  std::function<void(Model&)> on_model;  // before the simulation is made of it, to change it; may be empty
  std::function<std::unique_ptr<LinearSolver>()> make_solver;   // empty: the default one
  std::function<void(Simulation&)> on_start;                    // before the first step; may be empty
  std::function<void(Simulation&, const StepReport&)> on_step;  // after every attempted step; may be empty
  std::function<void(const Progress&)> on_progress;  // after every step, and as run_scene() says; may be empty
  std::function<bool()> should_stop;                 // polled every step and every Newton iteration; may be empty
  Clock clock;                                       // that wall times are read from; empty: the real one
  std::optional<double> began_s;                     // by it, where the run began before run() was called
};

/// One run, measured. Absent optionals were not measured.
struct RunSummary {
  RunStatus status = RunStatus::failed;
  std::string message;  // why it failed, naming stitch, effect and time where known
  std::string scene;
  int loops = 0, nodes = 0, dofs = 0;  // 0 nodes: it ended before the fabric was made
  long nonzeros = 0;                   // of the Hessian's lower triangle, largest of start and end
  std::vector<std::string> effects;
  std::optional<EffectChoice> effect_choice;  // of a scene that left it to us
  EffectCosts effect_cost;                    // by force term; a term whose effect is off is absent
  double sim_time_s = 0.0, wall_s = 0.0;      // wall time since RunHooks::began_s
  int frames = 0;
  long steps = 0, rejected_steps = 0, newton_iterations = 0, linear_iterations = 0, factorizations = 0;
  long cg_iterations = 0;    // of conjugate gradients, each with one of the linear_iterations
  long convex_hessians = 0;  // times the Hessian was indefinite and its convex part stood in for it
  std::map<std::string, double> wall_by_phase_s;
  std::map<std::string, double> energy_j;                      // by term at the end; "kinetic" included
  double residual = std::numeric_limits<double>::quiet_NaN();  // largest over the accepted steps; NaN: none
  std::string residual_unit;                                   // "m/s" or "N"
  std::optional<double> error_estimate_m;                      // of node positions, largest of all frames
  std::optional<double> predictable_until_s;      // from where on that was beyond the tolerance; absent: nowhere
  std::optional<BudgetReport> budget;             // of a scene with one
  std::optional<double> min_arc_gap_ratio;        // smallest du / rest du seen
  std::optional<double> max_stretch;              // largest |dx|/(length factor * du) seen
  std::optional<double> max_slid_m, mean_slid_m;  // |arc length - start| over sliding visits at the end
  std::optional<double> faded_wrap_share;         // of all wraps at the end, and of those away from every edge
  std::optional<double> faded_wrap_share_interior;
  std::optional<long> wrap_ridge_entries;  // wraps not all faded that entered the cap around psi = s psi0 +- pi
  std::optional<long> wrap_fade_entries;             // wraps that began to fade (wrap_fade.h) after the start
  std::optional<long> crushed_entries;               // segments that were pressed below kCrushed (stretch.h) after it
  std::optional<int> self_collision_start_overlaps;  // SelfCollision::start_overlaps()
  std::vector<HandleForce> handles;                  // one a handle of the scene
  std::vector<BodyMotion> bodies;                    // dynamic colliders at the end
  std::optional<long> peak_memory_bytes;
  std::string state_hash;  // of the final q
  std::string linear_solver, blas, version;
  int threads = 1;
};

/// Number of frames of a run: frame k is at t = k / frames_per_s, the last one at the duration.
int planned_frames(double duration_s, double frames_per_s);

/// Steps from one frame to the next if none has to be cut; a whole number. `time_step_s` may be short by rounding.
double least_steps_per_frame(double frames_per_s, double time_step_s);
/// Steps of a run in which none is cut.
long least_steps(double duration_s, double frames_per_s, double time_step_s);

/// Runs a checked scene whose effects are chosen (study/choose_effects.h). Never throws for numerical trouble: that is
/// a status with a message.
RunSummary run(const Scene& scene, int threads, const RunHooks& hooks);

}  // namespace slipstitch
