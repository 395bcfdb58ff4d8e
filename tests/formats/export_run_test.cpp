// SPDX-License-Identifier: MIT
#include "run_dir/export_run.h"

#include <gtest/gtest.h>

#include "formats/frame_exporter.h"
#include "run_dir/run_recorder.h"
#include "support/parsers/curves.h"
#include "support/sample_run.h"

namespace slipstitch::test {
namespace {

namespace fs = std::filesystem;

RunDir recorded_run(const TemporaryFolder& folder, int num_frames, bool end) {
  const RunDir dir = *create_run_dir(folder / "run", {}, "{}", false);
  RunRecorder recorder(dir);
  const RunHooks hooks = recorder.hooks();
  const FrameHeader header = sample_header();
  hooks.on_header(header);
  for (int index = 0; index < num_frames; ++index) hooks.on_frame(sample_frame(header, index));
  if (end) {
    EXPECT_TRUE(recorder.finish({}));
  }
  return dir;
}

int count_files(const fs::path& folder) { return static_cast<int>(std::distance(fs::directory_iterator(folder), {})); }

TEST(ExportRun, WritesTheFramesAskedFor) {
  const TemporaryFolder folder;
  const RunDir dir = recorded_run(folder, 8, true);
  ExportOptions options;
  options.first = 1;
  options.stride = 3;
  const Result<ExportReport> report = export_run(dir, folder / "out/obj", *find_format("obj"), options);
  ASSERT_TRUE(report) << report.error;
  EXPECT_EQ(report->frames, 3);
  EXPECT_TRUE(report->run_ended);
  EXPECT_EQ(count_files(folder / "out/obj"), 3);
  for (const int index : {1, 4, 7}) {
    const auto file = parse_obj(read_bytes(folder / "out/obj" / frame_file_name(*find_format("obj"), index)));
    ASSERT_TRUE(file);
    EXPECT_EQ(file->curves[0][0][0], sample_frame(sample_header(), index).q[0]);
  }
}

TEST(ExportRun, SlidingIsCountedFromFrameZeroWhateverComesFirst) {
  const TemporaryFolder folder;
  const RunDir dir = recorded_run(folder, 3, true);
  ExportOptions options;
  options.first = 2;
  ASSERT_TRUE(export_run(dir, folder / "out", *find_format("vtp"), options));
  const auto file = parse_vtp(read_bytes(folder / "out/frame_000002.vtp"));
  ASSERT_TRUE(file);
  const Frame start = sample_frame(sample_header(), 0), frame = sample_frame(sample_header(), 2);
  EXPECT_EQ(file->point_data.at("slid_m")[1], frame.q[19] - start.q[19]);
  const auto listed = parse_pvd(read_bytes(folder / "out/frames.pvd"));
  ASSERT_TRUE(listed);
  ASSERT_EQ(listed->size(), 1u);
  EXPECT_EQ((*listed)[0], std::pair(frame.t, std::string("frame_000002.vtp")));
}

TEST(ExportRun, OccupiedFoldersNeedForce) {
  const TemporaryFolder folder;
  const RunDir dir = recorded_run(folder, 1, true);
  fs::create_directories(folder / "out");
  write_bytes(folder / "out/mine.txt", "keep");
  EXPECT_FALSE(export_run(dir, folder / "out", *find_format("obj"), {}));
  EXPECT_EQ(count_files(folder / "out"), 1);
  ExportOptions options;
  options.force = true;
  EXPECT_TRUE(export_run(dir, folder / "out", *find_format("obj"), options));
  EXPECT_EQ(read_bytes(folder / "out/mine.txt"), "keep");
  EXPECT_FALSE(export_run(dir, folder / "out/mine.txt", *find_format("obj"), options));
}

TEST(ExportRun, AnUnfinishedRunGivesWhatThereIs) {
  const TemporaryFolder folder;
  const RunDir dir = recorded_run(folder, 2, false);
  const Result<ExportReport> report = export_run(dir, folder / "out", *find_format("bcc"), {});
  ASSERT_TRUE(report) << report.error;
  EXPECT_EQ(report->frames, 2);
  EXPECT_FALSE(report->run_ended);
}

TEST(ExportRun, RefusesWhatIsNotThereBeforeMakingAFolder) {
  const TemporaryFolder folder;
  const RunDir dir = recorded_run(folder, 2, true);
  for (const auto& [first, stride] : {std::pair{2, 1}, {-1, 1}, {0, 0}}) {
    ExportOptions options;
    options.first = first;
    options.stride = stride;
    EXPECT_FALSE(export_run(dir, folder / "out", *find_format("obj"), options)) << first << " " << stride;
  }
  fs::remove(dir.frames());
  EXPECT_FALSE(export_run(dir, folder / "out", *find_format("obj"), {}));
  EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST(ExportRun, AStudyHasNoFramesAndSaysWhereItsReportIs) {
  const TemporaryFolder folder;
  JobInfo job;
  job.study = StudyWork{};
  const RunDir dir = *create_run_dir(folder / "run", job, "{}", false);
  const Result<ExportReport> report = export_run(dir, folder / "out", *find_format("obj"), {});
  ASSERT_FALSE(report);
  EXPECT_NE(report.error.find("is a study, which has no frames"), std::string::npos) << report.error;
  EXPECT_NE(report.error.find(dir.report().string()), std::string::npos) << report.error;
  EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST(ExportRun, ABrokenFrameEndsTheExportBehindTheGoodOnes) {
  const TemporaryFolder folder;
  const RunDir dir = recorded_run(folder, 4, true);
  std::string bytes = read_bytes(dir.frames());
  char& in_frame_2 = bytes[bytes.size() - 40 - 240 - 10];
  in_frame_2 = static_cast<char>(in_frame_2 ^ 1);
  write_bytes(dir.frames(), bytes);
  const Result<ExportReport> report = export_run(dir, folder / "out", *find_format("vtp"), {});
  EXPECT_FALSE(report);
  EXPECT_NE(report.error.find("frame 2"), std::string::npos) << report.error;
  EXPECT_EQ(count_files(folder / "out"), 3);  // two frames and their list
  EXPECT_EQ(parse_pvd(read_bytes(folder / "out/frames.pvd"))->size(), 2u);
}

TEST(ExportRun, StopsWhenAskedAndStaysValid) {
  const TemporaryFolder folder;
  const RunDir dir = recorded_run(folder, 5, true);
  int asked = 0;
  ExportOptions options;
  options.should_stop = [&] { return ++asked > 2; };
  const Result<ExportReport> report = export_run(dir, folder / "out", *find_format("vtp"), options);
  ASSERT_TRUE(report) << report.error;
  EXPECT_EQ(report->frames, 2);
  EXPECT_EQ(parse_pvd(read_bytes(folder / "out/frames.pvd"))->size(), 2u);
}

TEST(FrameExporter, RefusesFramesOfAnotherTopology) {
  const TemporaryFolder folder;
  FrameExporter exporter(folder / "out", *find_format("obj"), false);
  Frame other = sample_frame(sample_header(), 0);
  other.q.conservativeResize(5);
  EXPECT_NE(exporter.begin(sample_header(), other), "");
  ASSERT_EQ(exporter.begin(sample_header(), sample_frame(sample_header(), 0)), "");
  EXPECT_NE(exporter.add(other), "");
}

TEST(FrameExporter, TheListIsWholeAfterEveryFrame) {
  const TemporaryFolder folder;
  const FrameHeader header = sample_header();
  fs::create_directories(folder / "out");
  write_bytes(folder / "out/frames.pvd", std::string(10'000, 'x'));  // of an earlier export
  FrameExporter exporter(folder / "out", *find_format("vtp"), true);
  ASSERT_EQ(exporter.begin(header, sample_frame(header, 0)), "");
  for (int index = 0; index < 12; ++index) {
    ASSERT_EQ(exporter.add(sample_frame(header, index)), "");
    const auto listed = parse_pvd(read_bytes(folder / "out/frames.pvd"));
    ASSERT_TRUE(listed) << index;
    ASSERT_EQ(listed->size(), static_cast<std::size_t>(index) + 1);
    EXPECT_EQ(listed->back(), std::pair(index / header.frames_per_s, frame_file_name(*find_format("vtp"), index)));
  }
  EXPECT_EQ(count_files(folder / "out"), 13);
}

TEST(ExportRun, TellsALogThatIsMissingFromOneThatHasNotBegun) {
  const TemporaryFolder folder;
  const RunDir ended = recorded_run(folder, 2, true);
  fs::remove(ended.frames());
  const Result<ExportReport> missing = export_run(ended, folder / "out", *find_format("obj"), {});
  EXPECT_NE(missing.error.find("frames.log is missing"), std::string::npos) << missing.error;
  fs::remove(ended.summary());
  const Result<ExportReport> early = export_run(ended, folder / "out", *find_format("obj"), {});
  EXPECT_NE(early.error.find("no frames yet"), std::string::npos) << early.error;
  EXPECT_FALSE(fs::exists(folder / "out"));
}

}  // namespace
}  // namespace slipstitch::test
