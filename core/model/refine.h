// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "model/topology.h"

namespace slipstitch {

/// A topology with more nodes on its free yarn, and where each of its visits was.
struct Refined {
  Topology topology;
  /// The visit of the coarse topology at or before it, and how many new ones it is behind that. (num_visits)
  std::vector<int> coarse_visit, piece;
};

/// Divides every free segment into extra + 1 equally long ones by nodes of their own, which keep their arc length. The
/// new nodes come behind the others, along the yarns. Contacts stay as they are, their outer nodes too: a wrap lies
/// between contacts, whatever lies between them. `coarse` must have no extra nodes and no bodies; extra >= 0.
Refined refine(const Topology& coarse, int extra);

/// Of a value that the coarse visits have, straight in between. (num_visits)
std::vector<double> along(const Refined& refined, const std::vector<double>& coarse, int extra);

}  // namespace slipstitch
