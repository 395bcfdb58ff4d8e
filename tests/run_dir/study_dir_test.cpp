// SPDX-License-Identifier: MIT
#include "run_dir/study_dir.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/sample_run.h"

namespace slipstitch::test {
namespace {

StudyIdentity sample_identity() { return {"0123abcd", "drape", "0.1.0", "OpenBLAS Haswell, 1 thread", 1}; }

KeptRun sample_kept_run() {
  const FrameHeader header = sample_header();
  KeptRun run;
  run.summary.status = RunStatus::succeeded;
  run.summary.scene = "drape";
  run.summary.steps = 17;
  run.summary.newton_iterations = 99;
  run.summary.error_estimate_m = 0.1 / 3.0;
  run.wall_s = {1.0 / 3.0, 0.7};
  run.memory_bytes = 1e6;
  for (int k = 0; k < 3; ++k) {
    run.trace.t.push_back(k / 30.0);
    run.trace.x.emplace_back(sample_frame(header, k).q.head(18));
    run.trace.stored_j.push_back(1e-6 / (k + 3));
    run.trace.force_n.push_back(k == 1 ? std::nan("") : 1.0 / (k + 7));
    run.trace.length_m.push_back(0.1 * k);
  }
  return run;
}

class StudyFolder : public ::testing::Test {
 protected:
  StudyDir dir(const StudyIdentity& identity = sample_identity()) const { return {folder_ / "study", identity}; }
  std::filesystem::path only(const std::string& extension) const {
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / "study" / "runs"))
      if (entry.path().extension() == extension) return entry.path();
    return {};
  }

  TemporaryFolder folder_;
};

TEST_F(StudyFolder, GivesBackWhatItKeeps) {
  StudyDir study = dir();
  ASSERT_EQ(study.why_refused(), "");
  ASSERT_EQ(study.prepare(), "");
  EXPECT_FALSE(study.find("BDF2 step 1"));
  const KeptRun kept = sample_kept_run();
  ASSERT_EQ(study.keep("BDF2 step 1", kept), "");
  EXPECT_EQ(study.num_runs(), 1);
  StudyDir later = dir();
  EXPECT_EQ(later.why_refused(), "");
  const std::optional<KeptRun> found = later.find("BDF2 step 1");
  ASSERT_TRUE(found);
  EXPECT_FALSE(later.find("BDF2 step 2"));
  EXPECT_EQ(found->wall_s, kept.wall_s);
  EXPECT_EQ(found->memory_bytes, kept.memory_bytes);
  EXPECT_EQ(found->summary.status, RunStatus::succeeded);
  EXPECT_EQ(found->summary.newton_iterations, 99);
  EXPECT_EQ(found->summary.error_estimate_m, kept.summary.error_estimate_m);
  EXPECT_EQ(found->trace.t, kept.trace.t);
  EXPECT_EQ(found->trace.x, kept.trace.x);  // bit for bit
  EXPECT_EQ(found->trace.stored_j, kept.trace.stored_j);
  EXPECT_TRUE(std::isnan(found->trace.force_n[1]));
  EXPECT_EQ(found->trace.force_n[2], kept.trace.force_n[2]);
  EXPECT_EQ(found->trace.length_m, kept.trace.length_m);
}

TEST_F(StudyFolder, KeepsARunThatNeverBegan) {
  StudyDir study = dir();
  ASSERT_EQ(study.prepare(), "");
  KeptRun failed;
  failed.summary.message = "could not be relaxed";
  failed.wall_s = {0.1};
  ASSERT_EQ(study.keep("a", failed), "");
  const std::optional<KeptRun> found = study.find("a");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->summary.status, RunStatus::failed);
  EXPECT_EQ(found->trace.size(), 0U);
}

TEST_F(StudyFolder, DoesNotFindWhatIsDamaged) {
  StudyDir study = dir();
  ASSERT_EQ(study.prepare(), "");
  const auto kept_then = [&](const std::string& extension, auto damage) {
    EXPECT_EQ(study.keep("a", sample_kept_run()), "");
    EXPECT_TRUE(study.find("a"));
    const std::filesystem::path file = only(extension);
    std::string bytes = read_bytes(file);
    damage(bytes);
    write_bytes(file, bytes);
    return study.find("a");
  };
  EXPECT_FALSE(kept_then(".frames", [](std::string& bytes) { bytes[100] ^= 1; }));
  EXPECT_FALSE(kept_then(".frames", [](std::string& bytes) { bytes.pop_back(); }));
  EXPECT_FALSE(kept_then(".frames", [](std::string& bytes) { bytes.clear(); }));
  EXPECT_FALSE(kept_then(".frames", [](std::string& bytes) { bytes += "x"; }));
  EXPECT_FALSE(kept_then(".json", [](std::string& bytes) { bytes.resize(bytes.size() / 2); }));
  EXPECT_FALSE(kept_then(".json", [](std::string& bytes) { bytes = R"({"run": "a"})"; }));
  EXPECT_FALSE(kept_then(
      ".json", [](std::string& bytes) { bytes.replace(bytes.find("\"stored_j\":["), 12, "\"stored_j\":[1,"); }));
  EXPECT_FALSE(kept_then(".json", [](std::string& bytes) { bytes.replace(bytes.find("\"a\""), 3, "\"b\""); }));
  EXPECT_EQ(study.keep("a", sample_kept_run()), "");
  std::filesystem::remove(only(".frames"));
  EXPECT_FALSE(study.find("a"));
}

TEST_F(StudyFolder, RefusesFoldersOfOthersAndSaysWhy) {
  ASSERT_EQ(dir().prepare(), "");
  ASSERT_EQ(dir().keep("a", sample_kept_run()), "");
  const auto refused_with = [&](auto change) {
    StudyIdentity identity = sample_identity();
    change(identity);
    EXPECT_FALSE(dir(identity).find("a"));
    return dir(identity).why_refused();
  };
  using Id = StudyIdentity;
  EXPECT_NE(refused_with([](Id& id) { id.scene_hash = "ff", id.scene_name = "curl"; }).find("another scene, 'drape'"),
            std::string::npos);
  EXPECT_NE(refused_with([](Id& id) { id.scene_hash = "ff"; }).find("other contents"), std::string::npos);
  EXPECT_NE(refused_with([](Id& id) { id.version = "0.2.0"; }).find("version 0.1.0"), std::string::npos);
  EXPECT_NE(refused_with([](Id& id) { id.threads = 2; }).find("threads 1"), std::string::npos);
  EXPECT_NE(refused_with([](Id& id) { id.blas = "other"; }).find("OpenBLAS Haswell"), std::string::npos);
  StudyDir elsewhere(folder_.path(), sample_identity());
  EXPECT_NE(elsewhere.why_refused().find("not empty"), std::string::npos);
  write_bytes(folder_ / "file", "x");
  EXPECT_NE(StudyDir(folder_ / "file", sample_identity()).why_refused().find("not a folder"), std::string::npos);
}

TEST_F(StudyFolder, TakesTheFolderOfAnotherStudyAndLeavesTheRestAlone) {
  ASSERT_EQ(dir().prepare(), "");
  ASSERT_EQ(dir().keep("a", sample_kept_run()), "");
  write_bytes(folder_ / "study" / "runs" / "mine.json", "x");
  StudyIdentity other = sample_identity();
  other.scene_hash = "ff";
  ASSERT_EQ(dir(other).prepare(), "");
  EXPECT_EQ(dir(other).why_refused(), "");
  EXPECT_NE(dir().why_refused(), "");
  EXPECT_EQ(dir(other).num_runs(), 0);
  EXPECT_EQ(only(".json").filename(), "mine.json");
  EXPECT_EQ(only(".frames"), "");
  StudyDir foreign(folder_ / "foreign", sample_identity());
  std::filesystem::create_directories(folder_ / "foreign" / "runs");
  write_bytes(folder_ / "foreign" / "runs" / "0123456789abcdef.json", "x");
  ASSERT_EQ(foreign.prepare(), "");  // was no study
  EXPECT_EQ(read_bytes(folder_ / "foreign" / "runs" / "0123456789abcdef.json"), "x");
}

TEST_F(StudyFolder, NamesWhatItCannotWrite) {
  write_bytes(folder_ / "file", "x");
  EXPECT_NE(StudyDir(folder_ / "file" / "study", sample_identity()).prepare().find("cannot make"), std::string::npos);
  StudyDir study = dir();
  ASSERT_EQ(study.prepare(), "");
  std::filesystem::remove_all(folder_ / "study" / "runs");
  EXPECT_NE(study.keep("a", sample_kept_run()), "");
}

}  // namespace
}  // namespace slipstitch::test
