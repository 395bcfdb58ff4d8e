// SPDX-License-Identifier: MIT
#include "sim/frame_report.h"

#include "sim/simulation.h"
#include "sim/stored_energy.h"

namespace slipstitch {

std::map<std::string, std::optional<double>> reported_energies(const Simulation& sim) {
  std::map<std::string, std::optional<double>> reported{{"kinetic", std::nullopt}};
  const auto add = [&](const auto& term) {
    using Term = std::decay_t<decltype(term)>;
    if (kIsPotential<Term> && HasChangingStencils<Term>) reported[std::string(Term::kName)] = std::nullopt;
  };
  std::apply([&](const auto&... term) { (add(term), ...); }, sim.forces());
  const TermEnergies energies = term_energies(sim.forces(), sim.state().q);
  for (const auto& [name, energy] : stored_energies(sim.forces(), sim.state(), energies)) reported[name] = energy;
  return reported;
}

}  // namespace slipstitch
