// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "model/naive.h"
#include "model/scene.h"
#include "model/topology.h"

namespace slipstitch {

struct RestCell;

/// A group of nodes whose positions follow a script.
struct ScriptedNodes {
  std::vector<int> nodes;
  std::vector<Keyframe> motion;  // empty: held, or moved with the velocity
  bool fix_arc_length = false;
  Vec3 velocity_m_per_s = Vec3::Zero();
  int handle = -1;  // into Scene::handles; -1: the guides
};

/// A dynamic sphere. Its centre is a node that no yarn visits.
struct Body {
  int collider = -1, node = -1;  // into CollidersEffect::colliders, into the topology
  double mass_kg = 0.0, radius_m = 0.0, friction = 0.0;
};

/// A scene made concrete: everything that is constant while simulating.
struct Model {
  Topology topology;
  YarnMaterial yarn;
  Effects effects;
  std::vector<ScriptedNodes> handles;
  std::vector<Body> bodies;  // ascending
  std::vector<int> load_nodes;
  std::vector<Vec3> load_forces;  // [N] per entry of load_nodes
  VecX start_q;                   // (num_coords)
  VecX start_v;                   // (num_coords) [m/s]
  Naive naive = {};
};

/// Makes a scene that passed check() concrete. Bare yarns come first in the topology, the knit's yarn last. `rest`: the
/// repeat to tile; null: the drawn one. A node that several handles select follows the first; guides come last.
Model compile(const Scene& scene, const RestCell* rest);

/// Per-segment constants, as the force terms need them.
double rest_length(const Topology& topology, int segment);
double linear_density(const Model& model, int yarn);  // rho / c_L [kg/m]

}  // namespace slipstitch
