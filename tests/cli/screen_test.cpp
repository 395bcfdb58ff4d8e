// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "cli/screen/progress_bar.h"
#include "cli/screen/summary_text.h"
#include "cli/screen/text.h"

namespace slipstitch::test {
namespace {

TEST(Text, WritesNumbersForPeople) {
  EXPECT_EQ(thousands(0), "0");
  EXPECT_EQ(thousands(999), "999");
  EXPECT_EQ(thousands(1234567), "1,234,567");
  EXPECT_EQ(thousands(-1000), "-1,000");
  EXPECT_EQ(metres_text(0.00124), "1.24 mm");
  EXPECT_EQ(metres_text(-3.7e-5), "-37 um");
  EXPECT_EQ(bytes_text(412e6), "412 MB");
  EXPECT_EQ(bytes_text(1.26e9), "1.3 GB");
  EXPECT_EQ(duration_text(0.0421), "42 ms");
  EXPECT_EQ(duration_text(4.24), "4.2 s");
  EXPECT_EQ(duration_text(161), "2 min 41 s");
  EXPECT_EQ(duration_text(59.97), "1 min 00 s");
  EXPECT_EQ(duration_text(3840), "1 h 04 min");
  EXPECT_EQ(clock_text(83), "1:23");
  EXPECT_EQ(clock_text(3723), "1:02:03");
  EXPECT_EQ(percent_text(0.0), "0 %");
  EXPECT_EQ(percent_text(0.0004), "< 0.1 %");
  EXPECT_EQ(percent_text(0.0123), "1.2 %");
  EXPECT_EQ(percent_text(0.62), "62 %");
}

Progress sample_progress() {
  Progress progress;
  progress.t = 0.9416;
  progress.duration_s = 2.0;
  progress.steps = 1226;
  progress.newton_iterations = 4911;
  progress.residual = 8.123e-5;
  return progress;
}

TEST(ProgressLine, ShowsHowFarAndHowLong) {
  EXPECT_EQ(progress_line(sample_progress(), 83.0, 80),
            "[#####.......]  47 %  0.94/2 s  step 1,226  Newton 4,911  res 8.1e-05  ETA 1:23");
}

TEST(ProgressLine, FitsAnyTerminal) {
  for (int columns = 1; columns <= 120; ++columns) {
    const std::string line = progress_line(sample_progress(), 35000.0, columns);
    EXPECT_LE(line.size(), static_cast<std::size_t>(std::max(columns - 1, 1)));
    EXPECT_EQ(line.find("ETA 9:43:20") != std::string::npos, columns >= 34) << line;
  }
}

TEST(ShareLine, ShowsHowFarWhatAndHowLong) {
  EXPECT_EQ(share_line(0.47, "BDF2 8.33 ms", 83.0, 80), "[#####.......]  47 %  BDF2 8.33 ms  ETA 1:23");
  EXPECT_EQ(share_line(1.2, "BDF2 8.33 ms", {}, 80), "[############] 100 %  BDF2 8.33 ms");
  for (int columns = 1; columns <= 80; ++columns)
    EXPECT_LE(share_line(0.47, "BDF2 8.33 ms", 83.0, columns).size(),
              static_cast<std::size_t>(std::max(columns - 1, 1)));
  EXPECT_EQ(share_line(0.47, "BDF2 8.33 ms", 83.0, 40), "[#####.......]  47 %  BDF2 8.  ETA 1:23");
}

TEST(ProgressLine, NeverRunsOver) {
  Progress progress = sample_progress();
  progress.t = 3.0;
  EXPECT_TRUE(progress_line(progress, {}, 80).starts_with("[############] 100 %"));
  progress.duration_s = 0.0;
  EXPECT_TRUE(progress_line(progress, {}, 80).starts_with("[############] 100 %"));
}

TEST(SummaryText, ShowsWhatWasMeasuredAndNothingElse) {
  const auto text = summary_text(nlohmann::ordered_json::parse(R"({"status": "succeeded", "scene": "drape",
    "loops": 1600, "nodes": 6724, "dofs": 30016, "effects": ["inertia", "gravity"], "sim_time_s": 2.0, "wall_s": 161,
    "steps": 480, "rejected_steps": 3, "frames": 61, "newton_iterations": 1932, "residual": 9.1e-5,
    "residual_unit": "m/s", "max_slid_m": 0.00124, "mean_slid_m": 8e-5, "faded_wrap_share": 0.012,
    "faded_wrap_share_interior": 0, "wall_by_phase_s": {"assembly": 60, "factor": 90},
    "peak_memory_bytes": null, "linear_solver": "cholmod supernodal"})"));
  for (const char* part :
       {"drape: succeeded", "1,600 loops, 6,724 nodes, 30,016 unknowns", "inertia, gravity",
        "2 s in 480 steps (3 more rejected), 61 frames", "1,932 iterations, 4 a step", "largest residual 9.1e-05 m/s",
        "up to 1.24 mm, 80 um on average", "1.2 % faded", "0 % away from the edges", "2 min 41 s",
        "factor 56 %, assembly 37 %", "cholmod supernodal"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  }
  EXPECT_EQ(text.find("stretched"), std::string::npos);
  EXPECT_EQ(text.find("at most"), std::string::npos);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
}

TEST(SummaryText, TellsTheErrorAndFromWhereOnThatIsNotKept) {
  nlohmann::ordered_json json{{"status", "succeeded"}, {"scene", "x"}, {"error_estimate_m", nullptr}};
  EXPECT_EQ(summary_text(json).find("error"), std::string::npos);
  json["error_estimate_m"] = 3e-4;
  EXPECT_NE(summary_text(json).find("of positions at frames about 0.3 mm"), std::string::npos) << summary_text(json);
  EXPECT_EQ(summary_text(json).find("predictable"), std::string::npos);
  json["predictable_until_s"] = 0.25;
  EXPECT_NE(summary_text(json).find("not predictable to the tolerance beyond 0.25 s"), std::string::npos);
}

TEST(ProgressLine, TellsTheErrorWhereThereIsAnEstimate) {
  Progress progress = sample_progress();
  EXPECT_EQ(progress_line(progress, {}, 120).find("error"), std::string::npos);
  progress.error_estimate_m = 3e-4;
  EXPECT_NE(progress_line(progress, {}, 120).find("error ~0.3 mm"), std::string::npos);
}

TEST(ProgressLine, TellsTheBudget) {
  Progress progress = sample_progress();
  progress.wall_s = 6.0;
  progress.budget_s = 20.0;
  EXPECT_NE(progress_line(progress, {}, 120).find("6.0 s of 20.0 s"), std::string::npos) << progress_line(progress, {}, 120);
}

TEST(SummaryText, TellsWhatABudgetWasGoodFor) {
  nlohmann::ordered_json json{{"status", "succeeded"}, {"scene", "x"}, {"wall_s", 19.5}, {"budget", nullptr}};
  EXPECT_EQ(summary_text(json).find("budget"), std::string::npos);
  json["budget"] = {{"budget_s", 20.0}, {"kept", true}, {"same_tolerance_m", 1e-4}, {"loosest_tolerance_m", 5e-3},
                    {"share_at_loosest", 0.0}};
  EXPECT_NE(summary_text(json).find("19.5 s of 20.0 s, as a tolerance of about 0.1 mm takes\n"), std::string::npos)
      << summary_text(json);
  json["wall_s"] = 40.0;
  json["budget"]["kept"] = false;
  json["budget"]["share_at_loosest"] = 1.0;
  EXPECT_NE(summary_text(json).find("not kept: it goes no looser than to 5 mm, at which 100 % of the motion ran"),
            std::string::npos)
      << summary_text(json);
}

TEST(SummaryText, SaysWhatWasLeftOutAndThatItIsNoGuarantee) {
  nlohmann::ordered_json json{{"status", "succeeded"}, {"scene", "x"}};
  auto& choice = json["effect_choice"];
  choice = {{"window_s", 0.1}, {"tolerance_m", 5e-4}, {"wall_s", 1.0}, {"verdicts", nlohmann::ordered_json::array()}};
  EXPECT_NE(summary_text(json).find("left out  nothing; as seen in the first 0.1 s"), std::string::npos);
  choice["verdicts"] = {{{"effect", "air_drag"}, {"kept", false}, {"why", "does not matter"}, {"difference_m", 2e-4}},
                        {{"effect", "gravity"}, {"kept", true}, {"why", "matters"}, {"difference_m", 2e-2}},
                        {{"effect", "colliders"}, {"kept", false}, {"why", "cannot act"}, {"difference_m", nullptr}}};
  const std::string text = summary_text(json);
  for (const char* part : {"air_drag: does not matter (0.2 mm)\n", "colliders: cannot act\n", "first 0.1 s, to 0.5 mm",
                           "no guarantee"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  EXPECT_EQ(text.find("gravity"), std::string::npos) << text;
}

TEST(SummaryText, TellsOfYarnThatOverlappedAtTheStart) {
  nlohmann::ordered_json json{{"status", "succeeded"}, {"scene", "x"}, {"self_collision_start_overlaps", 0}};
  EXPECT_EQ(summary_text(json).find("overlap"), std::string::npos);
  json["self_collision_start_overlaps"] = 3;
  EXPECT_NE(summary_text(json).find("3 pairs of segments overlapped at the start"), std::string::npos);
}

TEST(SummaryText, ShowsTheForcesOfAFewHandles) {
  nlohmann::ordered_json json{{"status", "succeeded"}, {"scene", "x"}, {"handles", nlohmann::ordered_json::array()}};
  const auto lines_with_handles = [&] {
    const std::string text = summary_text(json);
    return std::count(text.begin(), text.end(), '\n') - 1;
  };
  EXPECT_EQ(lines_with_handles(), 0);
  for (int i = 1; i <= 6; ++i) {
    json["handles"].push_back(
        {{"reaction_n", {0.3, -0.4, 0.0}}, {"max_reaction_n", 1.25}, {"max_reaction_t_s", 0.7}});
    EXPECT_EQ(lines_with_handles(), std::min(i, 4)) << summary_text(json);
  }
  for (const char* part : {"handle 2", "0.5 N at the end, 1.25 N at most (at 0.7 s)", "3 more handles"})
    EXPECT_NE(summary_text(json).find(part), std::string::npos) << summary_text(json);
  json["handles"] = {{{"reaction_n", {nullptr, nullptr, nullptr}}, {"max_reaction_n", nullptr}}};
  EXPECT_EQ(lines_with_handles(), 0);
}

TEST(SummaryText, ShowsWhereBodiesEnd) {
  nlohmann::ordered_json json{{"status", "succeeded"}, {"scene", "x"}, {"bodies", nlohmann::ordered_json::array()}};
  for (int i = 0; i < 5; ++i)
    json["bodies"].push_back(
        {{"collider", i}, {"position_m", {0.1, -0.25, 0.0}}, {"velocity_m_per_s", {3.0, 0.0, 4.0}}});
  for (const char* part : {"body 2", "ends at 0.1, -0.25, 0 m with 5 m/s", "2 more bodies in the JSON summary"})
    EXPECT_NE(summary_text(json).find(part), std::string::npos) << summary_text(json);
  EXPECT_EQ(summary_text(json).find("body 3"), std::string::npos);
  json["bodies"] = {{{"position_m", {nullptr, nullptr, nullptr}}, {"velocity_m_per_s", {1.0, 0.0, 0.0}}}};
  EXPECT_EQ(summary_text(json), "x: succeeded\n");
}

TEST(SummaryText, TakesASummaryWithNothingMeasured) {
  EXPECT_EQ(summary_text({{"status", "failed"}, {"scene", "x"}, {"wall_s", nullptr}, {"effects", nullptr}}),
            "x: failed\n");
}

}  // namespace
}  // namespace slipstitch::test
