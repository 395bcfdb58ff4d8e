// SPDX-License-Identifier: MIT
#include "run_dir/run_json.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

namespace slipstitch::test {
namespace {

RunSummary full_summary() {
  RunSummary summary;
  summary.status = RunStatus::cancelled;
  summary.message = "stitch 3 \"x\"";
  summary.scene = "drape";
  summary.loops = 1;
  summary.nodes = 2;
  summary.dofs = 3;
  summary.nonzeros = 17;
  summary.effects = {"stretch", "bending"};
  summary.effect_cost = {{"stretch", {5, 10, 20, 30, 40, 50}}};
  summary.effect_choice = EffectChoice{0.1, 5e-4, 2.5, {{"wind", false, "none", 1e-6}, {"inertia", true, "always", {}}}};
  summary.sim_time_s = 0.1;
  summary.wall_s = 1.0 / 3.0;
  summary.frames = 4;
  summary.steps = 5'000'000'000;
  summary.rejected_steps = 6;
  summary.newton_iterations = 7;
  summary.linear_iterations = 8;
  summary.factorizations = 9;
  summary.cg_iterations = 7;
  summary.convex_hessians = 10;
  summary.wall_by_phase_s = {{"assemble", 0.25}};
  summary.energy_j = {{"kinetic", 1e-9}, {"stretch", 2e-9}};
  summary.residual = 1e-5;
  summary.residual_unit = "m/s";
  summary.error_estimate_m = 0.0;
  summary.predictable_until_s = 0.25;
  summary.budget = BudgetReport{60.0, true, 1e-4, 5e-3, 0.25};
  summary.min_arc_gap_ratio = 0.5;
  summary.max_stretch = 1.01;
  summary.max_slid_m = 1e-4;
  summary.mean_slid_m = 1e-5;
  summary.faded_wrap_share = 0.1;
  summary.faded_wrap_share_interior = 0.0;
  summary.wrap_ridge_entries = 0;
  summary.wrap_fade_entries = 7;
  summary.crushed_entries = 3;
  summary.self_collision_start_overlaps = 2;
  summary.handles = {{Vec3(1.0, -2.0, 0.25), 3.0, 0.5}, {}};
  summary.bodies = {{2, Vec3(0.5, -0.25, 0.0), Vec3(1.0, 2.0, -3.0)}};
  summary.peak_memory_bytes = 123;
  summary.state_hash = "ab";
  summary.linear_solver = "cholmod";
  summary.blas = "Haswell";
  summary.version = "0.1.0";
  summary.threads = 2;
  return summary;
}

TEST(RunJson, SummaryHasThePromisedKeys) {
  std::set<std::string> keys;
  const auto json = to_json(RunSummary{});
  for (const auto& [key, value] : json.items()) keys.insert(key);
  const std::set<std::string> promised{"status",
                                       "scene",
                                       "loops",
                                       "nodes",
                                       "dofs",
                                       "effects",
                                       "sim_time_s",
                                       "wall_s",
                                       "steps",
                                       "rejected_steps",
                                       "newton_iterations",
                                       "linear_iterations",
                                       "factorizations",
                                       "wall_by_phase_s",
                                       "energy_j",
                                       "residual",
                                       "error_estimate_m",
                                       "min_arc_gap_ratio",
                                       "max_stretch",
                                       "peak_memory_bytes",
                                       "state_hash",
                                       "linear_solver",
                                       "blas",
                                       "threads",
                                       "version"};
  for (const std::string& key : promised) EXPECT_TRUE(keys.contains(key)) << key;
  const std::set<std::string> extra{
      "message",     "frames",           "convex_hessians",           "residual_unit",      "max_slid_m",
      "mean_slid_m", "faded_wrap_share", "faded_wrap_share_interior", "wrap_ridge_entries", "wrap_fade_entries", "crushed_entries", "handles",
      "bodies",      "effect_cost", "effect_choice",
      "nonzeros",    "self_collision_start_overlaps", "cg_iterations", "predictable_until_s",
      "budget"};
  EXPECT_EQ(keys.size(), promised.size() + extra.size());
  for (const std::string& key : extra) EXPECT_TRUE(keys.contains(key)) << key;
}

TEST(RunJson, SummaryNamesItsMembersInTheStruct) {
  const auto json = to_json(full_summary());
  EXPECT_EQ(json["status"], "cancelled");
  EXPECT_EQ(json["steps"], 5'000'000'000);
  EXPECT_EQ(json["wall_s"], 1.0 / 3.0);
  EXPECT_EQ(json["energy_j"]["kinetic"], 1e-9);
  EXPECT_EQ(json["effects"][1], "bending");
  EXPECT_EQ(json["threads"], 2);
  EXPECT_EQ(json["effect_cost"].dump(), R"({"stretch":{"dofs":5,"stencils":10,"bytes":20,"nonzeros":30,"evaluations":40,"searches":50}})");
  EXPECT_EQ(json["effect_choice"].dump(),
            R"({"window_s":0.1,"tolerance_m":0.0005,"wall_s":2.5,"verdicts":[)"
            R"({"effect":"wind","kept":false,"why":"none","difference_m":1e-06},)"
            R"({"effect":"inertia","kept":true,"why":"always","difference_m":null}]})");
  EXPECT_EQ(json["budget"].dump(), R"({"budget_s":60.0,"kept":true,"same_tolerance_m":0.0001,)"
                                   R"("loosest_tolerance_m":0.005,"share_at_loosest":0.25})");
  EXPECT_TRUE(to_json(RunSummary{})["budget"].is_null());
  EXPECT_EQ(json["handles"][0].dump(), R"({"reaction_n":[1.0,-2.0,0.25],"max_reaction_n":3.0,"max_reaction_t_s":0.5})");
  EXPECT_EQ(json["handles"][1].dump(),
            R"({"reaction_n":[null,null,null],"max_reaction_n":null,"max_reaction_t_s":null})");
}

TEST(RunJson, SummaryNamesDynamicColliders) {
  EXPECT_EQ(to_json(full_summary())["bodies"].dump(),
            R"([{"collider":2,"position_m":[0.5,-0.25,0.0],"velocity_m_per_s":[1.0,2.0,-3.0]}])");
  EXPECT_EQ(to_json(RunSummary{})["bodies"].dump(), "[]");
}

TEST(RunJson, NotMeasuredIsNullAndZeroIsZero) {
  for (const char* key : {"error_estimate_m", "min_arc_gap_ratio", "max_stretch", "max_slid_m", "mean_slid_m",
                          "faded_wrap_share", "faded_wrap_share_interior", "wrap_ridge_entries", "wrap_fade_entries", "crushed_entries", "self_collision_start_overlaps", "peak_memory_bytes"}) {
    EXPECT_TRUE(to_json(RunSummary{})[key].is_null()) << key;
    EXPECT_TRUE(to_json(full_summary())[key].is_number()) << key;
  }
  RunSummary summary;
  summary.residual = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(to_json(summary)["residual"].is_null());
}

TEST(RunJson, OfAFabricThatWasNotMadeNothingIsTold) {
  RunSummary summary;
  summary.status = RunStatus::cancelled;
  summary.wall_s = 2.0;
  const auto json = to_json(summary);
  for (const char* key :
       {"loops", "nodes", "dofs", "nonzeros", "effects", "residual_unit", "linear_solver", "state_hash"})
    EXPECT_TRUE(json[key].is_null()) << key;
  EXPECT_EQ(json["wall_s"], 2.0);
  summary.nodes = 5;
  EXPECT_EQ(to_json(summary)["loops"], 0) << "of bare yarns";
}

TEST(RunJson, SummaryComesBack) {
  for (const RunSummary& summary : {full_summary(), RunSummary{}}) {
    const Result<RunSummary> read = summary_from_json(to_json(summary).dump());
    ASSERT_TRUE(read) << read.error;
    EXPECT_EQ(to_json(*read), to_json(summary));
  }
}

TEST(RunJson, StatusWordsAreLowerCase) {
  for (const auto& [status, word] :
       {std::pair{RunStatus::succeeded, "succeeded"}, std::pair{RunStatus::failed, "failed"},
        std::pair{RunStatus::cancelled, "cancelled"}}) {
    EXPECT_EQ(status_word(status), word);
    EXPECT_EQ(status_from_word(word), status);
  }
  EXPECT_FALSE(status_from_word("SUCCEEDED"));
}

TEST(RunJson, BrokenTextIsRefusedWithTheKey) {
  EXPECT_FALSE(summary_from_json("{"));
  EXPECT_FALSE(summary_from_json("[]"));
  auto json = to_json(full_summary());
  json["loops"] = "three";
  EXPECT_NE(summary_from_json(json.dump()).error.find("loops"), std::string::npos);
  json = to_json(full_summary());
  json.erase("energy_j");
  EXPECT_NE(summary_from_json(json.dump()).error.find("energy_j"), std::string::npos);
  json = to_json(full_summary());
  json["effect_cost"]["stretch"]["bytes"] = "many";
  EXPECT_NE(summary_from_json(json.dump()).error.find("effect_cost"), std::string::npos);
  json = to_json(full_summary());
  json["handles"][0]["reaction_n"] = {1.0, 2.0, 3.0, 4.0};
  EXPECT_NE(summary_from_json(json.dump()).error.find("handles"), std::string::npos);
  json = to_json(full_summary());
  json["status"] = "SUCCEEDED";
  EXPECT_FALSE(summary_from_json(json.dump()));
  json = to_json(full_summary());
  json["added_later"] = 1;
  EXPECT_TRUE(summary_from_json(json.dump()));
}

TEST(RunJson, ABudgetSaysWhatIsToGoWhileThatIsLeft) {
  Progress progress;
  progress.t = 0.5;
  progress.duration_s = 2.0;
  progress.wall_s = 3.0;
  progress.budget_s = 10.0;
  EXPECT_EQ(estimate_eta(progress), 7.0);
  EXPECT_EQ(progress_from_json(to_json(progress_info(progress)).dump())->progress.budget_s, 10.0);
  progress.wall_s = 12.0;
  EXPECT_EQ(estimate_eta(progress), 36.0);
}

TEST(RunJson, JobProgressAndWorkerComeBack) {
  const JobInfo job{"simJobs/a", "r", "h", 3, "SkylakeX", "2024-05-01T00:00:00.000001Z", "drape"};
  EXPECT_EQ(to_json(*job_from_json(to_json(job).dump())), to_json(job));
  const ProgressInfo progress{
      {0.5, 2.0, 16, 61, 100, 300, 0.005, 1e-5, 3.0}, 9.0, "2024-05-01T00:00:00.000001Z", 0.25, "simulating"};
  EXPECT_EQ(to_json(*progress_from_json(to_json(progress).dump())), to_json(progress));
  EXPECT_EQ(to_json(progress)["duration_s"], 2.0);
  const WorkerInfo worker{4'000'000, ~std::uint64_t{0}, "b", "local:1"};
  const Result<WorkerInfo> read = worker_from_json(to_json(worker).dump());
  ASSERT_TRUE(read) << read.error;
  EXPECT_EQ(read->start_ticks, worker.start_ticks);
  EXPECT_EQ(read->pid, worker.pid);
}

TEST(RunJson, AStudyKeepsItsWork) {
  JobInfo job;
  EXPECT_FALSE(job_from_json(to_json(job).dump())->study);
  job.study = StudyWork{true, 60.0};
  EXPECT_EQ(job_from_json(to_json(job).dump())->study, job.study);
}

TEST(RunJson, ReadsWhatWasWrittenBeforeThereWereStudies) {
  auto job = to_json(JobInfo{});
  job.erase("study");
  ASSERT_TRUE(job_from_json(job.dump()));
  EXPECT_FALSE(job_from_json(job.dump())->study);
  auto progress = to_json(ProgressInfo{{0.5, 2.0, 16, 61, 100, 300, 0.005, 1e-5, {}, 3.0}, {}, ""});
  progress.erase("share_done");
  progress.erase("doing");
  ASSERT_TRUE(progress_from_json(progress.dump()));
  EXPECT_EQ(progress_from_json(progress.dump())->share_done, 0.25);
}

TEST(RunJson, TheShareIsOfTimeOrOfFramesWhereThereIsNone) {
  EXPECT_EQ(share_done({0.5, 2.0, 1, 4, 0, 0, 0.0, 0.0, {}, 0.0}), 0.25);
  EXPECT_EQ(share_done({3.0, 2.0, 1, 4, 0, 0, 0.0, 0.0, {}, 0.0}), 1.0);
  EXPECT_EQ(share_done({0.0, 0.0, 1, 2, 0, 0, 0.0, 0.0, {}, 0.0}), 0.5);
  EXPECT_EQ(share_done({}), 0.0);
}

TEST(RunJson, ASummaryOfAStudyHasEveryKeyAndNothingThatWasNotMeasured) {
  StudySummary summary;
  summary.status = RunStatus::succeeded;
  summary.scene = "swing";
  summary.wall_s = 2.0;
  summary.study = {{"finished", true}};
  const auto json = to_json(summary), run = to_json(RunSummary{});
  for (const auto& [key, value] : run.items()) EXPECT_TRUE(json.contains(key)) << key;
  for (const char* key : {"steps", "dofs", "error_estimate_m", "peak_memory_bytes"})
    EXPECT_TRUE(json[key].is_null()) << key;
  EXPECT_EQ(json["status"], "succeeded");
  EXPECT_EQ(json["wall_s"], 2.0);
  EXPECT_EQ(json["study"]["finished"], true);
}

TEST(RunJson, EtaFollowsTheShareOfSimulatedTime) {
  Progress progress;
  progress.duration_s = 2.0;
  progress.wall_s = 3.0;
  EXPECT_FALSE(estimate_eta(progress));
  progress.t = 0.5;
  EXPECT_EQ(estimate_eta(progress), 9.0);
  progress.before_s = 2.0;  // what came before the simulation does not come again
  EXPECT_EQ(estimate_eta(progress), 3.0);
}

TEST(RunJson, TimesAreRfc3339) {
  const std::string now = utc_now();
  ASSERT_EQ(now.size(), std::string("2024-05-01T00:00:00.000001Z").size());
  EXPECT_EQ(now[10], 'T');
  EXPECT_EQ(now.back(), 'Z');
}

}  // namespace
}  // namespace slipstitch::test
