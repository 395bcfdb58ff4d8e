// SPDX-License-Identifier: MIT
#include "model/pattern_places.h"

#include <algorithm>

namespace slipstitch {
namespace {

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

int apart(const std::array<int, 2>& a, const std::array<int, 2>& b) { return std::max({0, b[0] - a[1], a[0] - b[1]}); }

}  // namespace

void PatternPlaces::Place::add(const Stitch& stitch) {
  if (empty()) *this = {{stitch.course, stitch.course}, {stitch.wale, stitch.wale}};
  course = {std::min(course[0], stitch.course), std::max(course[1], stitch.course)};
  wale = {std::min(wale[0], stitch.wale), std::max(wale[1], stitch.wale)};
}

PatternPlaces::PatternPlaces(const Topology& topology) : topology_(topology) {
  find_places();
  extend_along_yarns();
  for (std::size_t v = 0; v + 1 < place_.size(); ++v) {
    const Place &here = place_[v], &next = place_[v + 1];
    if (yarn_[v] == yarn_[v + 1] && !here.empty() && !next.empty() && apart(here.wale, next.wale) > 1) round_ = true;
  }
}

void PatternPlaces::find_places() {
  std::vector<Place> of_node(idx(topology_.num_nodes));
  for (const Stitch& stitch : topology_.stitches)
    for (int node : stitch.node) of_node[idx(node)].add(stitch);
  std::vector<int> visit_of_node(idx(topology_.num_nodes), -1);
  for (int y = 0; y < topology_.num_yarns(); ++y)
    for (int v = topology_.yarn_first[idx(y)]; v < topology_.yarn_first[idx(y) + 1]; ++v) {
      const int node = topology_.visit_node[idx(v)];
      yarn_.push_back(y);
      place_.push_back(of_node[idx(node)]);
      if (visit_of_node[idx(node)] >= 0) shared_.push_back({visit_of_node[idx(node)], v});
      visit_of_node[idx(node)] = v;
    }
}

void PatternPlaces::extend_along_yarns() {
  for (std::size_t v = 1; v < place_.size(); ++v)
    if (place_[v].empty() && yarn_[v] == yarn_[v - 1]) place_[v] = place_[v - 1];
  for (std::size_t v = place_.size(); v-- > 1;)
    if (place_[v - 1].empty() && yarn_[v] == yarn_[v - 1]) place_[v - 1] = place_[v];
}

int PatternPlaces::wales_apart(const Place& a, const Place& b) const {
  const int straight = apart(a.wale, b.wale);
  const int around = topology_.num_wales - (std::max(a.wale[1], b.wale[1]) - std::min(a.wale[0], b.wale[0]));
  return round_ ? std::min(straight, around) : straight;
}

bool PatternPlaces::near_in_pattern(int i, int j, int reach) const {
  const Place &a = place_[idx(i)], &b = place_[idx(j)];
  return !a.empty() && !b.empty() && apart(a.course, b.course) <= reach && wales_apart(a, b) <= reach;
}

double PatternPlaces::arc_to_visit(int segment, int visit) const {
  const double u = topology_.rest_arc[idx(visit)];
  return std::max({0.0, topology_.rest_arc[idx(segment)] - u, u - topology_.rest_arc[idx(segment) + 1]});
}

bool PatternPlaces::near_on_yarn(int i, int j, double arc) const {
  const auto on_its_yarn = [&](int segment, int visit) { return yarn_[idx(segment)] == yarn_[idx(visit)]; };
  if (on_its_yarn(i, j) && std::min(arc_to_visit(i, j), arc_to_visit(i, j + 1)) < arc) return true;
  const auto over = [&](int u, int v) {
    return on_its_yarn(i, u) && on_its_yarn(j, v) && arc_to_visit(i, u) + arc_to_visit(j, v) < arc;
  };
  return std::any_of(shared_.begin(), shared_.end(),
                     [&](const auto& visits) { return over(visits[0], visits[1]) || over(visits[1], visits[0]); });
}

}  // namespace slipstitch
