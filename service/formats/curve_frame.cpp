// SPDX-License-Identifier: MIT
#include "formats/curve_frame.h"

namespace slipstitch {
namespace {

bool has_segment(const Topology& topology, int visit) {
  return topology.segment_kind[static_cast<std::size_t>(visit)] != SegmentKind::none;
}

// Mean over the segments before and behind visit i; 0 at a point without any.
double mean_tension(const Topology& topology, const std::vector<double>& tension, int visit) {
  double sum = 0.0;
  int count = 0;
  for (const int segment : {visit - 1, visit}) {
    if (segment < 0 || !has_segment(topology, segment)) continue;
    sum += tension[static_cast<std::size_t>(segment)];
    ++count;
  }
  return count == 0 ? 0.0 : sum / count;
}

}  // namespace

CurveFrame make_curve_frame(const FrameHeader& header, const Frame& frame, const Frame& reference) {
  const Topology& topology = header.topology;
  const Derived derived = derive(header, frame, reference);
  CurveFrame curves;
  curves.index = frame.index;
  curves.t = frame.t;
  curves.radius_m = header.yarn.radius_m;
  curves.first = topology.yarn_first;
  curves.slid_m = derived.slid_m;
  for (int visit = 0; visit < topology.num_visits(); ++visit) {
    const int node = topology.visit_node[static_cast<std::size_t>(visit)];
    curves.points.push_back(frame.q.segment<3>(topology.x_coord(node)));
    curves.arc_length_m.push_back(frame.q[topology.arc_coord(visit)]);
    curves.tension_n.push_back(mean_tension(topology, derived.tension_n, visit));
  }
  for (std::size_t i = 0; i + 1 < derived.wrap_rad.size(); i += 2) {
    curves.wrap_rad.push_back({derived.wrap_rad[i], derived.wrap_rad[i + 1]});
  }
  return curves;
}

}  // namespace slipstitch
