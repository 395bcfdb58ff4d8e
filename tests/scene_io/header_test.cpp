// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "scene_io/convert.h"
#include "scene_text.h"

namespace slipstitch {
namespace {

/// Every member has a value of its own.
FrameHeader full_header() {
  FrameHeader header;
  Topology& t = header.topology;
  t.num_nodes = 4;
  t.num_bodies = 3;
  t.yarn_first = {0, 3, 5};
  t.visit_node = {0, 1, 2, 3, 1};
  t.visit_slides = {0, 1, 1, 0, 1};
  t.visit_owned = {1, 1, 0, 1, 0};
  t.visit_extra = {0, 1, 0, 0, 1};
  t.segment_kind = {SegmentKind::free, SegmentKind::contact, SegmentKind::none, SegmentKind::free, SegmentKind::none};
  t.rest_arc = {0.0, 0.1, 0.25, 0.0, 0.3};
  t.yarn_material = {0, 1};
  t.density_scale = {1.35, 1.0};
  t.contacts.push_back({1, 2, 3, 4, 5, -1, {6, 7}, {8, -1}, -1, StitchKind::purl, ClaspSide::right, 9, false});
  t.contacts.push_back({});
  t.stitches.push_back({2, 3, StitchKind::purl, 4, 5, -1, 7, {10, 11, 12, 13, 14, 15, 16, 17}});
  t.stitches.push_back({});
  t.num_courses = 7;
  t.num_wales = 8;
  header.yarn = {0.1, 0.2, 0.3, 0.4};
  header.frames_per_s = 24.0;
  header.num_frames = 61;
  header.shrinkage = {{0.5, 0.9}, {2.0, 0.8}};
  return header;
}

TEST(Header, SurvivesTheMessage) {
  v1::FrameHeader message = message_from_header(full_header());
  std::optional<FrameHeader> back = header_from_message(message);
  ASSERT_TRUE(back);
  EXPECT_EQ(difference(message, message_from_header(*back)), "");
  const Topology before = full_header().topology, &after = back->topology;
  EXPECT_EQ(after.num_nodes, before.num_nodes);
  EXPECT_EQ(after.num_bodies, 3);
  EXPECT_EQ(after.yarn_first, before.yarn_first);
  EXPECT_EQ(after.visit_node, before.visit_node);
  EXPECT_EQ(after.visit_slides, before.visit_slides);
  EXPECT_EQ(after.visit_owned, before.visit_owned);
  EXPECT_EQ(after.visit_extra, before.visit_extra);
  EXPECT_EQ(after.segment_kind, before.segment_kind);
  EXPECT_EQ(after.rest_arc, before.rest_arc);
  EXPECT_EQ(after.yarn_material, before.yarn_material);
  EXPECT_EQ(after.density_scale, before.density_scale);
  EXPECT_EQ(after.num_courses, before.num_courses);
  EXPECT_EQ(after.num_wales, before.num_wales);
  EXPECT_EQ(back->yarn.bending_nm2, 0.4);
  EXPECT_EQ(back->frames_per_s, 24.0);
  EXPECT_EQ(back->num_frames, 61);
  ASSERT_EQ(back->shrinkage.size(), 2U);
  EXPECT_EQ(back->shrinkage[1].t, 2.0);
  EXPECT_EQ(back->shrinkage[1].factor, 0.8);
}

TEST(Header, ContactsAndStitchesSurviveTheMessage) {
  std::optional<FrameHeader> back = header_from_message(message_from_header(full_header()));
  ASSERT_TRUE(back);
  const StitchContact& c = back->topology.contacts[0];
  EXPECT_EQ((std::vector<int>{c.q0, c.q1, c.q4, c.q5, c.q2, c.q3}), (std::vector<int>{1, 2, 3, 4, 5, -1}));
  EXPECT_EQ(c.u_visit, (std::array<int, 2>{6, 7}));
  EXPECT_EQ(c.v_visit, (std::array<int, 2>{8, -1}));
  EXPECT_EQ(c.sign, -1);
  EXPECT_EQ(c.kind, StitchKind::purl);
  EXPECT_EQ(c.side, ClaspSide::right);
  EXPECT_EQ(c.stitch, 9);
  EXPECT_FALSE(c.owned);
  EXPECT_TRUE(back->topology.contacts[1].owned);
  const Stitch& s = back->topology.stitches[0];
  EXPECT_EQ((std::vector<int>{s.course, s.wale, s.base_left, s.base_right, s.head_left, s.head_right}),
            (std::vector<int>{2, 3, 4, 5, -1, 7}));
  EXPECT_EQ(s.kind, StitchKind::purl);
  EXPECT_EQ(s.node, (std::array<int, 8>{10, 11, 12, 13, 14, 15, 16, 17}));
}

TEST(Header, WhatTheCoreCannotHoldIsRefused) {
  const v1::FrameHeader good = message_from_header(full_header());
  v1::FrameHeader bad = good;
  bad.mutable_topology()->mutable_stitches(0)->mutable_node()->RemoveLast();
  EXPECT_FALSE(header_from_message(bad));
  bad = good;
  bad.mutable_topology()->mutable_contacts(1)->add_u_visit(3);
  EXPECT_FALSE(header_from_message(bad));
  bad = good;
  bad.mutable_topology()->set_segment_kind(0, static_cast<v1::Topology::SegmentKind>(9));
  EXPECT_FALSE(header_from_message(bad));
  bad = good;
  bad.mutable_topology()->mutable_contacts(0)->set_kind(static_cast<v1::StitchKind>(9));
  EXPECT_FALSE(header_from_message(bad));
  bad = good;
  bad.set_num_frames(3000000000u);
  EXPECT_FALSE(header_from_message(bad));
}

}  // namespace
}  // namespace slipstitch
