// SPDX-License-Identifier: MIT
#include "study/frame_trace.h"

#include <algorithm>

namespace slipstitch {

double bytes_of(const FrameTrace& trace) {
  double doubles = 0.0;
  for (const VecX& x : trace.x) doubles += static_cast<double>(x.size()) + 4.0;
  return doubles * sizeof(double);
}

bool is_weight_or_load(std::string_view term) {
  return term == "gravity" || term == "body_gravity" || term == "dead_load";
}

void FrameTracer::on_reactions(const std::vector<Vec3>& reactions) {
  reaction_n_ = 0.0;
  for (const Vec3& reaction : reactions) reaction_n_ = std::max(reaction_n_, reaction.norm());
}

void FrameTracer::on_frame(const Frame& frame) {
  trace_.t.push_back(frame.t);
  trace_.x.emplace_back(frame.q.head(3 * header_.topology.num_nodes));
  trace_.force_n.push_back(scene_.handles.empty() ? tension(frame) : reaction_n_);
  trace_.length_m.push_back(length(frame));
}

void FrameTracer::on_frame_report(const FrameReport& report) {
  double sum = 0.0;
  for (const auto& [term, energy] : report.energy_j)
    if (term != "kinetic" && !is_weight_or_load(term)) sum += energy.value_or(0.0);
  trace_.stored_j.push_back(sum);
}

double FrameTracer::tension(const Frame& frame) const {
  if (!scene_.effects.stretch) return 0.0;
  const std::vector<double> tension = derive(header_, frame, frame).tension_n;
  return std::max(0.0, *std::max_element(tension.begin(), tension.end()));
}

double FrameTracer::length(const Frame& frame) const {
  const Topology& topology = header_.topology;
  double sum = 0.0;
  for (int i = 0; i < topology.num_visits(); ++i) {
    const auto v = static_cast<std::size_t>(i);
    if (topology.segment_kind[v] == SegmentKind::none) continue;
    const int from = topology.x_coord(topology.visit_node[v]), to = topology.x_coord(topology.visit_node[v + 1]);
    sum += (frame.q.segment<3>(to) - frame.q.segment<3>(from)).norm();
  }
  return sum;
}

}  // namespace slipstitch
