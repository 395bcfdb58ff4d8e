// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sim/run.h"

namespace slipstitch {

/// A scene with the listed effects of the first stages only.
struct GrowingSet {
  std::string stage;               // what comes in with it: "yarn", "wrapping", ...
  std::vector<std::string> added;  // its effects
  std::string failure;             // why the run did not end well; empty: it did
  double wall_s = 0.0;
  FrameHeader header;
  Frame last;  // the last frame there is
};

/// Effects in the order in which a fabric needs them: what a yarn does, what it lies on, how stitches wrap, how yarn
/// slides, how the fabric touches itself. Every effect is in one.
struct EffectStage {
  std::string name;
  std::vector<std::string> effects;
};
std::vector<EffectStage> effect_stages();

/// Runs a checked scene once a stage that adds anything, with all listed effects up to there. on_stage: before each,
/// how many are done of how many; both hooks may be empty. Stops early, with what it has, when should_stop says so.
std::vector<GrowingSet> run_growing_sets(const Scene& scene, int threads,
                                         const std::function<void(int done, int of)>& on_stage,
                                         const std::function<bool()>& should_stop);

}  // namespace slipstitch
