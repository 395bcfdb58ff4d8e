// SPDX-License-Identifier: MIT
#include "run_dir/header_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <vector>

namespace slipstitch {
namespace {

bool in_range(int value, int first, std::int64_t end) { return value >= first && value < end; }

template <class Values>
bool all_in_range(const Values& values, int first, std::int64_t end) {
  return std::all_of(std::begin(values), std::end(values), [&](int value) { return in_range(value, first, end); });
}

bool all_finite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

std::string size_flaw(const Topology& topology) {
  const std::size_t visits = topology.visit_node.size();
  const std::int64_t coords = 3 * std::int64_t{topology.num_nodes} + static_cast<std::int64_t>(visits);
  if (topology.num_nodes < 0 || coords > std::numeric_limits<int>::max()) return "number of nodes out of range";
  if (!in_range(topology.num_bodies, 0, topology.num_nodes + std::int64_t{1})) return "number of bodies out of range";
  if (topology.visit_slides.size() != visits || topology.segment_kind.size() != visits ||
      topology.rest_arc.size() != visits || (!topology.visit_owned.empty() && topology.visit_owned.size() != visits) ||
      (!topology.visit_extra.empty() && topology.visit_extra.size() != visits)) {
    return "arrays of visits differ in length";
  }
  if (topology.yarn_first.size() != topology.yarn_material.size() + 1 ||
      topology.density_scale.size() != topology.yarn_material.size()) {
    return "arrays of yarns differ in length";
  }
  return {};
}

std::string yarn_flaw(const Topology& topology) {
  const auto& first = topology.yarn_first;
  if (first.front() != 0 || first.back() != topology.num_visits() || !std::is_sorted(first.begin(), first.end())) {
    return "yarns do not cover the visits";
  }
  if (!all_in_range(topology.visit_node, 0, topology.num_yarn_nodes())) return "a visit of no node";
  const auto known = [](SegmentKind kind) { return kind <= SegmentKind::contact; };
  if (!std::all_of(topology.segment_kind.begin(), topology.segment_kind.end(), known)) return "unknown segment kind";
  for (int yarn = 0; yarn < topology.num_yarns(); ++yarn) {
    const int last = first[static_cast<std::size_t>(yarn) + 1] - 1;
    if (last >= first[static_cast<std::size_t>(yarn)] &&
        topology.segment_kind[static_cast<std::size_t>(last)] != SegmentKind::none) {
      return "a segment behind the last visit of a yarn";
    }
  }
  if (!all_finite(topology.rest_arc) || !all_finite(topology.density_scale)) return "a number is not finite";
  return {};
}

bool contact_fits(const Topology& topology, const StitchContact& contact) {
  const auto stitches = static_cast<std::int64_t>(topology.stitches.size());
  return all_in_range(std::initializer_list<int>{contact.q0, contact.q1}, 0, topology.num_yarn_nodes()) &&
         all_in_range(std::initializer_list<int>{contact.q4, contact.q5, contact.q2, contact.q3}, -1,
                      topology.num_yarn_nodes()) &&
         all_in_range(contact.u_visit, -1, topology.num_visits()) &&
         all_in_range(contact.v_visit, -1, topology.num_visits()) && (contact.sign == 1 || contact.sign == -1) &&
         contact.kind <= StitchKind::purl && contact.side <= ClaspSide::right && in_range(contact.stitch, -1, stitches);
}

bool stitch_fits(const Topology& topology, const Stitch& stitch) {
  const auto contacts = static_cast<std::int64_t>(topology.contacts.size());
  return stitch.kind <= StitchKind::purl && all_in_range(stitch.node, -1, topology.num_yarn_nodes()) &&
         all_in_range(
             std::initializer_list<int>{stitch.base_left, stitch.base_right, stitch.head_left, stitch.head_right}, -1,
             contacts);
}

}  // namespace

std::string header_flaw(const FrameHeader& header) {
  const Topology& topology = header.topology;
  if (std::string why = size_flaw(topology); !why.empty()) return why;
  if (std::string why = yarn_flaw(topology); !why.empty()) return why;
  for (const StitchContact& contact : topology.contacts) {
    if (!contact_fits(topology, contact)) return "a contact points outside the topology";
  }
  for (const Stitch& stitch : topology.stitches) {
    if (!stitch_fits(topology, stitch)) return "a stitch points outside the topology";
  }
  const YarnMaterial& yarn = header.yarn;
  if (!all_finite(
          {yarn.radius_m, yarn.linear_density_kg_per_m, yarn.stretch_n, yarn.bending_nm2, header.frames_per_s})) {
    return "a number is not finite";
  }
  for (const LengthKeyframe& key : header.shrinkage) {
    if (!all_finite({key.t, key.factor}) || !(key.factor > 0.0)) return "a rest length is not positive";
  }
  return {};
}

}  // namespace slipstitch
