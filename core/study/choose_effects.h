// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "model/scene.h"
#include "sim/effect_choice.h"
#include "sim/run.h"

namespace slipstitch {

/// A scene whose effects are listed: its own, or all candidates where it leaves the choice to the program.
Scene with_candidates(const Scene& scene);

struct ChosenScene {
  Scene scene;  // effects listed, none left to choose
  EffectChoice choice;
  bool cancelled = false;  // before the choice was made; scene has all candidates then
};

/// Settles the effects of a checked scene that has effects.automatic. Candidates are those that it lists, and all
/// others that mean something without parameters, but plasticity. What cannot matter goes. Stretch stays, and what a
/// listed effect needs that may act late. What can switch on late (colliders, self-collision, parallel contact,
/// jamming, plasticity), or by script after the window, goes only where a bound over the whole run shows that it cannot
/// act. Every other one is left out, one after the other, the dearest first, in a run of the window: it goes for good
/// if no node is then farther than the tolerance from where all candidates together put it, at any frame, and if the
/// run becomes no dearer (Newton iterations times matrix entries, a count, so that the choice is the same on every
/// machine).
/// `on_trial`, which may be empty, is told before every run, and after each of its steps, what is tried.
ChosenScene choose_effects(const Scene& scene, int threads, const std::function<bool()>& should_stop,
                           const std::function<void(const std::string& what)>& on_trial = {});

/// run(), after choose_effects() where the scene asks for it; the summary has the choice. Each run of the choice is a
/// progress of its own, in which nothing is simulated yet. Wall times are of both together.
RunSummary run_scene(const Scene& scene, int threads, const RunHooks& hooks);

}  // namespace slipstitch
