// SPDX-License-Identifier: MIT
#include <limits>

#include "force/shrinkage.h"
#include "force/wrap_angle.h"
#include "sim/frame.h"

namespace slipstitch {
namespace {

double psi(const VecX& q, int x0, int x1, int x3, int x4) {
  if (x3 < 0 || x4 < 0) return std::numeric_limits<double>::quiet_NaN();
  return wrap_angle(q.segment<3>(3 * x0), q.segment<3>(3 * x1), q.segment<3>(3 * x3), q.segment<3>(3 * x4));
}

}  // namespace

Derived derive(const FrameHeader& header, const Frame& frame, const Frame& reference) {
  const Topology& topo = header.topology;
  const VecX& q = frame.q;
  const double factor = length_factor(header.shrinkage, frame.t);
  const auto visits = static_cast<std::size_t>(topo.num_visits());
  Derived derived;
  derived.tension_n.assign(visits, 0.0);
  derived.slid_m.assign(visits, 0.0);
  for (int i = 0; i < topo.num_visits(); ++i) {
    const auto v = static_cast<std::size_t>(i);
    derived.slid_m[v] = q[topo.arc_coord(i)] - reference.q[topo.arc_coord(i)];
    if (topo.segment_kind[v] == SegmentKind::none) continue;
    const Vec3 d = q.segment<3>(topo.x_coord(topo.visit_node[v + 1])) - q.segment<3>(topo.x_coord(topo.visit_node[v]));
    const double rest = factor * (q[topo.arc_coord(i + 1)] - q[topo.arc_coord(i)]);
    derived.tension_n[v] = header.yarn.stretch_n * (d.norm() - rest) / rest;
  }
  for (const StitchContact& c : topo.contacts) {
    derived.wrap_rad.push_back(psi(q, c.q0, c.q1, c.q3, c.q4));
    derived.wrap_rad.push_back(psi(q, c.q1, c.q0, c.q2, c.q5));
  }
  return derived;
}

}  // namespace slipstitch
