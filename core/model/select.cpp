// SPDX-License-Identifier: MIT
#include "model/select.h"

#include <algorithm>
#include <numeric>

namespace slipstitch {
namespace {

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

struct Select {
  const Topology& topology;

  std::vector<int> operator()(const StitchRange& range) const {
    std::vector<int> nodes;
    for (const Stitch& s : topology.stitches) {
      if (s.course < range.first_course || s.course > range.last_course) continue;
      if (s.wale < range.first_wale || s.wale > range.last_wale) continue;
      nodes.insert(nodes.end(), s.node.begin(), s.node.end());
    }
    return nodes;
  }

  std::vector<int> operator()(Corner corner) const {
    const bool top = corner == Corner::top_left || corner == Corner::top_right;
    const bool right = corner == Corner::bottom_right || corner == Corner::top_right;
    const int course = top ? topology.num_courses : 1, wale = right ? topology.num_wales : 1;
    return (*this)(StitchRange{course, course, wale, wale});
  }

  std::vector<int> operator()(Edge edge) const {
    StitchRange range{1, topology.num_courses, 1, topology.num_wales};
    if (edge == Edge::bottom) range.last_course = 1;
    if (edge == Edge::top) range.first_course = topology.num_courses;
    if (edge == Edge::left) range.last_wale = 1;
    if (edge == Edge::right) range.first_wale = topology.num_wales;
    return (*this)(range);
  }

  std::vector<int> operator()(const YarnPoint& point) const {
    const int first = topology.yarn_first[idx(point.yarn)], end = topology.yarn_first[idx(point.yarn) + 1];
    return {topology.visit_node[idx(point.point >= 0 ? first + point.point : end + point.point)]};
  }

  std::vector<int> operator()(const AllNodes&) const {
    std::vector<int> nodes(idx(topology.num_yarn_nodes()));
    std::iota(nodes.begin(), nodes.end(), 0);
    return nodes;
  }
};

}  // namespace

std::vector<int> select_nodes(const Selector& selector, const Topology& topology) {
  std::vector<int> nodes = std::visit(Select{topology}, selector);
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

}  // namespace slipstitch
