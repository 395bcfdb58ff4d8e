// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "sim/run.h"

namespace slipstitch {

/// What is compared between runs, frame by frame.
struct FrameTrace {
  std::vector<double> t;         // [s]
  std::vector<VecX> x;           // of every node [m] (3 x num_nodes)
  std::vector<double> stored_j;  // energy in yarn and contacts: without that of motion, weight and loads
  std::vector<double> force_n;   // largest on any handle, in the last step; of scenes without: largest tension
  std::vector<double> length_m;  // of all yarn, stretched as it is

  std::size_t size() const { return t.size(); }
};
double bytes_of(const FrameTrace& trace);

/// Whether a term of RunSummary::energy_j is the potential of weight or loads, and not stored in yarn or contacts.
bool is_weight_or_load(std::string_view term);

/// Fills a trace from the hooks of the same names. The scene and the trace outlive it.
class FrameTracer {
 public:
  FrameTracer(const Scene& scene, FrameTrace& trace) : scene_(scene), trace_(trace) {}
  void on_header(const FrameHeader& header) { header_ = header; }
  void on_reactions(const std::vector<Vec3>& reactions);
  void on_frame(const Frame& frame);
  void on_frame_report(const FrameReport& report);

 private:
  double tension(const Frame& frame) const;
  double length(const Frame& frame) const;

  const Scene& scene_;
  FrameTrace& trace_;
  FrameHeader header_;
  double reaction_n_ = 0.0;
};

}  // namespace slipstitch
