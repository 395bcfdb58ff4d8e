// SPDX-License-Identifier: MIT
#include "sim/effect_cost.h"

#include <algorithm>

#include "sim/simulation.h"

namespace slipstitch {
namespace {

void add_searches(const YarnForces& forces, EffectCosts& costs) {
  const auto add = [&](const auto& term) {
    using Term = std::decay_t<decltype(term)>;
    if constexpr (SearchesStencils<Term>) {
      if (term.searches() == 0) return;
      EffectCost& cost = costs[std::string(Term::kName)];
      cost.searches = term.searches();
      cost.bytes += term.search_bytes();
    }
  };
  std::apply([&](const auto&... term) { (add(term), ...); }, forces);
}

/// Of the unknowns that are arc lengths: their number, and the entries in their rows and columns.
EffectCost cost_of_sliding(const Topology& topology, const DofMap& map, const SparsePattern& pattern) {
  EffectCost cost;
  std::vector<char> arc(static_cast<std::size_t>(map.num_dofs), 0);
  for (int i = 0; i < topology.num_visits(); ++i)
    if (const int dof = map.dof_of(topology.arc_coord(i)); dof >= 0) arc[static_cast<std::size_t>(dof)] = 1;
  cost.dofs = std::count(arc.begin(), arc.end(), 1);
  for (int c = 0; c < pattern.n; ++c)
    for (int k = pattern.column_first[static_cast<std::size_t>(c)];
         k < pattern.column_first[static_cast<std::size_t>(c) + 1]; ++k)
      if (arc[static_cast<std::size_t>(c)] || arc[static_cast<std::size_t>(pattern.row[static_cast<std::size_t>(k)])])
        ++cost.nonzeros;
  return cost;
}

/// An effect that acts in every stencil of a term, with so many numbers of its own in each.
void add_guest(bool on, const char* effect, const char* host, long numbers, EffectCosts& costs) {
  if (!on || !costs.contains(host)) return;
  const EffectCost& hosts = costs.at(host);
  EffectCost cost;
  cost.stencils = hosts.stencils;
  cost.evaluations = hosts.evaluations;
  cost.bytes = hosts.stencils * numbers * static_cast<long>(sizeof(double));
  costs[effect] = cost;
}

}  // namespace

EffectCosts Simulation::effect_costs() const {
  EffectCosts costs = assembly_.costs(forces_);
  for (const auto& [term, cost] : ends_.costs(forces_)) {
    costs[term].bytes += cost.bytes;
    costs[term].evaluations += cost.evaluations;
  }
  add_searches(forces_, costs);
  const Effects& on = model_.effects;
  if (on.sliding) costs["sliding"] = cost_of_sliding(model_.topology, map_, *assembly_.pattern());
  if (model_.topology.num_bodies > 0 && on.inertia) costs["body_inertia"].dofs = 3L * model_.topology.num_bodies;
  add_guest(on.plasticity.has_value(), "plasticity", "bending", 2, costs);  // the set angle, in the state and the term
  add_guest(on.shrinkage.has_value(), "shrinkage", "stretch", 0, costs);
  add_guest(on.wind.has_value(), "wind", "air_drag", 0, costs);
  return costs;
}

}  // namespace slipstitch
