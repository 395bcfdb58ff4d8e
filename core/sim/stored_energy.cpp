// SPDX-License-Identifier: MIT
#include "sim/stored_energy.h"

#include "force/body_inertia.h"
#include "force/inertia.h"
#include "force/wrapping.h"

namespace slipstitch {
namespace {

template <class Term>
double energy_of(const Term& term, const VecX& q) {
  double energy = 0.0;
  Vec<Term::kSize> local;
  for (int k = 0; k < term.size(); ++k) {
    const auto coords = term.coords(k);
    for (int i = 0; i < Term::kSize; ++i) local[i] = q[coords[static_cast<std::size_t>(i)]];
    energy += term.eval(k, local, nullptr, nullptr);
  }
  return energy;
}

}  // namespace

TermEnergies term_energies(const YarnForces& forces, const VecX& q) {
  return std::apply([&](const auto&... term) { return TermEnergies{energy_of(term, q)...}; }, forces);
}

std::map<std::string, double> stored_energies(const YarnForces& forces, const State& state,
                                              const TermEnergies& energies) {
  std::map<std::string, double> result;
  std::size_t i = 0;
  std::apply(
      [&](const auto&... term) {
        const auto report = [&](const auto& t, double energy) {
          using Term = std::decay_t<decltype(t)>;
          if (!kIsPotential<Term> || t.size() == 0) return;
          if constexpr (std::is_same_v<Term, Wrapping>) energy -= t.least_energy();
          result[std::string(Term::kName)] = energy;
        };
        (report(term, energies[i++]), ...);
      },
      forces);
  if (const auto& inertia = term_of<Inertia>(forces); inertia.size() > 0) {
    result["kinetic"] = inertia.kinetic_energy(state.q, state.v) + term_of<BodyInertia>(forces).kinetic_energy(state.v);
  }
  return result;
}

}  // namespace slipstitch
