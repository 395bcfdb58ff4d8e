// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "model/scene.h"

namespace slipstitch {

/// One way to run a scene: the numerics that stand in for its own. Whatever else is to be varied, as the linear solver
/// or the refinement of the yarn, joins here.
struct Rung {
  std::string method;  // of a curve of rungs: an integrator as scene files spell it, STATIC or ACCURACY
  std::string label;   // which one of the curve: "4.17 ms"
  double size = 0.0;   // what goes down along a curve: the step [s], or the tolerance of positions [m]
  std::variant<FixedNumerics, AccuracyNumerics> numerics;
};

/// The method everyone uses, to which all others are compared. Static scenes have none.
inline constexpr std::string_view kBaselineMethod = "LINEARISED_EULER";
inline constexpr std::string_view kStaticMethod = "STATIC";
inline constexpr std::string_view kAccuracyMethod = "ACCURACY";

/// All rungs of a checked scene, coarse to fine: every integrator at steps that halve from the largest of 1/60 s and
/// the scene's own, but at most from frame to frame, down to 0.25 ms; every tolerance of `accuracy`. Static scenes:
/// steps and force tolerances. Quick: the coarser ones.
std::vector<Rung> all_rungs(const Scene& scene, bool quick);

/// Those of all_rungs() that check() accepts.
std::vector<Rung> ladder(const Scene& scene, bool quick);

std::string rung_name(const Rung& rung);  // "BDF2 4.17 ms"

Scene with_rung(const Scene& scene, const Rung& rung);

/// The scene's own where it has fixed numerics, else the default ones.
FixedNumerics fixed_numerics(const Scene& scene);

/// The rung that goes on from `rung`, whose numerics are fixed: `factor` times its step and its Newton tolerance.
Rung refined(const Rung& rung, double step_factor, double tolerance_factor);

/// All that makes a rung's results, digit by digit.
std::string exact_text(const Rung& rung);

}  // namespace slipstitch
