// SPDX-License-Identifier: MIT
#include "gauntlet/invariants.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "force/segments.h"

namespace slipstitch::gauntlet {
namespace {

constexpr double kBroken = std::numeric_limits<double>::infinity();
constexpr double kRoundOff = 1e-12;
constexpr double kLeastArc = 1e-3;  // of a segment's rest length
constexpr double kLeastOfAStep = 0.5;

struct Sum {
  double value = 0.0, size = 0.0;  // size: of what was summed, for its round-off
};

template <class Term>
void add_energy(const Term& term, const VecX& q, Sum& sum) {
  Vec<Term::kSize> local;
  for (int k = 0; k < term.size(); ++k) {
    const auto coords = term.coords(k);
    for (int i = 0; i < Term::kSize; ++i) local[i] = q[coords[static_cast<std::size_t>(i)]];
    const double energy = term.eval(k, local, nullptr, nullptr);
    sum.value += energy;
    sum.size += std::abs(energy);
  }
}

Sum incremental_potential(const Simulation& sim, const VecX& q) {
  Sum sum;
  std::apply([&](const auto&... term) { (add_energy(term, q, sum), ...); }, sim.forces());
  return sum;
}

/// Nothing is no share even of nothing, as in a straight yarn that rests.
double share_of(double is, double allowed) { return is == 0.0 ? 0.0 : is / allowed; }

double finite(const AcceptedStep& step, const Limits&) {
  const State& s = step.after;
  return s.q.allFinite() && s.v.allFinite() && s.p.allFinite() && s.anchor.allFinite() ? 0.0 : kBroken;
}

double arc(const Topology&, const VecX& q, const std::array<int, 8>& c) { return q[c[7]] - q[c[3]]; }

double order(const AcceptedStep& step, const Limits&) {
  const Topology& topology = step.sim.model().topology;
  double worst = 0.0;
  for_each_owned_segment(topology, [&](int, int i) {
    const auto c = segment_coords(topology, i);
    const double now = arc(topology, step.after.q, c);
    const double floor =
        std::min(kLeastArc * rest_length(topology, i), kLeastOfAStep * arc(topology, step.before.q, c));
    worst = std::max(worst, now > 0.0 ? floor / now : kBroken);
  });
  return worst;
}

double stretch(const AcceptedStep& step, const Limits& limits) {
  const Topology& topology = step.sim.model().topology;
  const double factor = term_of<Stretch>(step.sim.forces()).length_factor();
  double most = 1.0;
  for_each_owned_segment(topology, [&](int, int i) {
    const auto c = segment_coords(topology, i);
    const double length = (step.after.q.segment<3>(c[4]) - step.after.q.segment<3>(c[0])).norm();
    most = std::max(most, length / (factor * arc(topology, step.after.q, c)));
  });
  return (most - 1.0) / (limits.max_stretch - 1.0);
}

/// The minimisation that a step is gives V+ + 1/2 |v+ - v|^2_M + dissipation <= V + 1/2 |v|^2_M + work, if it ends
/// below where it starts: at the state before, moved by the scripts alone.
double descent(const AcceptedStep& step, const Limits&) {
  VecX start = step.before.q;
  apply_scripts(step.sim.model(), step.after.t, start);
  const Sum from = incremental_potential(step.sim, start), to = incremental_potential(step.sim, step.after.q);
  if (!std::isfinite(from.value)) return 0.0;  // a script has moved yarn into a body: nothing to end below
  return share_of(to.value - from.value, kRoundOff * std::max(from.size, to.size));
}

double momentum(const AcceptedStep& step, const Limits&) {
  if (step.sim.quasi_static()) return 0.0;
  const Model& model = step.sim.model();
  const int nodes = model.topology.num_nodes;
  VecX outside = VecX::Zero(model.topology.num_coords()), all = outside;
  const auto add = [&](const auto& term, VecX& gradient) { add_full_gradient(term, step.after.q, {}, gradient); };
  const YarnForces& forces = step.sim.forces();
  add(term_of<Gravity>(forces), outside);
  add(term_of<BodyGravity>(forces), outside);
  add(term_of<DeadLoad>(forces), outside);
  add(term_of<AirDrag>(forces), outside);
  add(term_of<ColliderContact>(forces), outside);
  add(term_of<ColliderFriction>(forces), outside);
  std::apply([&](const auto&... term) { (add(term, all), ...); }, forces);
  // Every gradient but that of the outside sums to zero over the nodes, so what is left of all moves the fabric.
  Vec3 sum = Vec3::Zero();
  double size = 0.0;
  for (int n = 0; n < nodes; ++n) {
    const Vec3 change = (step.after.p - step.before.p).segment<3>(3 * n) / step.h();
    sum += change + outside.segment<3>(3 * n) - all.segment<3>(3 * n);
    size += change.norm() + outside.segment<3>(3 * n).norm() + all.segment<3>(3 * n).norm();
  }
  const double inner = incremental_potential(step.sim, step.after.q).size / model.yarn.radius_m;
  return share_of(sum.norm(), 1e-9 * size + 1e-12 * inner);
}

constexpr std::array kInvariants{
    Invariant{"finite", "every number of the state is finite", finite},
    Invariant{"order", "arc length grows along every yarn, by a thousandth of its rest length or half of what it was",
              order},
    Invariant{"stretch", "no segment is stretched more than the case's load can", stretch},
    Invariant{"descent", "V+ + 1/2 |v+ - v|^2_M <= V + 1/2 |v|^2_M + work, to 1e-12 of the energies summed", descent},
    Invariant{"momentum", "momentum changes by what weight, loads, air, bodies and supports give", momentum},
};

}  // namespace

std::span<const Invariant> invariants() { return kInvariants; }

}  // namespace slipstitch::gauntlet
