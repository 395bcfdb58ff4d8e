// SPDX-License-Identifier: MIT
#include "sim/body_motion.h"

#include "sim/simulation.h"

namespace slipstitch {

std::vector<BodyMotion> body_motions(const Simulation& sim) {
  std::vector<BodyMotion> motions;
  for (const Body& body : sim.model().bodies) {
    const int x = sim.model().topology.x_coord(body.node);
    motions.push_back({body.collider, sim.state().q.segment<3>(x), sim.state().v.segment<3>(x)});
  }
  return motions;
}

}  // namespace slipstitch
