// SPDX-License-Identifier: MIT
#include "gauntlet/passages.h"

#include <algorithm>

#include "collide/closest_point.h"
#include "force/segments.h"

namespace slipstitch::gauntlet {
namespace {

constexpr int kPieces = 16;  // of a step, in each of which two segments pass through each other at most once
constexpr int kBisections = 60;

using Four = std::array<Vec3, 4>;  // ends of two segments

Four four(const std::array<int, 6>& a, const std::array<int, 6>& b, const VecX& q0, const VecX& q1, double t) {
  const auto at = [&](int c) -> Vec3 { return (1.0 - t) * q0.segment<3>(c) + t * q1.segment<3>(c); };
  return {at(a[0]), at(a[3]), at(b[0]), at(b[3])};
}

double volume(const Four& x) { return (x[1] - x[0]).cross(x[3] - x[2]).dot(x[2] - x[0]); }

bool meet(const Four& x) {
  const SegmentPair close = closest_of_segments(x[0], x[1], x[2], x[3]);
  const Vec3 gap = x[0] + close.s * (x[1] - x[0]) - x[2] - close.t * (x[3] - x[2]);
  return gap.norm() <= 1e-9 * ((x[1] - x[0]).norm() + (x[3] - x[2]).norm());
}

}  // namespace

Passages::Passages(const Model& model) {
  joined_.resize(static_cast<std::size_t>(model.topology.num_nodes));
  const auto join = [&](int a, int b) { joined_[static_cast<std::size_t>(a)].push_back(b); };
  for_each_owned_segment(model.topology, [&](int, int i) {
    const auto c = segment_coords(model.topology, i);
    segments_.push_back({c[0], c[1], c[2], c[4], c[5], c[6]});
    const int a = c[0] / 3, b = c[4] / 3;
    join(a, a), join(b, b), join(a, b), join(b, a);
  });
  near_ = NearSegments(segments_, 0.0, model.yarn.radius_m);
}

bool Passages::neighbours(int a, int b) const {
  const auto &sa = segments_[static_cast<std::size_t>(a)], &sb = segments_[static_cast<std::size_t>(b)];
  for (const int i : {sa[0] / 3, sa[3] / 3})
    for (const int j : {sb[0] / 3, sb[3] / 3}) {
      const auto& joined = joined_[static_cast<std::size_t>(i)];
      if (std::find(joined.begin(), joined.end(), j) != joined.end()) return true;
    }
  return false;
}

void Passages::after_step(const VecX& q0, const VecX& q1) {
  near_.cover(q0, q1 - q0, [&](int a, int b) { return neighbours(a, b) ? -1.0 : 0.0; });
  for (const NearSegments::Pair& pair : near_.pairs()) {
    const auto &a = segments_[static_cast<std::size_t>(pair.a)], &b = segments_[static_cast<std::size_t>(pair.b)];
    double low = 0.0, at_low = volume(four(a, b, q0, q1, 0.0));
    for (int k = 1; k <= kPieces; ++k) {
      double high = static_cast<double>(k) / kPieces;
      const double at_high = volume(four(a, b, q0, q1, high)), next = high;
      if ((at_low > 0.0) != (at_high > 0.0)) {
        for (int i = 0; i < kBisections; ++i) {
          const double middle = 0.5 * (low + high);
          ((volume(four(a, b, q0, q1, middle)) > 0.0) == (at_low > 0.0) ? low : high) = middle;
        }
        if (meet(four(a, b, q0, q1, high))) ++count_;
      }
      low = next;
      at_low = at_high;
    }
  }
}

}  // namespace slipstitch::gauntlet
