// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include "scene_io/convert.h"
#include "scene_io/convert_parts.h"

namespace slipstitch {
namespace {

void write_contact(const StitchContact& contact, v1::StitchContact& message) {
  message.set_q0(contact.q0);
  message.set_q1(contact.q1);
  message.set_q4(contact.q4);
  message.set_q5(contact.q5);
  message.set_q2(contact.q2);
  message.set_q3(contact.q3);
  message.mutable_u_visit()->Add(contact.u_visit.begin(), contact.u_visit.end());
  message.mutable_v_visit()->Add(contact.v_visit.begin(), contact.v_visit.end());
  message.set_sign(contact.sign);
  message.set_kind(contact.kind == StitchKind::knit ? v1::KNIT : v1::PURL);
  message.set_side(contact.side == ClaspSide::left ? v1::LEFT_CLASP : v1::RIGHT_CLASP);
  message.set_stitch(contact.stitch);
  message.set_owned(contact.owned);
}

bool read_contact(const v1::StitchContact& message, StitchContact& contact) {
  if (message.u_visit_size() != 2 || message.v_visit_size() != 2) return false;
  if (!v1::StitchKind_IsValid(message.kind()) || !v1::ClaspSide_IsValid(message.side())) return false;
  contact.q0 = message.q0();
  contact.q1 = message.q1();
  contact.q4 = message.q4();
  contact.q5 = message.q5();
  contact.q2 = message.q2();
  contact.q3 = message.q3();
  std::copy(message.u_visit().begin(), message.u_visit().end(), contact.u_visit.begin());
  std::copy(message.v_visit().begin(), message.v_visit().end(), contact.v_visit.begin());
  contact.sign = message.sign();
  contact.kind = message.kind() == v1::KNIT ? StitchKind::knit : StitchKind::purl;
  contact.side = message.side() == v1::LEFT_CLASP ? ClaspSide::left : ClaspSide::right;
  contact.stitch = message.stitch();
  contact.owned = message.owned();
  return true;
}

void write_stitch(const Stitch& stitch, v1::Stitch& message) {
  message.set_course(stitch.course);
  message.set_wale(stitch.wale);
  message.set_kind(stitch.kind == StitchKind::knit ? v1::KNIT : v1::PURL);
  message.set_base_left(stitch.base_left);
  message.set_base_right(stitch.base_right);
  message.set_head_left(stitch.head_left);
  message.set_head_right(stitch.head_right);
  message.mutable_node()->Add(stitch.node.begin(), stitch.node.end());
}

bool read_stitch(const v1::Stitch& message, Stitch& stitch) {
  if (message.node_size() != static_cast<int>(stitch.node.size()) || !v1::StitchKind_IsValid(message.kind())) {
    return false;
  }
  stitch.course = message.course();
  stitch.wale = message.wale();
  stitch.kind = message.kind() == v1::KNIT ? StitchKind::knit : StitchKind::purl;
  stitch.base_left = message.base_left();
  stitch.base_right = message.base_right();
  stitch.head_left = message.head_left();
  stitch.head_right = message.head_right();
  std::copy(message.node().begin(), message.node().end(), stitch.node.begin());
  return true;
}

v1::Topology::SegmentKind segment_message(SegmentKind kind) {
  switch (kind) {
    case SegmentKind::none:
      return v1::Topology::NONE;
    case SegmentKind::free:
      return v1::Topology::FREE;
    case SegmentKind::contact:
      return v1::Topology::CONTACT;
  }
  return v1::Topology::NONE;
}

void write_topology(const Topology& topology, v1::Topology& message) {
  message.set_num_nodes(topology.num_nodes);
  message.mutable_yarn_first()->Add(topology.yarn_first.begin(), topology.yarn_first.end());
  message.mutable_visit_node()->Add(topology.visit_node.begin(), topology.visit_node.end());
  for (std::uint8_t slides : topology.visit_slides) message.add_visit_slides(slides != 0);
  for (std::uint8_t owned : topology.visit_owned) message.add_visit_owned(owned != 0);
  for (std::uint8_t extra : topology.visit_extra) message.add_visit_extra(extra != 0);
  for (SegmentKind kind : topology.segment_kind) message.add_segment_kind(segment_message(kind));
  message.mutable_rest_arc_m()->Add(topology.rest_arc.begin(), topology.rest_arc.end());
  message.mutable_yarn_material()->Add(topology.yarn_material.begin(), topology.yarn_material.end());
  message.mutable_density_scale()->Add(topology.density_scale.begin(), topology.density_scale.end());
  for (const StitchContact& contact : topology.contacts) write_contact(contact, *message.add_contacts());
  for (const Stitch& stitch : topology.stitches) write_stitch(stitch, *message.add_stitches());
  message.set_num_courses(topology.num_courses);
  message.set_num_wales(topology.num_wales);
  message.set_num_bodies(topology.num_bodies);
}

void read_visits(const v1::Topology& message, Topology& topology) {
  topology.num_nodes = message.num_nodes();
  topology.yarn_first.assign(message.yarn_first().begin(), message.yarn_first().end());
  topology.visit_node.assign(message.visit_node().begin(), message.visit_node().end());
  topology.visit_slides.assign(message.visit_slides().begin(), message.visit_slides().end());
  topology.visit_owned.assign(message.visit_owned().begin(), message.visit_owned().end());
  topology.visit_extra.assign(message.visit_extra().begin(), message.visit_extra().end());
  topology.rest_arc.assign(message.rest_arc_m().begin(), message.rest_arc_m().end());
  topology.yarn_material.assign(message.yarn_material().begin(), message.yarn_material().end());
  topology.density_scale.assign(message.density_scale().begin(), message.density_scale().end());
  topology.num_courses = message.num_courses();
  topology.num_wales = message.num_wales();
  topology.num_bodies = message.num_bodies();
}

bool read_segment_kinds(const v1::Topology& message, Topology& topology) {
  for (int number : message.segment_kind()) {
    switch (number) {
      case v1::Topology::NONE:
        topology.segment_kind.push_back(SegmentKind::none);
        break;
      case v1::Topology::FREE:
        topology.segment_kind.push_back(SegmentKind::free);
        break;
      case v1::Topology::CONTACT:
        topology.segment_kind.push_back(SegmentKind::contact);
        break;
      default:
        return false;
    }
  }
  return true;
}

bool read_topology(const v1::Topology& message, Topology& topology) {
  read_visits(message, topology);
  bool good = read_segment_kinds(message, topology);
  for (const v1::StitchContact& contact : message.contacts()) {
    good = good && read_contact(contact, topology.contacts.emplace_back());
  }
  for (const v1::Stitch& stitch : message.stitches()) {
    good = good && read_stitch(stitch, topology.stitches.emplace_back());
  }
  return good;
}

}  // namespace

v1::FrameHeader message_from_header(const FrameHeader& header) {
  v1::FrameHeader message;
  write_topology(header.topology, *message.mutable_topology());
  write_material(header.yarn, *message.mutable_yarn());
  message.set_frames_per_s(header.frames_per_s);
  message.set_num_frames(static_cast<std::uint32_t>(header.num_frames));
  add_length_keyframes(header.shrinkage, *message.mutable_shrinkage());
  return message;
}

std::optional<FrameHeader> header_from_message(const v1::FrameHeader& message) {
  FrameHeader header;
  if (!read_topology(message.topology(), header.topology)) return std::nullopt;
  if (!std::in_range<int>(message.num_frames())) return std::nullopt;
  header.yarn = material_from_message(message.yarn());
  header.frames_per_s = message.frames_per_s();
  header.num_frames = static_cast<int>(message.num_frames());
  header.shrinkage = length_keyframes_from(message.shrinkage());
  return header;
}

}  // namespace slipstitch
