// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "model/scene.h"

namespace slipstitch {

/// Yarns that crossings join.
struct Piece {
  std::vector<int> yarns;  // of Scene::yarns; the knit is the yarn behind them
  bool held = false;       // by a handle or a guide
  bool thrown = false;     // moves at the start
};

/// Of a scene that passed check().
std::vector<Piece> pieces_of(const Scene& scene);

}  // namespace slipstitch
