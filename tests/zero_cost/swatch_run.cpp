// SPDX-License-Identifier: MIT
// A swatch hung by its corners and swung, with five effects. Built twice: against the simulator with every term in its
// list and against one with those five alone. Prints the number of terms, then what the run gave, bit by bit. Argument:
// duration [s], 0.1 if there is none.
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "force/yarn_forces.h"
#include "sim/run.h"

namespace slipstitch {
namespace {

Scene swung_swatch(double duration_s) {
  Scene scene;
  Issues issues;
  scene.knit.emplace().pattern = pattern_from_preset({"stockinette", 5, 4}, false, "preset", issues);
  scene.knit->gauge = {2.9e-3, 2.03e-3, {}};
  scene.effects.inertia.emplace();
  scene.effects.gravity.emplace();
  scene.effects.stretch.emplace();
  scene.effects.bending.emplace();
  scene.effects.wrapping.emplace().alpha = 0.03;
  scene.handles = {Handle{Corner::top_left, {}, false},
                   Handle{Corner::top_right, {{0.05, {-2e-3, 0.0, 3e-3}, Vec3::Zero()}}, false}};
  scene.duration_s = duration_s;
  return scene;
}

void print_bits(const char* name, double value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  std::printf("%s %016" PRIx64 "\n", name, bits);
}

}  // namespace
}  // namespace slipstitch

int main(int argc, char** argv) {
  using namespace slipstitch;
  const Scene scene = swung_swatch(argc > 1 ? std::atof(argv[1]) : 0.1);
  for (const Issue& issue : check(scene)) std::printf("%s is %s\n", issue.path.c_str(), issue.value.c_str());
  const RunSummary summary = run(scene, 1, {});
  std::printf("%zu terms\n", kNumTerms);
  std::printf("%s\nstate %s\ndofs %d\nsteps %ld, %ld rejected\nNewton %ld, %ld factors, %ld solves, %ld convex\n",
              summary.status == RunStatus::succeeded ? "succeeded" : summary.message.c_str(),
              summary.state_hash.c_str(), summary.dofs, summary.steps, summary.rejected_steps,
              summary.newton_iterations, summary.factorizations, summary.linear_iterations, summary.convex_hessians);
  print_bits("residual", summary.residual);
  for (const auto& [term, energy] : summary.energy_j) print_bits(term.c_str(), energy);
  for (const auto& [term, cost] : summary.effect_cost)
    std::printf("%s %ld %ld %ld %ld %ld %ld\n", term.c_str(), cost.dofs, cost.stencils, cost.bytes, cost.nonzeros,
                cost.evaluations, cost.searches);
  for (const HandleForce& force : summary.handles) print_bits("handle", force.max_reaction_n);
  return summary.status == RunStatus::succeeded ? 0 : 1;
}
