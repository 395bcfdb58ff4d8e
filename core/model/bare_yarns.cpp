// SPDX-License-Identifier: MIT
#include "model/bare_yarns.h"

#include <algorithm>
#include <map>
#include <utility>

#include "model/loop_run.h"

namespace slipstitch {
namespace {

using Point = std::pair<int, int>;  // yarn, point

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

// Rest arc lengths of a yarn whose points lie at `x`.
std::vector<double> arc_lengths(const BareYarn& yarn, const std::vector<Vec3>& x) {
  if (!yarn.arc_lengths_m.empty()) return yarn.arc_lengths_m;
  std::vector<double> arcs{0.0};
  for (std::size_t i = 1; i < x.size(); ++i) arcs.push_back(arcs.back() + (x[i] - x[i - 1]).norm() / yarn.prestretch);
  return arcs;
}

void shift_contact(StitchContact& contact, int nodes, int visits, int stitches) {
  for (int* node : {&contact.q0, &contact.q1, &contact.q2, &contact.q3, &contact.q4, &contact.q5}) {
    if (*node >= 0) *node += nodes;
  }
  for (auto* pair : {&contact.u_visit, &contact.v_visit}) {
    for (int& visit : *pair) visit += visits;
  }
  if (contact.stitch >= 0) contact.stitch += stitches;
}

void shift_stitch(Stitch& stitch, int nodes, int contacts) {
  for (int* contact : {&stitch.base_left, &stitch.base_right, &stitch.head_left, &stitch.head_right}) {
    if (*contact >= 0) *contact += contacts;
  }
  for (int& node : stitch.node) node += nodes;
}

template <class T>
void join(std::vector<T>& list, const std::vector<T>& more) {
  list.insert(list.end(), more.begin(), more.end());
}

void append_yarns(const Topology& more, Topology& topology) {
  const int visits = topology.num_visits();
  if (!topology.yarn_first.empty()) topology.yarn_first.pop_back();
  for (const int first : more.yarn_first) topology.yarn_first.push_back(first + visits);
  for (const int node : more.visit_node) topology.visit_node.push_back(node + topology.num_nodes);
  join(topology.visit_slides, more.visit_slides);
  if (!topology.visit_extra.empty() || !more.visit_extra.empty()) {
    topology.visit_extra.resize(idx(visits), 0);
    join(topology.visit_extra, more.visit_extra);
    topology.visit_extra.resize(idx(topology.num_visits()), 0);
  }
  join(topology.segment_kind, more.segment_kind);
  join(topology.rest_arc, more.rest_arc);
  join(topology.yarn_material, more.yarn_material);
  join(topology.density_scale, more.density_scale);
}

}  // namespace

PlacedTopology build_bare_yarns(const Scene& scene) {
  PlacedTopology placed;
  Topology& topology = placed.topology;
  std::map<Point, Point> shared;  // point b of a crossing -> point a
  std::map<Point, bool> slides;
  for (const Crossing& c : scene.crossings) {
    shared[{c.yarn_b, c.point_b}] = {c.yarn_a, c.point_a};
    slides[{c.yarn_a, c.point_a}] = slides[{c.yarn_b, c.point_b}] = true;
  }
  for (const Guide& g : scene.guides) slides[{g.yarn, g.point}] = true;

  std::map<Point, int> node_of;
  std::vector<Vec3> node_x;
  std::vector<double> arcs;
  for (int y = 0; y < static_cast<int>(scene.yarns.size()); ++y) {
    const BareYarn& yarn = scene.yarns[idx(y)];
    topology.yarn_first.push_back(topology.num_visits());
    std::vector<Vec3> x = yarn.points;
    for (int i = 0; i < static_cast<int>(x.size()); ++i) {
      const auto crossing = shared.find({y, i});
      const Point owner = crossing == shared.end() ? Point{y, i} : crossing->second;
      x[idx(i)] = scene.yarns[idx(owner.first)].points[idx(owner.second)];
      const auto [entry, added] = node_of.try_emplace(owner, topology.num_nodes);
      if (added) {
        ++topology.num_nodes;
        node_x.push_back(x[idx(i)]);
      }
      add_visit(topology, entry->second, slides.contains({y, i}), 0.0);
    }
    join(arcs, arc_lengths(yarn, x));
    topology.yarn_material.push_back(0);
    topology.density_scale.push_back(1.0);
  }
  topology.yarn_first.push_back(topology.num_visits());
  topology.rest_arc = arcs;
  mark_segments(topology);

  placed.q.resize(topology.num_coords());
  for (int n = 0; n < topology.num_nodes; ++n) placed.q.segment<3>(topology.x_coord(n)) = node_x[idx(n)];
  for (int i = 0; i < topology.num_visits(); ++i) placed.q[topology.arc_coord(i)] = arcs[idx(i)];
  return placed;
}

int node_of_point(const Topology& topology, int yarn, int point) {
  return topology.visit_node[idx(topology.yarn_first[idx(yarn)] + point)];
}

void append(const PlacedTopology& other, PlacedTopology& placed) {
  Topology& topology = placed.topology;
  const Topology& more = other.topology;
  const int nodes = topology.num_nodes, visits = topology.num_visits();
  const int contacts = static_cast<int>(topology.contacts.size());
  const int stitches = static_cast<int>(topology.stitches.size());
  append_yarns(more, topology);
  for (StitchContact contact : more.contacts) {
    shift_contact(contact, nodes, visits, stitches);
    topology.contacts.push_back(contact);
  }
  for (Stitch stitch : more.stitches) {
    shift_stitch(stitch, nodes, contacts);
    topology.stitches.push_back(stitch);
  }
  topology.num_nodes += more.num_nodes;
  topology.num_courses = std::max(topology.num_courses, more.num_courses);
  topology.num_wales = std::max(topology.num_wales, more.num_wales);

  VecX q(topology.num_coords());
  q << placed.q.head(3 * nodes), other.q.head(3 * more.num_nodes), placed.q.tail(visits),
      other.q.tail(more.num_visits());
  placed.q = std::move(q);
}

}  // namespace slipstitch
