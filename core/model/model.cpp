// SPDX-License-Identifier: MIT
#include "model/model.h"

#include "model/bare_yarns.h"
#include "model/bodies.h"
#include "model/knit_topology.h"
#include "model/select.h"

namespace slipstitch {
namespace {

PlacedTopology build(const Scene& scene, const RestCell* rest) {
  PlacedTopology placed = build_bare_yarns(scene);
  if (scene.knit) {
    const Knit& knit = *scene.knit;
    append(build_knit(knit, rest ? *rest : drawn_cell(knit.pattern, knit.gauge, scene.yarn, knit.refine)), placed);
  }
  return placed;
}

void add_handles(const Scene& scene, Model& model) {
  std::vector<bool> taken(static_cast<std::size_t>(model.topology.num_nodes), false);
  const auto add = [&](const std::vector<int>& nodes, const Handle& handle, int index) {
    ScriptedNodes script{{}, handle.motion, handle.fix_arc_length, handle.velocity_m_per_s.value_or(Vec3::Zero()),
                         index};
    for (const int node : nodes) {
      if (taken[static_cast<std::size_t>(node)]) continue;
      taken[static_cast<std::size_t>(node)] = true;
      script.nodes.push_back(node);
    }
    if (!script.nodes.empty()) model.handles.push_back(std::move(script));
  };
  for (std::size_t i = 0; i < scene.handles.size(); ++i) {
    add(select_nodes(scene.handles[i].where, model.topology), scene.handles[i], static_cast<int>(i));
  }
  std::vector<int> guides;
  for (const Guide& guide : scene.guides) guides.push_back(node_of_point(model.topology, guide.yarn, guide.point));
  add(guides, Handle{}, -1);
}

void add_loads(const Scene& scene, Model& model) {
  for (const Load& load : scene.loads) {
    const std::vector<int> nodes = select_nodes(load.where, model.topology);
    for (const int node : nodes) {
      model.load_nodes.push_back(node);
      model.load_forces.push_back(load.force_n / static_cast<double>(nodes.size()));
    }
  }
}

// Bare yarns first (a shared node goes with the first of its yarns), then the scene's list, the last word winning.
void set_velocities(const Scene& scene, Model& model) {
  const Topology& topology = model.topology;
  model.start_v = VecX::Zero(topology.num_coords());
  for (int y = static_cast<int>(scene.yarns.size()) - 1; y >= 0; --y) {
    const BareYarn& yarn = scene.yarns[static_cast<std::size_t>(y)];
    for (int i = 0; i < static_cast<int>(yarn.points.size()); ++i) {
      model.start_v.segment<3>(topology.x_coord(node_of_point(topology, y, i))) = yarn.velocity_m_per_s;
    }
  }
  for (const InitialVelocity& initial : scene.initial_velocities) {
    for (const int node : select_nodes(initial.where, topology)) {
      model.start_v.segment<3>(topology.x_coord(node)) = initial.velocity_m_per_s;
    }
  }
}

}  // namespace

Model compile(const Scene& scene, const RestCell* rest) {
  PlacedTopology placed = build(scene, rest);
  Model model;
  model.topology = std::move(placed.topology);
  model.start_q = std::move(placed.q);
  model.yarn = scene.yarn;
  model.effects = scene.effects;
  add_handles(scene, model);
  add_loads(scene, model);
  set_velocities(scene, model);
  append_bodies(model);
  return model;
}

double rest_length(const Topology& topology, int segment) {
  const auto i = static_cast<std::size_t>(segment);
  return topology.rest_arc[i + 1] - topology.rest_arc[i];
}

double linear_density(const Model& model, int yarn) {
  return model.yarn.linear_density_kg_per_m * model.topology.density_scale[static_cast<std::size_t>(yarn)];
}

}  // namespace slipstitch
