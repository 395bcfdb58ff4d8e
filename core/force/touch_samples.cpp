// SPDX-License-Identifier: MIT
#include "force/touch_samples.h"

#include <algorithm>
#include <cmath>

#include "force/scripted_nodes.h"
#include "force/segments.h"
#include "math/bytes.h"

namespace slipstitch {
namespace {

constexpr double kFarApart = 1.2;  // spacings
constexpr double kTooMany = 3.0;   // times the pieces that would do

}  // namespace

TouchSamples::TouchSamples(const Model& model, double spacing, TouchPoints points) : spacing_(spacing) {
  const Topology& topology = model.topology;
  std::vector<char> scripted = scripted_nodes(model);
  if (points == TouchPoints::all) scripted.assign(scripted.size(), 0);
  std::vector<char> taken(scripted.size(), 0);
  for_each_owned_segment(topology, [&](int, int i) {
    const auto v = static_cast<std::size_t>(i);
    const int n0 = topology.visit_node[v], n1 = topology.visit_node[v + 1];
    const int x0 = topology.x_coord(n0), x1 = topology.x_coord(n1);
    Segment segment{i, topology.arc_coord(i), {x0, x0 + 1, x0 + 2, x1, x1 + 1, x1 + 2}};
    const auto add_node = [&](int node, double share) {
      const auto n = static_cast<std::size_t>(node);
      if (!taken[n] && !scripted[n]) samples_.push_back({i, share, segment.coords});
      taken[n] = 1;
    };
    add_node(n0, 0.0);
    add_node(n1, 1.0);
    if (scripted[static_cast<std::size_t>(n0)] && scripted[static_cast<std::size_t>(n1)]) return;
    divide(segment, pieces_for(rest_length(topology, i)));
    segments_.push_back(segment);
  });
}

int TouchSamples::pieces_for(double arc) const {
  return std::max(1, static_cast<int>(std::ceil(arc / spacing_ - 1e-9)));
}

void TouchSamples::divide(Segment& segment, int pieces) {
  for (int k = 1; k < segment.pieces; ++k) samples_[static_cast<std::size_t>(segment.first + k - 1)].in_use = false;
  segment.pieces = pieces;
  segment.first = size();
  for (int k = 1; k < pieces; ++k) samples_.push_back({segment.visit, static_cast<double>(k) / pieces, segment.coords});
}

void TouchSamples::follow(const VecX& q, const std::function<bool(const Vec3& x)>& free) {
  for (Segment& segment : segments_) {
    const double length = (q.segment<3>(segment.coords[3]) - q.segment<3>(segment.coords[0])).norm();
    const double arc = std::max(length, q[segment.arc_coord + 1] - q[segment.arc_coord]);
    const int wanted = pieces_for(arc);
    const bool far_apart = arc > kFarApart * spacing_ * segment.pieces;
    if (!far_apart && kTooMany * wanted >= segment.pieces) continue;
    bool fits = true;
    for (int k = 1; k < wanted; ++k)
      fits = fits && free(place_of({segment.visit, static_cast<double>(k) / wanted, segment.coords}, q));
    if (fits) divide(segment, wanted);
  }
}

long TouchSamples::bytes() const { return bytes_of(segments_, samples_); }

}  // namespace slipstitch
