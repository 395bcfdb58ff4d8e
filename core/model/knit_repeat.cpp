// SPDX-License-Identifier: MIT
#include "model/knit_repeat.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "model/loop_run.h"
#include "model/refine.h"

namespace slipstitch {
namespace {

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

class RepeatBuilder {
 public:
  RepeatBuilder(const Pattern& pattern, const RestCell& cell)
      : cell_(cell), courses_(cell.repeat.courses), wales_(cell.repeat.wales) {
    for (int s = 0; s < cell.stitches() * kNodesPerStitch; ++s) add_node(s, {0, 0});
    for (int c = 0; c <= courses_; ++c) add_course(c);
    close_yarns();
    add_stitches(pattern);
    mark_loop_segments();
    patch_.num_masters = kNodesPerStitch * cell.stitches();
    if (cell.extra_nodes > 0) add_extra_nodes();
    place();
  }

  PeriodicPatch take() { return std::move(patch_); }

 private:
  Topology& topology() { return patch_.placed.topology; }

  int add_node(int master, std::array<int, 2> shift) {
    const auto [entry, added] = node_of_.try_emplace({master, shift[0], shift[1]}, topology().num_nodes);
    if (added) {
      patch_.node_master.push_back(master);
      patch_.node_shift.push_back(shift);
      ++topology().num_nodes;
    }
    return entry->second;
  }

  // Node of any course and wale of the endless plane.
  int node_at(int course, int wale, BaseNode base) {
    const auto periods = [](int i, int n) { return (i - 1 >= 0 ? i - 1 : i - n) / n; };
    return add_node(kNodesPerStitch * cell_.stitch_at(course, wale) + base,
                    {periods(wale, wales_), periods(course, courses_)});
  }

  int loop_node(int course, int wale, int k) {
    const LoopNode node = kLoopNodes[idx(k)];
    return node_at(course + node.course_above, wale, node.base);
  }

  // One visit before the repeat, the repeat's loops, one visit behind it.
  void add_course(int course) {
    topology().yarn_first.push_back(topology().num_visits());
    const int row = cell_.stitch_at(course, 1) * kVisitsPerStitch;  // segments of this row of the cell
    const int in_row = kVisitsPerStitch * wales_;
    std::vector<double> rest(idx(in_row) + 1), start(idx(in_row) + 1);  // arcs from the first own visit on
    for (int i = 0; i < in_row; ++i) {
      rest[idx(i) + 1] = rest[idx(i)] + cell_.rest_length[idx(row + i)];
      start[idx(i) + 1] = start[idx(i)] + cell_.start_length[idx(row + i)];
    }
    for (int i = -1; i <= in_row; ++i) {
      const int wale = i < 0 ? 0 : i / kVisitsPerStitch + 1;
      const int in_period = (i + in_row) % in_row;
      const double periods = i < 0 ? -1.0 : i < in_row ? 0.0 : 1.0;
      const double offset = periods * rest.back();
      add_visit(topology(), loop_node(course, wale, (i + kVisitsPerStitch) % kVisitsPerStitch), true,
                rest[idx(in_period)] + offset);
      start_arc_.push_back(start[idx(in_period)] + offset);
      topology().visit_owned.push_back(course > 0 && i >= 0 && i < in_row ? 1 : 0);
      const int own_course = course > 0 ? course : courses_;
      patch_.visit_master.push_back(own_course * (in_row + 2) + 1 + in_period);
      patch_.visit_arc_offset.push_back(offset);
    }
  }

  void close_yarns() {
    topology().yarn_first.push_back(topology().num_visits());
    topology().yarn_material.assign(idx(courses_) + 1, 0);
    topology().density_scale.assign(idx(courses_) + 1, cell_.density_scale);
  }

  LoopRun run_of(int course, int wale) const {
    return {course * (kVisitsPerStitch * wales_ + 2) + 1 + (wale - 1) * kVisitsPerStitch, 1};
  }

  void add_stitches(const Pattern& pattern) {
    topology().num_courses = courses_;
    topology().num_wales = wales_;
    for (int c = 1; c <= courses_; ++c) {
      for (int w = 1; w <= wales_; ++w) {
        Stitch stitch;
        stitch.course = c;
        stitch.wale = w;
        stitch.kind = pattern.at(c, w);
        for (int k = 0; k < kVisitsPerStitch; ++k) stitch.node[idx(k)] = loop_node(c, w, k);
        topology().stitches.push_back(stitch);
        const int s = static_cast<int>(topology().stitches.size()) - 1;
        const int left = add_base_clasps(topology(), run_of(c, w), run_of(c - 1, w), s, true);
        topology().stitches[idx(s)].base_left = left;
        topology().stitches[idx(s)].base_right = left + 1;
        if (c > 1) {
          topology().stitches[idx(s - wales_)].head_left = left;
          topology().stitches[idx(s - wales_)].head_right = left + 1;
        }
      }
    }
  }

  // By place in the loop: the heads of the last course lie in clasps whose contacts belong to images.
  void mark_loop_segments() {
    mark_segments(topology());
    for (int c = 0; c <= courses_; ++c) {
      for (int w = 1; w <= wales_; ++w) {
        for (int k = 0; k < kVisitsPerStitch; k += 2) {
          topology().segment_kind[idx(run_of(c, w).visit(k))] = SegmentKind::contact;
        }
      }
    }
  }

  // Free segments are those that start at odd places in the loop.
  int master_between(int coarse_visit, int piece) const {
    const int in_row = kVisitsPerStitch * wales_;
    const int course = coarse_visit / (in_row + 2), in_period = coarse_visit % (in_row + 2) - 1;
    const int segment = (course - 1) * in_row + in_period;
    return kNodesPerStitch * cell_.stitches() + segment / 2 * cell_.extra_nodes + piece - 1;
  }

  void add_extra_nodes() {
    const Topology coarse = topology();
    const std::vector<int> master_of = patch_.visit_master;
    const std::vector<double> offset_of = patch_.visit_arc_offset;
    Refined refined = refine(coarse, cell_.extra_nodes);
    std::vector<int> fine_visit(idx(coarse.num_visits()));
    for (std::size_t j = 0; j < refined.piece.size(); ++j)
      if (refined.piece[j] == 0) fine_visit[idx(refined.coarse_visit[j])] = static_cast<int>(j);
    patch_.visit_master.clear();
    patch_.visit_arc_offset.clear();
    for (std::size_t j = 0; j < refined.piece.size(); ++j) {
      const std::size_t i = idx(refined.coarse_visit[j]);
      const int piece = refined.piece[j], master = master_of[i];
      patch_.visit_master.push_back(fine_visit[idx(master)] + piece);
      patch_.visit_arc_offset.push_back(offset_of[i]);
      if (piece == 0) continue;
      const auto &shift = patch_.node_shift[idx(coarse.visit_node[i])],
                 &of_master = patch_.node_shift[idx(coarse.visit_node[idx(master)])];
      patch_.node_master.push_back(master_between(master, piece));
      patch_.node_shift.push_back({shift[0] - of_master[0], shift[1] - of_master[1]});
    }
    start_arc_ = along(refined, start_arc_, cell_.extra_nodes);
    topology() = std::move(refined.topology);
    patch_.num_masters += kVisitsPerStitch / 2 * cell_.stitches() * cell_.extra_nodes;
    patch_.extra_nodes = cell_.extra_nodes;
    masters_first();
  }

  // Gives the repeat's own nodes their masters' numbers, and the others those behind, in their order.
  void masters_first() {
    const std::vector<int> master = patch_.node_master;
    const auto shift = patch_.node_shift;
    std::vector<int> number(master.size());
    int next = patch_.num_masters;
    for (std::size_t n = 0; n < number.size(); ++n)
      number[n] = shift[n] == std::array<int, 2>{0, 0} ? master[n] : next++;
    for (std::size_t n = 0; n < number.size(); ++n) {
      patch_.node_master[idx(number[n])] = master[n];
      patch_.node_shift[idx(number[n])] = shift[n];
    }
    const auto renumber = [&](int& node) {
      if (node >= 0) node = number[idx(node)];
    };
    for (int& node : topology().visit_node) renumber(node);
    for (StitchContact& contact : topology().contacts)
      for (int* node : {&contact.q0, &contact.q1, &contact.q4, &contact.q5, &contact.q2, &contact.q3}) renumber(*node);
    for (Stitch& stitch : topology().stitches)
      for (int& node : stitch.node) renumber(node);
  }

  Vec3 master_position(int master) const {
    const int extra = master - kNodesPerStitch * cell_.stitches();
    if (extra < 0) return cell_.node_position[idx(master)];
    const int segment = 2 * (extra / cell_.extra_nodes) + 1;
    return cell_.between[idx(segment * cell_.extra_nodes + extra % cell_.extra_nodes)];
  }

  void place() {
    patch_.courses = courses_;
    patch_.wales = wales_;
    patch_.period_course = cell_.period_course;
    patch_.period_wale = cell_.period_wale;
    VecX& q = patch_.placed.q;
    q.resize(topology().num_coords());
    for (int n = 0; n < topology().num_nodes; ++n) {
      const auto shift = patch_.node_shift[idx(n)];
      q.segment<3>(topology().x_coord(n)) =
          master_position(patch_.node_master[idx(n)]) + shift[0] * cell_.period_course + shift[1] * cell_.period_wale;
    }
    for (int i = 0; i < topology().num_visits(); ++i) q[topology().arc_coord(i)] = start_arc_[idx(i)];
  }

  const RestCell& cell_;
  int courses_, wales_;
  std::map<std::array<int, 3>, int> node_of_;
  std::vector<double> start_arc_;
  PeriodicPatch patch_;
};

// Turns period_course onto +x within the plane of the fabric and moves the cell to its standard place.
void standardise(RestCell& cell) {
  const double angle = -std::atan2(cell.period_course.y(), cell.period_course.x());
  const Mat3 turn = Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix();
  cell.period_course = turn * cell.period_course;
  cell.period_wale = turn * cell.period_wale;
  for (Vec3& x : cell.node_position) x = turn * x;
  for (Vec3& x : cell.between) x = turn * x;

  const auto& x = cell.node_position;
  const Vec3 mean = std::accumulate(x.begin(), x.end(), Vec3(Vec3::Zero())) / static_cast<double>(x.size());
  const Vec3 first = 0.25 * (x[0] + x[1] + x[2] + x[3]);
  const auto lowest = std::min_element(x.begin(), x.end(), [](const Vec3& a, const Vec3& b) { return a.y() < b.y(); });
  const Vec3 move(0.5 * cell.period_course.x() / cell.repeat.wales - first.x(), -lowest->y(), -mean.z());
  for (Vec3& position : cell.node_position) position += move;
  for (Vec3& position : cell.between) position += move;
}

}  // namespace

PeriodicPatch build_repeat(const Pattern& pattern, const RestCell& cell) { return RepeatBuilder(pattern, cell).take(); }

RestCell cell_from_patch(const PeriodicPatch& patch, const VecX& q, const Vec3& period_course,
                         const Vec3& period_wale) {
  const Topology& topology = patch.placed.topology;
  RestCell cell;
  cell.repeat = {patch.courses, patch.wales};
  cell.period_course = period_course;
  cell.period_wale = period_wale;
  cell.density_scale = topology.density_scale[0];
  for (int n = 0; n < kNodesPerStitch * cell.stitches(); ++n) {
    cell.node_position.push_back(q.segment<3>(topology.x_coord(n)));
  }
  const auto arc = [&](int visit) {
    return q[topology.arc_coord(patch.visit_master[idx(visit)])] + patch.visit_arc_offset[idx(visit)];
  };
  cell.extra_nodes = patch.extra_nodes;
  for (int i = 0; i < topology.num_visits(); ++i) {
    if (!topology.owned(i) || topology.extra(i)) continue;
    int next = i + 1;
    while (topology.extra(next)) ++next;
    cell.rest_length.push_back(topology.rest_arc[idx(next)] - topology.rest_arc[idx(i)]);
    cell.start_length.push_back(arc(next) - arc(i));
    const auto at = [&](int visit) { return Vec3(q.segment<3>(topology.x_coord(topology.visit_node[idx(visit)]))); };
    for (int piece = 1; piece <= cell.extra_nodes; ++piece) {
      const bool divided = next > i + 1;
      cell.between.push_back(divided ? at(i + piece) : at(i) + piece / (cell.extra_nodes + 1.0) * (at(next) - at(i)));
    }
  }
  standardise(cell);
  return cell;
}

}  // namespace slipstitch
