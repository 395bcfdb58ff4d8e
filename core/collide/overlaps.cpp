// SPDX-License-Identifier: MIT
#include "collide/overlaps.h"

#include <numeric>
#include <unsupported/Eigen/BVH>
#include <vector>

namespace slipstitch {
namespace {

/// What Eigen's BVIntersect asks for, over one tree against itself.
struct Visitor {
  using Box = Eigen::AlignedBox3d;
  std::span<const Box> boxes;
  const std::function<void(int, int)>& visit;

  const Box& box(int i) const { return boxes[static_cast<std::size_t>(i)]; }
  bool intersectVolumeVolume(const Box& a, const Box& b) const { return a.intersects(b); }
  bool intersectVolumeObject(const Box& a, int b) const { return a.intersects(box(b)); }
  bool intersectObjectVolume(int a, const Box& b) const { return b.intersects(box(a)); }
  bool intersectObjectObject(int a, int b) const {
    if (a < b && box(a).intersects(box(b))) visit(a, b);
    return false;  // go on
  }
};

}  // namespace

void for_each_overlap(std::span<const Eigen::AlignedBox3d> boxes, const std::function<void(int, int)>& visit) {
  if (boxes.size() < 2) return;
  std::vector<int> index(boxes.size());
  std::iota(index.begin(), index.end(), 0);
  const Eigen::KdBVH<double, 3, int> tree(index.begin(), index.end(), boxes.begin(), boxes.end());
  Visitor visitor{boxes, visit};
  Eigen::BVIntersect(tree, tree, visitor);
}

}  // namespace slipstitch
