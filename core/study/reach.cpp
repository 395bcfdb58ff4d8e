// SPDX-License-Identifier: MIT
#include "study/reach.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>

#include "collide/rigid_body.h"
#include "study/frame_trace.h"

namespace slipstitch {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

/// Nodes joined by yarn, and the rest lengths of the yarn between them.
struct YarnGraph {
  struct Edge {
    int node;
    double length;
  };
  std::vector<std::vector<Edge>> edges;  // (num_nodes)
  std::vector<int> part;                 // (num_nodes), by number of part
  int num_parts = 0;
};

bool has_segment(const Topology& topology, int visit) {
  return topology.segment_kind[static_cast<std::size_t>(visit)] != SegmentKind::none;
}

YarnGraph graph_of(const Topology& topology) {
  YarnGraph graph;
  graph.edges.resize(static_cast<std::size_t>(topology.num_nodes));
  for (int i = 0; i < topology.num_visits(); ++i) {
    if (!has_segment(topology, i)) continue;
    const int a = topology.visit_node[static_cast<std::size_t>(i)],
              b = topology.visit_node[static_cast<std::size_t>(i) + 1];
    graph.edges[static_cast<std::size_t>(a)].push_back({b, rest_length(topology, i)});
    graph.edges[static_cast<std::size_t>(b)].push_back({a, rest_length(topology, i)});
  }
  graph.part.assign(graph.edges.size(), -1);
  for (int start = 0; start < topology.num_nodes; ++start) {
    const auto s = static_cast<std::size_t>(start);
    if (graph.part[s] >= 0 || graph.edges[s].empty()) continue;
    std::vector<int> open{start};
    graph.part[s] = graph.num_parts;
    while (!open.empty()) {
      const int node = open.back();
      open.pop_back();
      for (const YarnGraph::Edge& edge : graph.edges[static_cast<std::size_t>(node)]) {
        int& part = graph.part[static_cast<std::size_t>(edge.node)];
        if (part < 0) {
          part = graph.num_parts;
          open.push_back(edge.node);
        }
      }
    }
    ++graph.num_parts;
  }
  return graph;
}

/// Longest of the shortest paths of yarn from the sources to the nodes that they reach [m].
double farthest(const YarnGraph& graph, const std::vector<int>& sources) {
  std::vector<double> distance(graph.edges.size(), kFar);
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (const int source : sources) queue.emplace(distance[static_cast<std::size_t>(source)] = 0.0, source);
  double far = 0.0;
  while (!queue.empty()) {
    const auto [d, node] = queue.top();
    queue.pop();
    if (d > distance[static_cast<std::size_t>(node)]) continue;
    far = std::max(far, d);
    for (const YarnGraph::Edge& edge : graph.edges[static_cast<std::size_t>(node)]) {
      double& other = distance[static_cast<std::size_t>(edge.node)];
      if (d + edge.length < other) queue.emplace(other = d + edge.length, edge.node);
    }
  }
  return far;
}

struct PartFacts {
  std::vector<int> nodes, held;
  double length = 0.0, mass = 0.0;                      // of its yarn [m], [kg]
  double load = 0.0;                                    // sum of magnitudes [N]
  Vec3 centre = Vec3::Zero(), momentum = Vec3::Zero();  // mass centre [m]; [kg m/s]
};

std::vector<PartFacts> facts_of(const Model& model, const YarnGraph& graph) {
  const Topology& topology = model.topology;
  std::vector<PartFacts> parts(static_cast<std::size_t>(graph.num_parts));
  const auto part_of = [&](int node) { return graph.part[static_cast<std::size_t>(node)]; };
  for (int n = 0; n < topology.num_nodes; ++n)
    if (part_of(n) >= 0) parts[static_cast<std::size_t>(part_of(n))].nodes.push_back(n);
  for (const ScriptedNodes& script : model.handles)
    for (const int node : script.nodes)
      if (part_of(node) >= 0) parts[static_cast<std::size_t>(part_of(node))].held.push_back(node);
  for (int yarn = 0; yarn < topology.num_yarns(); ++yarn) {
    const int first = topology.yarn_first[static_cast<std::size_t>(yarn)];
    const int last = topology.yarn_first[static_cast<std::size_t>(yarn) + 1];
    for (int i = first; i < last; ++i) {
      if (!has_segment(topology, i)) continue;
      const int a = topology.visit_node[static_cast<std::size_t>(i)],
                b = topology.visit_node[static_cast<std::size_t>(i) + 1];
      PartFacts& part = parts[static_cast<std::size_t>(part_of(a))];
      const double length = rest_length(topology, i), mass = linear_density(model, yarn) * length;
      part.length += length;
      part.mass += mass;
      part.centre += 0.5 * mass * (model.start_q.segment<3>(3 * a) + model.start_q.segment<3>(3 * b));
      part.momentum += 0.5 * mass * (model.start_v.segment<3>(3 * a) + model.start_v.segment<3>(3 * b));
    }
  }
  for (std::size_t i = 0; i < model.load_nodes.size(); ++i)
    if (const int p = part_of(model.load_nodes[i]); p >= 0)
      parts[static_cast<std::size_t>(p)].load += model.load_forces[i].norm();
  for (PartFacts& part : parts) part.centre /= part.mass;
  return parts;
}

/// Farthest end of a path of rest length s, of the energy e plus w times the displacement, which is at most start_m
/// more than the path's length.
double strained_length(double s, double stretch_n, double e, double w, double start_m) {
  const double a = 2.0 * s / stretch_n, aw = a * w;
  return s + 0.5 * (aw + std::sqrt(aw * aw + 4.0 * a * (e + w * (start_m + s))));
}

std::string work_not_known(const Model& model) {
  const Effects& on = model.effects;
  if (!on.stretch) return "there is no stretch";
  if (on.shrinkage) return "shrinkage does work";
  if (on.wind) return "wind does work";
  for (const ScriptedNodes& script : model.handles)
    if (!script.motion.empty() || !script.velocity_m_per_s.isZero(0.0)) return "moving handles do work";
  return {};
}

double start_energy(Simulation& sim) {
  double sum = 0.0;
  for (const auto& [term, energy] : sim.energies())
    if (!is_weight_or_load(term)) sum += std::max(0.0, energy);
  return sum;
}

Vec3 gravity_of(const Model& model) {
  return model.effects.gravity ? model.effects.gravity->acceleration_m_per_s2 : Vec3::Zero();
}

/// Longest way along yarn to a held node, or to the mass centre of a free part [m].
double path_of(const Model& model, const YarnGraph& graph, const PartFacts& facts) {
  if (model.effects.sliding) return facts.length;
  return facts.held.empty() ? 2.0 * farthest(graph, {facts.nodes.front()}) : farthest(graph, facts.held);
}

ReachPart held_part(const Model& model, const YarnGraph& graph, const PartFacts& facts, double energy) {
  ReachPart part;
  part.held = true;
  double start_m = 0.0;
  for (const int node : facts.held) part.anchors.push_back(model.start_q.segment<3>(3 * node));
  for (const int node : facts.nodes)
    start_m = std::max(start_m, (model.start_q.segment<3>(3 * node) - part.anchors.front()).norm());
  const double path = path_of(model, graph, facts);
  const double weight = facts.mass * gravity_of(model).norm() + facts.load;
  part.radius = strained_length(path, model.yarn.stretch_n, energy, weight, start_m) + model.yarn.radius_m;
  return part;
}

ReachPart free_part(const Model& model, const YarnGraph& graph, const PartFacts& facts, double energy) {
  ReachPart part;
  part.anchors = {facts.centre};
  if (model.effects.air_drag) {  // it only takes energy, but the centre of mass need not fall straight
    part.speed = std::sqrt(2.0 * energy / facts.mass);
    part.gain = gravity_of(model).norm();
  } else {
    part.velocity = facts.momentum / facts.mass;
    part.acceleration = gravity_of(model);
  }
  const double path = path_of(model, graph, facts);
  part.radius = strained_length(path, model.yarn.stretch_n, energy, 0.0, 0.0) + model.yarn.radius_m;
  return part;
}

/// Where it does not simply fall.
std::string why_free_parts_go_anywhere(const Effects& on, const PartFacts& facts) {
  if (!facts.held.empty()) return {};
  if (!on.inertia) return "without inertia nothing carries a free part";
  if (on.wind) return "wind moves a free part";
  return facts.load > 0.0 ? "loads move a free part" : "";
}

/// The farthest that a handle takes any of its nodes from where it starts, going or turning [m].
double farthest_way(const Model& model, const ScriptedNodes& script, double duration_s) {
  double way = script.velocity_m_per_s.norm() * duration_s, lever = 0.0, turn = 0.0;
  for (const int node : script.nodes)
    lever = std::max(lever,
                     (model.start_q.segment<3>(3 * node) - model.start_q.segment<3>(3 * script.nodes.front())).norm());
  for (const Keyframe& key : script.motion) {
    way = std::max(way, key.translation_m.norm());
    turn = std::max(turn, key.rotation_rad.norm());
  }
  return way + std::min(turn, 2.0) * 2.0 * lever;
}

}  // namespace

Reach bound_reach(Simulation& sim, const RunSpan& span) {
  const Model& model = sim.model();
  Reach reach;
  reach.gravity = gravity_of(model);
  reach.no_bound = span.may_add_energy ? "the integrator may add energy" : work_not_known(model);
  if (!reach.no_bound.empty()) return reach;
  const YarnGraph graph = graph_of(model.topology);
  const double energy = start_energy(sim);
  // What one part gives another has no bound here: it falls from somewhere, and bounces off.
  if (model.effects.self_collision && graph.num_parts > 1) reach.no_bound = "parts of the fabric can push each other";
  if (!reach.no_bound.empty()) return reach;
  for (const PartFacts& facts : facts_of(model, graph)) {
    reach.no_bound = why_free_parts_go_anywhere(model.effects, facts);
    if (!reach.no_bound.empty()) return reach;
    reach.parts.push_back(facts.held.empty() ? free_part(model, graph, facts, energy)
                                             : held_part(model, graph, facts, energy));
  }
  return reach;
}

Reach reach_at_twice_its_length(Simulation& sim, const RunSpan& span) {
  const Model& model = sim.model();
  Reach reach;
  reach.gravity = gravity_of(model);
  if (!model.effects.stretch) reach.no_bound = "there is no stretch";
  if (model.effects.shrinkage) reach.no_bound = "yarn shrinks or grows";
  const YarnGraph graph = graph_of(model.topology);
  const double energy = start_energy(sim);
  double way = 0.0;
  for (const ScriptedNodes& script : model.handles) way = std::max(way, farthest_way(model, script, span.duration_s));
  for (const PartFacts& facts : facts_of(model, graph)) {
    if (reach.no_bound.empty()) reach.no_bound = why_free_parts_go_anywhere(model.effects, facts);
    if (facts.held.empty() && model.effects.self_collision && graph.num_parts > 1)
      reach.no_bound = "another part can push a free one";
    if (!reach.no_bound.empty()) return reach;
    ReachPart part = facts.held.empty() ? free_part(model, graph, facts, energy) : ReachPart{};
    part.held = !facts.held.empty();
    for (const int node : facts.held) part.anchors.push_back(model.start_q.segment<3>(3 * node));
    part.radius = 2.0 * path_of(model, graph, facts) + (part.held ? way : 0.0) + model.yarn.radius_m;
    reach.parts.push_back(part);
  }
  return reach;
}

RunSpan span_of(const Scene& scene) {
  const auto* fixed = std::get_if<FixedNumerics>(&scene.numerics);
  const bool euler = fixed != nullptr && fixed->integrator == Integrator::implicit_euler;
  return {scene.duration_s, fixed != nullptr ? fixed->time_step_s : 1.0 / scene.frames_per_s,
          scene.effects.inertia && !euler};
}

namespace {

/// Times that split the run into short intervals in each of which every body moves evenly.
std::vector<double> times_of(const Collider& collider, double duration_s) {
  constexpr int kTimes = 200;
  std::vector<double> times;
  for (int k = 0; k <= kTimes; ++k) times.push_back(duration_s * k / kTimes);
  for (const Keyframe& key : collider.motion)
    if (key.t < duration_s) times.push_back(key.t);
  std::sort(times.begin(), times.end());
  return times;
}

Keyframe place_at(const Collider& collider, const Vec3& gravity, double t) {
  if (!collider.dynamic) return motion_at(collider.motion, t);
  return {t, collider.dynamic->velocity_m_per_s * t + 0.5 * t * t * gravity, Vec3::Zero()};
}

/// Least distance of the body from what a part reaches at time t, less all that it can lose on an even way to time
/// `other`.
double least_on_way(const ReachPart& part, const Vec3& gravity, const Collider& collider, RigidBody& body, double t,
                    double other, double step_s) {
  body.move_to(t);
  const double last = std::max(t, other);
  const Keyframe here = place_at(collider, gravity, t), there = place_at(collider, gravity, other);
  const double moved = (there.translation_m - here.translation_m).norm();
  const double turned = (there.rotation_rad - here.rotation_rad).norm();
  double speed = part.velocity.norm() + part.acceleration.norm() * last;
  if (collider.dynamic) speed += collider.dynamic->velocity_m_per_s.norm() + gravity.norm() * last;
  const double grown = part.radius + part.speed * last + 0.5 * part.gain * last * (last + step_s);
  const Vec3 fallen = collider.dynamic ? here.translation_m : Vec3::Zero();  // which move_to() knows nothing of
  double least = kFar;
  for (const Vec3& anchor : part.anchors) {
    const Vec3 p = anchor + part.velocity * t + 0.5 * t * t * part.acceleration;
    const double lever = (p - centre_of(collider.shape) - here.translation_m).norm() + moved;
    // Implicit Euler falls half a step times the speed too far.
    const double lost = moved + turned * lever + speed * (std::abs(other - t) + 0.5 * step_s);
    least = std::min(least, body.distance(p - fallen).phi - lost);
  }
  return least - grown;
}

}  // namespace

bool stays_out_of_reach(const Reach& reach, const Collider& collider, const RunSpan& span) {
  if (!reach.no_bound.empty()) return false;
  RigidBody body(collider);
  const std::vector<double> times = times_of(collider, span.duration_s);
  for (const ReachPart& part : reach.parts)
    for (std::size_t i = 0; i + 1 < times.size(); ++i) {
      const auto room = [&](double t, double other) {
        return least_on_way(part, reach.gravity, collider, body, t, other, span.step_s);
      };
      if (std::max(room(times[i], times[i + 1]), room(times[i + 1], times[i])) < 0.0) return false;
    }
  return true;
}

std::vector<int> colliders_out_of_reach(const Simulation& sim, const Reach& reach, const RunSpan& span) {
  if (!sim.model().effects.colliders) return {};
  const std::vector<Collider>& colliders = sim.model().effects.colliders->colliders;
  std::vector<int> outside;
  bool is_pushed = false;  // by one that may be reached
  for (std::size_t i = 0; i < colliders.size(); ++i) {
    if (stays_out_of_reach(reach, colliders[i], span)) {
      outside.push_back(static_cast<int>(i));
    } else {
      is_pushed = is_pushed || !colliders[i].motion.empty() || colliders[i].dynamic;
    }
  }
  const bool falls =
      std::any_of(reach.parts.begin(), reach.parts.end(), [](const ReachPart& part) { return !part.held; });
  if (outside.size() < colliders.size() && (falls || is_pushed)) return {};
  return outside;
}

}  // namespace slipstitch
