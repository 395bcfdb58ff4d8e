// SPDX-License-Identifier: MIT
#include "formats/formats.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "support/parsers/curves.h"
#include "support/sample_run.h"

namespace slipstitch::test {
namespace {

const FrameHeader kHeader = sample_header();
const Frame kStart = sample_frame(kHeader, 0);
const Frame kFrame = sample_frame(kHeader, 3);
const CurveFrame kCurves = make_curve_frame(kHeader, kFrame, kStart);

// What every file must show: positions from q itself, by yarn and visit.
template <class Real>
void expect_state(const Curves<Real>& file) {
  const Topology& topology = kHeader.topology;
  ASSERT_EQ(file.curves.size(), static_cast<std::size_t>(topology.num_yarns()));
  int visit = 0;
  for (const auto& curve : file.curves) {
    for (const auto& point : curve) {
      const int node = topology.visit_node[static_cast<std::size_t>(visit++)];
      for (int c = 0; c < 3; ++c) {
        EXPECT_EQ(point[static_cast<std::size_t>(c)], static_cast<Real>(kFrame.q[3 * node + c])) << visit;
      }
    }
  }
  EXPECT_EQ(visit, topology.num_visits());
  EXPECT_EQ(file.curves[0].size(), 4u);
}

TEST(Formats, ObjKeepsEveryBit) {
  const auto file = parse_obj(write_obj(kCurves));
  ASSERT_TRUE(file);
  expect_state(*file);
}

TEST(Formats, BccKeepsEveryBitOfAFloat) {
  const std::string bytes = write_bcc(kCurves);
  EXPECT_EQ(bytes.size(), 64u + 2 * 4 + 7 * 12);
  const auto file = parse_bcc(bytes);
  ASSERT_TRUE(file);
  expect_state(*file);
  EXPECT_EQ(file->type, "C0");
  EXPECT_EQ(file->up, 1);
  EXPECT_NE(file->info.find("metre"), std::string::npos);
}

TEST(Formats, VtpKeepsEveryBitAndTheDerivedValues) {
  const auto file = parse_vtp(write_vtp(kCurves));
  ASSERT_TRUE(file);
  expect_state(*file);
  EXPECT_EQ(file->time, kFrame.t);
  EXPECT_EQ(file->point_data.at("tension_n"), kCurves.tension_n);
  EXPECT_EQ(file->point_data.at("slid_m"), kCurves.slid_m);
  EXPECT_EQ(file->point_data.at("arc_length_m"), kCurves.arc_length_m);
  EXPECT_EQ(file->point_data.at("radius_m"), std::vector<double>(7, 0.6e-3));
  EXPECT_EQ(file->point_data.at("yarn"), (std::vector<double>{0, 0, 0, 0, 1, 1, 1}));
  EXPECT_EQ(file->lines, (std::vector<std::vector<std::int64_t>>{{0, 1, 2, 3}, {4, 5, 6}}));
}

TEST(Formats, JsonKeepsEveryBit) {
  const auto json = nlohmann::json::parse(write_json(kCurves));
  EXPECT_EQ(json["frame"], 3);
  EXPECT_EQ(json["t_s"], kFrame.t);
  Curves<double> file;
  std::vector<double> arc, slid, tension;
  for (const auto& yarn : json["yarns"]) {
    file.curves.push_back(yarn["points_m"].get<std::vector<std::array<double, 3>>>());
    for (const double value : yarn["arc_length_m"]) arc.push_back(value);
    for (const double value : yarn["slid_m"]) slid.push_back(value);
    for (const double value : yarn["tension_n"]) tension.push_back(value);
  }
  expect_state(file);
  EXPECT_EQ(arc, kCurves.arc_length_m);
  EXPECT_EQ(slid, kCurves.slid_m);
  EXPECT_EQ(tension, kCurves.tension_n);
  EXPECT_TRUE(json["wrap_rad"][0][0].is_null());
  EXPECT_EQ(json["wrap_rad"][0][1], kCurves.wrap_rad[0][1]);
}

TEST(Formats, OneChangedBitOfTheStateShowsInEveryExactFile) {
  Frame changed = kFrame;
  changed.q[3 * 2] = std::nextafter(changed.q[3 * 2], 1.0);
  const CurveFrame curves = make_curve_frame(kHeader, changed, kStart);
  EXPECT_NE(write_obj(curves), write_obj(kCurves));
  EXPECT_NE(write_vtp(curves), write_vtp(kCurves));
  EXPECT_NE(write_json(curves), write_json(kCurves));
}

TEST(Formats, EmptyAndSinglePointYarnsStayReadable) {
  CurveFrame curves;
  curves.first = {0, 0, 1, 3};
  curves.points = {Vec3(1, 2, 3), Vec3(4, 5, 6), Vec3(7, 8, 9)};
  curves.arc_length_m = curves.slid_m = curves.tension_n = {0, 0, 0};
  const auto bcc = parse_bcc(write_bcc(curves));
  ASSERT_TRUE(bcc);
  EXPECT_EQ(bcc->curves.size(), 2u);
  const auto obj = parse_obj(write_obj(curves));
  ASSERT_TRUE(obj);
  EXPECT_EQ(obj->curves.size(), 1u);
  const auto vtp = parse_vtp(write_vtp(curves));
  ASSERT_TRUE(vtp);
  EXPECT_EQ(vtp->curves.size(), 3u);
}

TEST(Formats, PvdListsFilesWithTimes) {
  const std::vector<FrameFile> files{{"frame_000000.vtp", 0.0}, {"frame_000001.vtp", 1 / 30.0}};
  std::string text(kPvd.head);
  for (const FrameFile& file : files) text += kPvd.entry(file);
  const auto listed = parse_pvd(text + std::string(kPvd.foot));
  ASSERT_TRUE(listed);
  ASSERT_EQ(listed->size(), 2u);
  EXPECT_EQ((*listed)[1].first, 1 / 30.0);
  EXPECT_EQ((*listed)[1].second, "frame_000001.vtp");
}

TEST(Formats, TheTableAnswersForEveryName) {
  for (const char* name : {"obj", "bcc", "vtp", "json"}) {
    const Format* format = find_format(name);
    ASSERT_NE(format, nullptr) << name;
    EXPECT_EQ(format->name, name);
    EXPECT_FALSE(format->write(kCurves).empty());
  }
  for (const char* name : {"usda", "glb", "ply", "npz"}) {
    EXPECT_EQ(find_format(name), nullptr);
    const std::string error = format_error(name);
    EXPECT_NE(error.find("not supported yet"), std::string::npos) << error;
    EXPECT_NE(error.find("obj bcc vtp json"), std::string::npos) << error;
  }
  EXPECT_EQ(format_error("xyz").find("not supported yet"), std::string::npos);
  EXPECT_EQ(frame_file_name(*find_format("obj"), 12), "frame_000012.obj");
}

}  // namespace
}  // namespace slipstitch::test
