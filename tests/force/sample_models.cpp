// SPDX-License-Identifier: MIT
#include "sample_models.h"

#include <cmath>

#include "force/touch_parts.h"
#include "model/bodies.h"

namespace slipstitch::testing {
namespace {

constexpr double kMm = 1e-3;
constexpr double kRadius = 1.0 * kMm;  // thick enough for yarns that are no neighbours to touch

Topology clasped_topology() {
  Topology t;
  t.num_nodes = 8;
  t.yarn_first = {0, 6, 12};
  t.visit_node = {0, 1, 2, 3, 4, 5, 6, 1, 2, 4, 3, 7};
  t.visit_slides = {0, 1, 1, 1, 1, 0, 0, 1, 1, 1, 1, 0};
  const SegmentKind f = SegmentKind::free, c = SegmentKind::contact, n = SegmentKind::none;
  t.segment_kind = {f, c, f, c, f, n, f, c, f, c, f, n};
  t.yarn_material = {0, 0};
  t.density_scale = {1.25, 1.5};
  StitchContact first{.q0 = 1, .q1 = 2, .q4 = 0, .q5 = 3, .q2 = 6, .q3 = 4, .u_visit = {1, 2}, .v_visit = {7, 8}};
  StitchContact second{.q0 = 3, .q1 = 4, .q4 = 2, .q5 = 5, .q2 = 7, .q3 = 2, .u_visit = {3, 4}, .v_visit = {10, 9}};
  second.sign = -1;
  t.contacts = {first, second};
  return t;
}

VecX drawn_positions() {
  VecX x(24);
  x << -0.7, 1.1, 0.4, 0.0, 0.0, 0.0, 0.9, 0.1, -0.1, 1.6, 0.9, 0.5,    // nodes 0-3
      2.3, 0.2, 0.8, 2.9, 1.3, 1.5, -0.5, -0.4, -1.2, 1.9, -0.3, -0.6;  // nodes 4-7
  return kMm * x;
}

std::vector<double> drawn_arcs(const Topology& topology, const VecX& x, double stretch) {
  std::vector<double> arc(topology.visit_node.size(), 0.0);
  for (std::size_t y = 0; y + 1 < topology.yarn_first.size(); ++y) {
    for (int i = topology.yarn_first[y] + 1; i < topology.yarn_first[y + 1]; ++i) {
      const auto v = static_cast<std::size_t>(i);
      const Vec3 d = x.segment<3>(3 * topology.visit_node[v]) - x.segment<3>(3 * topology.visit_node[v - 1]);
      arc[v] = arc[v - 1] + d.norm() / stretch;
    }
  }
  return arc;
}

// Moves node `n` to the line through `a` and `b` but for a share `off` of its distance from it.
void straighten(VecX& q, int n, int a, int b, double off) {
  const Vec3 xa = q.segment<3>(3 * a), e = (q.segment<3>(3 * b) - xa).normalized();
  const Vec3 d = q.segment<3>(3 * n) - xa;
  const Vec3 along = e * e.dot(d);
  q.segment<3>(3 * n) = xa + along + off * (d - along);
}

}  // namespace

Effects all_effects() {
  Effects e;
  e.inertia.emplace().sliding_mass_fraction = 1e-2;
  e.gravity.emplace().acceleration_m_per_s2 = {1.0, -9.0, 2.0};
  e.stretch.emplace();
  e.bending.emplace();
  e.bending_jamming.emplace();
  e.wrapping.emplace();
  e.contact_length.emplace();
  e.parallel_contact.emplace();
  e.sliding.emplace();
  e.sliding_friction.emplace().normal_force_n = 1e-3;
  e.damping = DampingEffect{.stretch_ns = 1e-2, .bending_nm2s = 1e-10, .wrapping_ns = 1e-5, .sliding_ns_per_m = 1e-3};
  const double radius = kRadius;  // each body a little into the yarn at one of its nodes
  e.colliders.emplace().colliders = {
      {Plane{{0.0, -0.4 * kMm - 0.97 * radius, 0.0}, Vec3::UnitY()}, 0.3, {}},
      {Sphere{Vec3(2.9 * kMm, 1.3 * kMm, 1.5 * kMm) + (kMm + 0.95 * radius) * Vec3(2.0, 1.0, 2.0) / 3.0, kMm}, 0.5, {}},
      {Box{Vec3(-0.7, 1.1, 0.4) * kMm + (kMm + 0.98 * radius) * Vec3::UnitZ(), Vec3::Constant(kMm), Vec3::Zero()},
       0.0,
       {}},
      {Sphere{Vec3(-0.5, -0.4, -1.2) * kMm + (2.0 * kMm + 0.97 * radius) * Vec3(-2.0, 1.0, -2.0) / 3.0, 2.0 * kMm},
       0.4,
       {},
       DynamicBody{1e-4}}};
  e.air_drag = AirDragEffect{.linear_ns_per_m2 = 1e-4, .quadratic_ns2_per_m3 = 2e-3};
  e.wind = WindEffect{.velocity_m_per_s = {1.0, -0.5, 2.0}};
  e.shrinkage.emplace().keyframes = {{0.0, 0.9}};
  e.plasticity.emplace();
  e.self_collision.emplace();
  return e;
}

Model clasped_yarns(const Effects& effects) {
  Model model;
  model.topology = clasped_topology();
  model.effects = effects;
  model.yarn.radius_m = kRadius;
  const VecX x = drawn_positions();
  model.topology.rest_arc = drawn_arcs(model.topology, x, 1.0);
  model.start_q.resize(model.topology.num_coords());
  model.start_q << x, Eigen::Map<const VecX>(model.topology.rest_arc.data(), model.topology.num_visits());
  model.start_v = VecX::Zero(model.topology.num_coords());
  append_bodies(model);
  return model;
}

Model loaded(const Effects& effects) {
  Model model = clasped_yarns(effects);
  model.load_nodes = {5, 7};
  model.load_forces = {Vec3(1e-3, 2e-3, -1e-3), Vec3(0.0, -1e-3, 3e-3)};
  return model;
}

Model everything_on() { return loaded(all_effects()); }

Model everything_off() { return clasped_yarns({}); }

State state_at(const Model& model, const VecX& q, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  State state;
  state.q = q;
  state.v = VecX::NullaryExpr(q.size(), [&] { return 0.05 * normal(random); });
  state.p = VecX::NullaryExpr(q.size(), [&] { return 1e-8 * normal(random); });
  state.anchor = q.tail(model.topology.num_visits());
  if (model.effects.colliders) {  // some stick, some have slipped; on the sphere by far, so that no pose is at the kink
    const auto anchor = [&](const TouchSample& sample) {
      return Vec3(place_of(sample, q) + 0.02 * kMm * Vec3(normal(random), normal(random), normal(random)));
    };
    const auto parts = touch_parts(model);
    for (int i = 0; i < parts->samples.size(); ++i)
      state.touches.push_back({i, i % 3, anchor(parts->samples[i]), 1e-2});
    for (int i = 0; i < parts->all_samples.size(); ++i) {
      const Vec3 centre = q.segment<3>(3 * model.bodies[0].node);
      state.body_touches.push_back(
          {i, 0, anchor(parts->all_samples[i]) - centre, i % 2 == 0 ? 1.0 : 1e-4});
    }
  }
  std::uniform_real_distribution<double> angle(0.0, 1.5);
  if (model.effects.plasticity)
    state.set_angle = VecX::NullaryExpr(model.topology.num_visits(), [&] { return angle(random); });
  return state;
}

std::vector<Pose> sample_poses(const Model& model) {
  std::mt19937_64 random(20240117);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<Pose> poses;
  const auto shaken = [&](double amount) {
    VecX q = model.start_q;
    for (double& c : q) c += amount * kMm * uniform(random);
    return q;
  };
  const Eigen::Index first_arc = 3 * model.topology.num_nodes;
  for (int i = 0; i < 12; ++i) poses.push_back({shaken(0.15)});
  for (double arcs : {0.2, 0.25, 0.3, 0.4, 0.5, 1.7}) {  // crowded: sharp for jamming, close for parallel contact; slack
    VecX q = shaken(0.05);
    q.tail(q.size() - first_arc) *= arcs;
    poses.push_back({q});
  }
  for (double off : {0.3, 0.1, 1e-2, 1e-4, 0.0}) {  // node 0 towards the axis of contact 0, on the far side
    const int order = off > 0.0 ? 2 : 1;            // the fade goes like distance^3
    const double step = off > 0.0 ? 1e-6 * off : 1e-7;
    VecX q = shaken(0.05);
    straighten(q, 0, 1, 2, off);
    poses.push_back({q, step, order});
    straighten(q, 4, 2, 1, off);  // and node 4 at the other end: both triangles of the diagonal
    poses.push_back({q, step, order});
  }
  for (double off : {0.1, 1e-3}) {  // node 3 back onto the segment it comes from: a fold at node 2
    VecX q = shaken(0.02);
    q.segment<3>(9) = q.segment<3>(3) + 0.3 * (q.segment<3>(6) - q.segment<3>(3)) + off * Vec3(0.1, 0.4, 0.3) * kMm;
    poses.push_back({q, 1e-5 * off});
  }
  for (double angle : {1.0, 2.0, 2.9, 3.1, 4.0, 5.0}) {  // node 0 turned about the axis of contact 0
    VecX q = shaken(0.02);
    const Vec3 e = (q.segment<3>(6) - q.segment<3>(3)).normalized();
    q.segment<3>(0) = q.segment<3>(3) + Eigen::AngleAxisd(angle, e) * (q.segment<3>(0) - q.segment<3>(3));
    poses.push_back({q});
  }
  for (double share : {0.99, 0.98, 0.97, 0.96, 0.95, 0.94, 0.93, 0.92, 0.91, 0.9}) {  // squeezed: yarns that are no neighbours touch
    VecX q = shaken(0.05);
    q.head(first_arc) = 0.2 * q.head(first_arc) + (share - 0.2) * model.start_q.head(first_arc);
    poses.push_back({q});
  }
  return poses;
}

}  // namespace slipstitch::testing
