// SPDX-License-Identifier: MIT
#include "sim/relax.h"

#include <map>

#include "sim/step_objective.h"
#include "sim/stored_energy.h"

namespace slipstitch {
namespace {

Effects rest_effects(const Effects& effects) {
  Effects rest;
  rest.stretch = effects.stretch;
  rest.bending = effects.bending;
  rest.bending_jamming = effects.bending_jamming;
  rest.wrapping = effects.wrapping;
  return rest;
}

struct Entry {
  int dof;
  double weight;
};

/// Unknowns: master positions, then a_x, b_x, b_y. Arc lengths are held.
class PeriodicUnknowns {
 public:
  explicit PeriodicUnknowns(const PeriodicPatch& patch)
      : patch_(patch), periods_(3 * patch.num_masters) {}

  DofMap map() const {
    const Topology& topo = patch_.placed.topology;
    DofMap map;
    map.simple = false;
    map.num_dofs = periods_ + 3;
    map.offset = patch_.placed.q;
    map.offset.head(3 * topo.num_nodes).setZero();
    map.first.push_back(0);
    for (int n = 0; n < topo.num_nodes; ++n)
      for (int c = 0; c < 3; ++c) add_row(map, position_row(n, c));
    map.first.resize(static_cast<std::size_t>(topo.num_coords()) + 1, static_cast<int>(map.dof.size()));
    return map;
  }

  VecX start() const {
    VecX y(periods_ + 3);
    y << patch_.placed.q.head(periods_), patch_.period_course.x(), patch_.period_wale.x(), patch_.period_wale.y();
    return y;
  }

  Vec3 period_course(const VecX& y) const { return {y[periods_], 0.0, 0.0}; }
  Vec3 period_wale(const VecX& y) const { return {y[periods_ + 1], y[periods_ + 2], 0.0}; }

 private:
  std::vector<Entry> position_row(int node, int c) const {
    const auto n = static_cast<std::size_t>(node);
    std::vector<Entry> row{{3 * patch_.node_master[n] + c, 1.0}};
    const auto [i, j] = patch_.node_shift[n];
    if (c == 0 && i != 0) row.push_back({periods_, static_cast<double>(i)});
    if (c < 2 && j != 0) row.push_back({periods_ + 1 + c, static_cast<double>(j)});
    return row;
  }

  static void add_row(DofMap& map, const std::vector<Entry>& row) {
    for (const Entry& e : row) {
      map.dof.push_back(e.dof);
      map.weight.push_back(e.weight);
    }
    map.first.push_back(static_cast<int>(map.dof.size()));
  }

  const PeriodicPatch& patch_;
  int periods_;
};

}  // namespace

RelaxedRepeat relax_repeat(const Knit& knit, const YarnMaterial& yarn, const Effects& effects,
                           double relative_tolerance, const std::function<bool()>& should_stop) {
  const PeriodicPatch patch = build_repeat(knit.pattern, drawn_cell(knit.pattern, knit.gauge, yarn, knit.refine));
  Model model;
  model.topology = patch.placed.topology;
  model.yarn = yarn;
  model.effects = rest_effects(effects);
  model.start_q = patch.placed.q;
  YarnForces forces = make_forces(model);
  const PeriodicUnknowns unknowns(patch);
  const DofMap map = unknowns.map();
  Assembly assembly(forces, map);
  std::map<std::string, double> wall;
  StepObjective objective(forces, map, assembly, model.topology, wall);

  const StitchContact& contact = model.topology.contacts.front();
  const double L = rest_length(model.topology, std::min(contact.u_visit[0], contact.u_visit[1]));
  NewtonOptions options;
  options.gradient_tolerance = relative_tolerance * yarn.bending_nm2 / (L * L);
  options.max_iterations = 2000;
  options.relative_shift = 1e-9;
  options.should_stop = should_stop;
  const auto solver = make_cholmod_solver();
  VecX y = unknowns.start();
  RelaxedRepeat result;
  result.newton = newton(objective, *solver, options, y);
  result.residual_n = result.newton.max_gradient;
  VecX q;
  expand(map, y, q);
  State state;
  state.q = q;
  result.energies_j = stored_energies(forces, state, term_energies(forces, q));
  result.cell = cell_from_patch(patch, q, unknowns.period_course(y), unknowns.period_wale(y));
  return result;
}

}  // namespace slipstitch
