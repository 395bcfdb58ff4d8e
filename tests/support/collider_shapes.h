// SPDX-License-Identifier: MIT
#pragma once

#include "model/collider.h"

namespace slipstitch::test {

/// The surface of a box, two triangles a face, counter-clockwise from outside.
inline TriangleMesh box_mesh(const Vec3& centre, const Vec3& half_size) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    const Vec3 side((i & 1) != 0 ? 1.0 : -1.0, (i & 2) != 0 ? 1.0 : -1.0, (i & 4) != 0 ? 1.0 : -1.0);
    mesh.vertices.push_back(centre + side.cwiseProduct(half_size));
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

}  // namespace slipstitch::test
