// SPDX-License-Identifier: MIT
#include "force/contact_force.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "force/bending.h"
#include "force/plasticity.h"
#include "force/segments.h"
#include "force/shrinkage.h"
#include "force/stretch.h"
#include "force/wrapping.h"

namespace slipstitch {
namespace {

using VisitForces = std::vector<Vec3>;  // of the visiting yarn alone on its node [N] (num_visits)

template <std::size_t N>
Vec<static_cast<int>(N)> gather(const std::array<int, N>& coords, const VecX& q) {
  Vec<static_cast<int>(N)> local;
  for (std::size_t i = 0; i < N; ++i) local[static_cast<int>(i)] = q[coords[i]];
  return local;
}

Vec3 position(const VecX& q, int node) { return q.segment<3>(3 * node); }

void add_stretch(const Model& model, const State& state, VisitForces& force) {
  if (!model.effects.stretch) return;
  const double factor = length_factor(model.effects, state.t);
  for_each_owned_segment(model.topology, [&](int, int i) {
    Vec<8> g;
    const Vec<8> segment = scaled_arcs(gather(segment_coords(model.topology, i), state.q), factor);
    stretch_energy(model.yarn.stretch_n, segment, &g, nullptr);
    force[static_cast<std::size_t>(i)] -= g.segment<3>(0);
    force[static_cast<std::size_t>(i) + 1] -= g.segment<3>(4);
  });
}

void add_bending(const Model& model, const State& state, VisitForces& force) {
  if (!model.effects.bending) return;
  const double k_b = model.yarn.bending_nm2;
  const bool plastic = state.set_angle.size() > 0;
  for_each_owned_bend(model.topology, [&](int, int i) {
    Vec<11> g;
    const Vec<11> bend = gather(bend_coords(model.topology, i), state.q);
    if (plastic) set_bending_energy(k_b, state.set_angle[i], bend, &g, nullptr);
    else bending_energy(k_b, bend, &g, nullptr);
    force[static_cast<std::size_t>(i) - 1] -= g.segment<3>(0);
    force[static_cast<std::size_t>(i)] -= g.segment<3>(4);
    force[static_cast<std::size_t>(i) + 1] -= g.segment<3>(7);
  });
}

/// The wrap's force on x4 is yarn u's, its reaction on the axis splits by levers; the same for x3 and yarn v.
void add_wrapping(const Model& model, const VecX& q, VisitForces& force) {
  const Wrapping wraps(model);
  for (int k = 0; k < wraps.size(); ++k) {
    const StitchContact& contact = model.topology.contacts[static_cast<std::size_t>(wraps.contact(k))];
    const Vec<12> x = gather(wraps.coords(k), q);
    Vec<12> g;
    wraps.eval(k, x, &g, nullptr);
    const Vec3 axis = x.segment<3>(3) - x.segment<3>(0);
    const bool first = wraps.coords(k)[0] == 3 * contact.q0;
    const std::size_t at0 = first ? 0 : 1, at1 = 1 - at0;  // which of the contact's ends x0 and x1 are
    const auto share = [&](int outer, const std::array<int, 2>& visit) {
      const Vec3 pull = -g.segment<3>(3 * outer);
      const double lever = axis.dot(x.segment<3>(3 * outer) - x.segment<3>(0)) / axis.squaredNorm();
      force[static_cast<std::size_t>(visit[at0])] -= (1.0 - lever) * pull;
      force[static_cast<std::size_t>(visit[at1])] -= lever * pull;
    };
    share(3, contact.u_visit);
    share(2, contact.v_visit);
  }
}

Vec3 direction(const VecX& q, int from, int to) {
  const Vec3 d = position(q, to) - position(q, from);
  const double length = d.norm();
  return length > 0.0 ? Vec3(d / length) : Vec3::Zero();
}

Vec3 contact_normal(const StitchContact& c, const VecX& q) {
  const auto tangent = [&](int from, int to) { return to < 0 ? Vec3(Vec3::Zero()) : direction(q, from, to); };
  const Vec3 axis = direction(q, c.q0, c.q1);
  const Vec3 side = tangent(c.q0, c.q4) + tangent(c.q1, c.q5) - tangent(c.q0, c.q2) - tangent(c.q1, c.q3);
  const Vec3 normal = side - axis * axis.dot(side);
  const double length = normal.norm();
  return length > 1e-9 ? Vec3(normal / length) : Vec3::Zero();
}

/// Unit direction in which the yarn passes visit i; its neighbours' directions in `before` and `after`.
struct Passage {
  Vec3 before = Vec3::Zero(), after = Vec3::Zero();  // towards the neighbouring visits
};

Passage passage(const Topology& topo, const VecX& q, int i) {
  const auto v = static_cast<std::size_t>(i);
  Passage p;
  if (i > 0 && topo.segment_kind[v - 1] != SegmentKind::none)
    p.before = direction(q, topo.visit_node[v], topo.visit_node[v - 1]);
  if (topo.segment_kind[v] != SegmentKind::none) p.after = direction(q, topo.visit_node[v], topo.visit_node[v + 1]);
  return p;
}

double guide_force(const Topology& topo, const VecX& q, int visit, const VisitForces& force) {
  const Passage p = passage(topo, q, visit);
  const Vec3 bisector = p.before + p.after;
  const double length = bisector.norm();
  return length > 1e-9 ? std::max(0.0, bisector.dot(force[static_cast<std::size_t>(visit)]) / length) : 0.0;
}

double crossing_force(const Topology& topo, const VecX& q, int u, int v, const VisitForces& force) {
  const Passage pu = passage(topo, q, u), pv = passage(topo, q, v);
  const Vec3 normal = (pu.after - pu.before).cross(pv.after - pv.before);
  const double length = normal.norm();
  if (!(length > 1e-9)) return 0.0;
  return std::abs(0.5 * normal.dot(force[static_cast<std::size_t>(u)] - force[static_cast<std::size_t>(v)]) / length);
}

}  // namespace

std::vector<double> estimate_normal_forces(const Model& model, const State& state) {
  const VecX& q = state.q;
  const Topology& topo = model.topology;
  VisitForces force(static_cast<std::size_t>(topo.num_visits()), Vec3::Zero());
  add_stretch(model, state, force);
  add_bending(model, state, force);
  add_wrapping(model, q, force);
  std::vector<double> normal(static_cast<std::size_t>(topo.num_visits()), 0.0);
  std::vector<char> done(normal.size(), 0);
  for (const StitchContact& c : topo.contacts) {
    const Vec3 n = contact_normal(c, q);
    for (std::size_t end = 0; end < 2; ++end) {
      const auto u = static_cast<std::size_t>(c.u_visit[end]), v = static_cast<std::size_t>(c.v_visit[end]);
      normal[u] = normal[v] = std::max(0.0, 0.5 * n.dot(force[u] - force[v]));
      done[u] = done[v] = 1;
    }
  }
  std::vector<int> first_at(static_cast<std::size_t>(topo.num_nodes), -1);
  for (int i = 0; i < topo.num_visits(); ++i) {
    const auto v = static_cast<std::size_t>(i);
    if (done[v] || !topo.visit_slides[v]) continue;
    int& other = first_at[static_cast<std::size_t>(topo.visit_node[v])];
    if (other < 0) {
      other = i;
      normal[v] = guide_force(topo, q, i, force);
    } else {
      normal[v] = normal[static_cast<std::size_t>(other)] = crossing_force(topo, q, other, i, force);
    }
  }
  return normal;
}

}  // namespace slipstitch
