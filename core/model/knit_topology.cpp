// SPDX-License-Identifier: MIT
#include "model/knit_topology.h"

#include "model/knit_layout.h"
#include "model/knit_placement.h"
#include "model/loop_run.h"
#include "model/refine.h"

namespace slipstitch {
namespace {

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

class KnitBuilder {
 public:
  KnitBuilder(const Pattern& pattern, bool has_tails, const RestCell& cell)
      : pattern_(pattern), has_tails_(has_tails), cell_(cell), layout_(pattern, cell), runs_(pattern.cells.size()) {
    lay_yarn();
    add_stitches();
    add_clasps();
    add_bind_off();
    mark_segments(topology_);
    positions_ = layout_.positions();
    if (cell.extra_nodes > 0) add_extra_nodes();
  }

  // Arc lengths of `q` are the start's, positions `x`.
  PlacedTopology take(const std::vector<Vec3>& x) {
    PlacedTopology placed{std::move(topology_), {}};
    placed.q.resize(placed.topology.num_coords());
    for (int n = 0; n < placed.topology.num_nodes; ++n) placed.q.segment<3>(placed.topology.x_coord(n)) = x[idx(n)];
    for (int i = 0; i < placed.topology.num_visits(); ++i) placed.q[placed.topology.arc_coord(i)] = start_arc_[idx(i)];
    return placed;
  }

  const std::vector<Vec3>& positions() const { return positions_; }

 private:
  /// From one visit to the next.
  struct ArcStep {
    double rest, start;
    int course = 0, wale = 0, segment = -1;  // of the cell, tiled; -1: not of it
    bool along = true;                       // the yarn runs in the geometric order
  };

  int stitch_index(int course, int wale) const { return (course - 1) * pattern_.wales + wale - 1; }

  // Appends a visit `step` behind the last one.
  void visit(int node, ArcStep step) {
    if (!start_arc_.empty()) {
      rest_arc_ += step.rest;
      step.start += start_arc_.back();
      steps_.push_back(step);
    }
    add_visit(topology_, node, layout_.in_clasp(node), rest_arc_);
    start_arc_.push_back(step.start);
  }

  // Arc length of a segment outside the repeat: as long as it lies.
  ArcStep measured(int from, int to) const {
    const double length = (layout_.positions()[idx(to)] - layout_.positions()[idx(from)]).norm() * layout_.rest_ratio();
    return {length, length};
  }

  void visit_measured(int node) {
    const ArcStep step = topology_.visit_node.empty() ? ArcStep{0.0, 0.0} : measured(topology_.visit_node.back(), node);
    visit(node, step);
  }

  ArcStep from_cell(int course, int wale, int segment, int direction) const {
    const std::size_t i = idx(cell_.stitch_at(course, wale) * kVisitsPerStitch + segment);
    return {cell_.rest_length[i], cell_.start_length[i], course, wale, segment, direction > 0};
  }

  // The segment from the visit before position k of a loop, in the direction of the yarn. k is the loop's first
  // visit: the sinker from the neighbour.
  ArcStep step_to(int course, int wale, int k, int direction) const {
    const int segment = direction > 0 ? k - 1 : k;  // in geometric order; 7 is the sinker on the right
    if (segment < 0) return from_cell(course, wale - 1, kVisitsPerStitch - 1, direction);
    const bool at_bind_off = course == pattern_.courses && segment >= 1 && segment <= 5;
    if (!at_bind_off) return from_cell(course, wale, segment, direction);
    return measured(layout_.loop_node(course, wale, segment), layout_.loop_node(course, wale, segment + 1));
  }

  void lay_loop(int course, int wale, int direction, bool after_sinker) {
    runs_[idx(stitch_index(course, wale))] = {topology_.num_visits(), direction};
    for (int i = 0; i < kVisitsPerStitch; ++i) {
      const int k = direction > 0 ? i : kVisitsPerStitch - 1 - i;
      const int node = layout_.loop_node(course, wale, k);
      if (i == 0 && !after_sinker) {
        visit_measured(node);
      } else {
        visit(node, step_to(course, wale, k, direction));
      }
    }
  }

  void lay_yarn() {
    topology_.num_nodes = has_tails_ ? layout_.num_nodes() : layout_.tail(false);
    topology_.yarn_first.push_back(0);
    visit_measured(has_tails_ ? layout_.tail(false) : layout_.loop_node(1, pattern_.wales, 0));
    for (int course = 1; course <= pattern_.courses; ++course) {
      const int direction = pattern_.in_the_round || course % 2 == 1 ? -1 : 1;
      for (int i = 0; i < pattern_.wales; ++i) {
        const bool after_sinker = i > 0 || (pattern_.in_the_round && course > 1);
        lay_loop(course, direction > 0 ? i + 1 : pattern_.wales - i, direction, after_sinker);
      }
      if (!pattern_.in_the_round && course < pattern_.courses) {
        visit_measured(layout_.turn(course, false));
        visit_measured(layout_.turn(course, true));
      }
    }
    if (has_tails_) visit_measured(layout_.tail(true));
    topology_.visit_slides.back() = 0;
    topology_.yarn_first.push_back(topology_.num_visits());
    topology_.yarn_material = {0};
    topology_.density_scale = {cell_.density_scale};
  }

  void add_stitches() {
    topology_.num_courses = pattern_.courses;
    topology_.num_wales = pattern_.wales;
    for (int course = 1; course <= pattern_.courses; ++course) {
      for (int wale = 1; wale <= pattern_.wales; ++wale) {
        Stitch stitch;
        stitch.course = course;
        stitch.wale = wale;
        stitch.kind = pattern_.at(course, wale);
        for (int k = 0; k < kVisitsPerStitch; ++k) stitch.node[idx(k)] = layout_.loop_node(course, wale, k);
        topology_.stitches.push_back(stitch);
      }
    }
  }

  void add_clasps() {
    for (int course = 2; course <= pattern_.courses; ++course) {
      for (int wale = 1; wale <= pattern_.wales; ++wale) {
        const int above = stitch_index(course, wale), below = stitch_index(course - 1, wale);
        const int left = add_base_clasps(topology_, runs_[idx(above)], runs_[idx(below)], above, true);
        topology_.stitches[idx(above)].base_left = topology_.stitches[idx(below)].head_left = left;
        topology_.stitches[idx(above)].base_right = topology_.stitches[idx(below)].head_right = left + 1;
      }
    }
  }

  // u is the head on the left, v the one on the right: each stays on its own side of the axis bottom -> top. The left
  // head decides the hooking, so that a knit of purls is the mirror image of a knit of knits.
  void add_bind_off() {
    for (int wale = 1; wale < pattern_.wales; ++wale) {
      const int left = stitch_index(pattern_.courses, wale), right = left + 1;
      const LoopRun &u = runs_[idx(left)], &v = runs_[idx(right)];
      const int contact = static_cast<int>(topology_.contacts.size());
      topology_.contacts.push_back(make_contact(topology_, {u.visit(5), u.visit(4)}, {v.visit(2), v.visit(3)},
                                                topology_.stitches[idx(left)].kind, ClaspSide::left, -1));
      topology_.stitches[idx(left)].head_right = contact;
      topology_.stitches[idx(right)].head_left = contact;
    }
  }

  // Where the cell has them, else on a straight line.
  Vec3 place_between(int i, int piece) const {
    const ArcStep& step = steps_[idx(i)];
    if (step.segment >= 0)
      return cell_.position_between(step.course, step.wale, step.segment,
                                    step.along ? piece : cell_.extra_nodes + 1 - piece);
    const Vec3 &from = positions_[idx(topology_.visit_node[idx(i)])],
               &to = positions_[idx(topology_.visit_node[idx(i) + 1])];
    return from + piece / (cell_.extra_nodes + 1.0) * (to - from);
  }

  void add_extra_nodes() {
    Refined refined = refine(topology_, cell_.extra_nodes);
    positions_.resize(idx(topology_.num_nodes));
    for (std::size_t j = 0; j < refined.piece.size(); ++j)
      if (refined.piece[j] > 0) positions_.push_back(place_between(refined.coarse_visit[j], refined.piece[j]));
    start_arc_ = along(refined, start_arc_, cell_.extra_nodes);
    topology_ = std::move(refined.topology);
  }

  const Pattern& pattern_;
  const bool has_tails_;
  const RestCell& cell_;
  KnitLayout layout_;
  std::vector<LoopRun> runs_;  // by stitch
  std::vector<double> start_arc_;
  std::vector<ArcStep> steps_;  // behind each visit but the last
  std::vector<Vec3> positions_;
  double rest_arc_ = 0.0;
  Topology topology_;
};

}  // namespace

PlacedTopology build_knit(const Knit& knit, const RestCell& cell) {
  KnitBuilder builder(knit.pattern, !knit.ends_woven_in, cell);
  std::vector<Vec3> positions = builder.positions();
  if (knit.pattern.in_the_round) {
    const double circumference = cell.period_course.norm() * knit.pattern.wales / cell.repeat.wales;
    place_tube(knit.placement, circumference, positions);
  } else {
    place_flat(knit.placement, positions);
  }
  add_noise(knit.noise_m, knit.noise_seed, positions);
  return builder.take(positions);
}

}  // namespace slipstitch
