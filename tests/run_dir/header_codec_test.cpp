// SPDX-License-Identifier: MIT
#include "run_dir/header_codec.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "support/sample_run.h"

namespace slipstitch::test {
namespace {

TEST(HeaderCodec, KeepsEveryField) {
  const FrameHeader header = sample_header();
  const Result<FrameHeader> decoded = decode_header(encode_header(header));
  ASSERT_TRUE(decoded) << decoded.error;
  const Topology& a = header.topology;
  const Topology& b = decoded->topology;
  EXPECT_EQ(a.num_nodes, b.num_nodes);
  EXPECT_EQ(a.num_bodies, b.num_bodies);
  EXPECT_EQ(a.yarn_first, b.yarn_first);
  EXPECT_EQ(a.visit_node, b.visit_node);
  EXPECT_EQ(a.visit_slides, b.visit_slides);
  EXPECT_EQ(a.visit_owned, b.visit_owned);
  EXPECT_EQ(a.visit_extra, b.visit_extra);
  EXPECT_EQ(a.segment_kind, b.segment_kind);
  EXPECT_EQ(a.rest_arc, b.rest_arc);
  EXPECT_EQ(a.yarn_material, b.yarn_material);
  EXPECT_EQ(a.density_scale, b.density_scale);
  EXPECT_EQ(a.num_courses, b.num_courses);
  EXPECT_EQ(a.num_wales, b.num_wales);
  ASSERT_EQ(b.contacts.size(), 1u);
  const StitchContact& c = b.contacts[0];
  EXPECT_EQ((std::vector<int>{c.q0, c.q1, c.q4, c.q5, c.q2, c.q3, c.u_visit[0], c.u_visit[1], c.v_visit[0],
                              c.v_visit[1], c.sign, c.stitch, c.owned}),
            (std::vector<int>{1, 2, 0, 3, 4, -1, 1, 2, 6, 5, -1, 0, 0}));
  EXPECT_EQ(c.kind, StitchKind::purl);
  EXPECT_EQ(c.side, ClaspSide::right);
  ASSERT_EQ(b.stitches.size(), 1u);
  const Stitch& s = b.stitches[0];
  EXPECT_EQ((std::vector<int>{s.course, s.wale, s.base_left, s.base_right, s.head_left, s.head_right}),
            (std::vector<int>{1, 2, -1, 0, 0, -1}));
  EXPECT_EQ(s.kind, StitchKind::purl);
  EXPECT_EQ(s.node, a.stitches[0].node);
  EXPECT_EQ(decoded->yarn.radius_m, 0.6e-3);
  EXPECT_EQ(decoded->yarn.linear_density_kg_per_m, 0.08e-3);
  EXPECT_EQ(decoded->yarn.stretch_n, 70.0);
  EXPECT_EQ(decoded->yarn.bending_nm2, 5e-8);
  EXPECT_EQ(decoded->frames_per_s, 30.0);
  EXPECT_EQ(decoded->num_frames, 61);
  ASSERT_EQ(decoded->shrinkage.size(), 1u);
  EXPECT_EQ(decoded->shrinkage[0].t, 0.5);
  EXPECT_EQ(decoded->shrinkage[0].factor, 0.9);
}

TEST(HeaderCodec, RefusesEveryTruncationAndASurplus) {
  const std::string bytes = encode_header(sample_header());
  for (std::size_t kept = 0; kept < bytes.size(); ++kept) EXPECT_FALSE(decode_header(bytes.substr(0, kept))) << kept;
  EXPECT_FALSE(decode_header(bytes + '\0'));
}

TEST(HeaderCodec, RefusesWhatCannotBeTrusted) {
  using Change = std::function<void(FrameHeader&)>;
  const std::vector<std::pair<const char*, Change>> changes{
      {"nodes", [](FrameHeader& h) { h.topology.num_nodes = -1; }},
      {"overflow", [](FrameHeader& h) { h.topology.num_nodes = std::numeric_limits<int>::max(); }},
      {"bodies", [](FrameHeader& h) { h.topology.num_bodies = -1; }},
      {"more bodies than nodes", [](FrameHeader& h) { h.topology.num_bodies = 7; }},
      {"yarn through a body", [](FrameHeader& h) { h.topology.num_bodies = 2; }},
      {"visit", [](FrameHeader& h) { h.topology.visit_node[3] = 5; }},
      {"negative visit", [](FrameHeader& h) { h.topology.visit_node[3] = -1; }},
      {"slides", [](FrameHeader& h) { h.topology.visit_slides.pop_back(); }},
      {"owned", [](FrameHeader& h) { h.topology.visit_owned.pop_back(); }},
      {"extra nodes", [](FrameHeader& h) { h.topology.visit_extra.pop_back(); }},
      {"segments", [](FrameHeader& h) { h.topology.segment_kind.pop_back(); }},
      {"rest", [](FrameHeader& h) { h.topology.rest_arc.pop_back(); }},
      {"rest nan", [](FrameHeader& h) { h.topology.rest_arc[0] = std::numeric_limits<double>::quiet_NaN(); }},
      {"density", [](FrameHeader& h) { h.topology.density_scale.pop_back(); }},
      {"yarns",
       [](FrameHeader& h) {
         h.topology.yarn_first = {0, 7};
       }},
      {"first", [](FrameHeader& h) { h.topology.yarn_first[0] = 1; }},
      {"order", [](FrameHeader& h) { h.topology.yarn_first[1] = 9; }},
      {"last", [](FrameHeader& h) { h.topology.yarn_first[2] = 8; }},
      {"segment kind", [](FrameHeader& h) { h.topology.segment_kind[0] = static_cast<SegmentKind>(3); }},
      {"segment end", [](FrameHeader& h) { h.topology.segment_kind[3] = SegmentKind::free; }},
      {"contact node", [](FrameHeader& h) { h.topology.contacts[0].q0 = -1; }},
      {"contact outer", [](FrameHeader& h) { h.topology.contacts[0].q3 = 5; }},
      {"contact visit", [](FrameHeader& h) { h.topology.contacts[0].v_visit[1] = 7; }},
      {"contact sign", [](FrameHeader& h) { h.topology.contacts[0].sign = 0; }},
      {"contact kind", [](FrameHeader& h) { h.topology.contacts[0].kind = static_cast<StitchKind>(2); }},
      {"contact side", [](FrameHeader& h) { h.topology.contacts[0].side = static_cast<ClaspSide>(2); }},
      {"contact stitch", [](FrameHeader& h) { h.topology.contacts[0].stitch = 1; }},
      {"stitch kind", [](FrameHeader& h) { h.topology.stitches[0].kind = static_cast<StitchKind>(2); }},
      {"stitch node", [](FrameHeader& h) { h.topology.stitches[0].node[7] = 5; }},
      {"stitch contact", [](FrameHeader& h) { h.topology.stitches[0].head_left = 1; }},
      {"shrinkage", [](FrameHeader& h) { h.shrinkage[0].factor = 0.0; }},
      {"shrinkage time", [](FrameHeader& h) { h.shrinkage[0].t = std::numeric_limits<double>::infinity(); }},
      {"radius", [](FrameHeader& h) { h.yarn.radius_m = std::numeric_limits<double>::infinity(); }},
  };
  for (const auto& [what, change] : changes) {
    FrameHeader header = sample_header();
    change(header);
    const Result<FrameHeader> decoded = decode_header(encode_header(header));
    EXPECT_FALSE(decoded) << what;
    EXPECT_NE(decoded.error, "") << what;
  }
}

}  // namespace
}  // namespace slipstitch::test
