// SPDX-License-Identifier: MIT
#pragma once

#include <unsupported/Eigen/BVH>
#include <vector>

#include "collide/distance.h"
#include "model/collider.h"

namespace slipstitch {

/// Signed distance to a closed mesh: the closest triangle by a tree of boxes, the sign by the angle-weighted normals of
/// Baerentzen and Aanaes, "Signed distance computation using the angle weighted pseudonormal", IEEE TVCG 11(3), 2005.
class MeshDistance {
 public:
  explicit MeshDistance(const TriangleMesh& mesh);
  Distance operator()(const Vec3& p) const;

 private:
  using Tree = Eigen::KdBVH<double, 3, int>;
  Vec3 edge_normal(int a, int b) const;

  TriangleMesh mesh_;
  std::vector<Vec3> face_normal_, vertex_normal_;
  std::vector<std::pair<std::array<int, 2>, Vec3>> edge_normal_;  // by ascending vertex pair, sorted
  Tree tree_;
};

}  // namespace slipstitch
