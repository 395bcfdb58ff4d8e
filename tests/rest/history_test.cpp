// SPDX-License-Identifier: MIT
#include <sstream>

#include "rest_fixture.h"

namespace slipstitch::test {
namespace {

std::vector<std::vector<std::string>> rows_of(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream cells(line + ",");
    auto& row = rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
  }
  return rows;
}

class HistoryTest : public RestTest {};

TEST_F(HistoryTest, HasARowForEveryFrame) {
  start_rest();
  const std::string name = must_create(swing(3, 0.5, 10.0, 1e-2)).name();
  const Json summary = Json::parse(wait_for_end(name).summary_json());
  const HttpAnswer answer = call("GET", path_of(name) + "/artefacts/history.csv");
  EXPECT_EQ(answer.header("content-type"), "text/csv; charset=utf-8");
  const auto rows = rows_of(answer.body);
  ASSERT_EQ(rows.size(), 7U);
  const std::vector<std::string> first{"frame",
                                       "t_s",
                                       "steps",
                                       "rejected_steps",
                                       "newton_iterations",
                                       "linear_iterations",
                                       "step_s",
                                       "residual",
                                       "error_estimate_m",
                                       "kinetic_j"};
  ASSERT_GE(rows[0].size(), first.size());
  EXPECT_EQ(std::vector<std::string>(rows[0].begin(), rows[0].begin() + 10), first);
  for (const char* term : {"gravity_j", "stretch_j"}) {
    EXPECT_NE(std::find(rows[0].begin(), rows[0].end(), term), rows[0].end()) << term;
  }
  for (std::size_t i = 1; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].size(), rows[0].size());
    EXPECT_EQ(rows[i][0], std::to_string(i - 1));
  }
  EXPECT_EQ(rows[1][6] + rows[1][7] + rows[1][8], "") << "nothing is measured before the first step";
  EXPECT_EQ(std::stol(rows[6][2]), summary["steps"].get<long>());
  EXPECT_EQ(std::stol(rows[6][4]), summary["newton_iterations"].get<long>());
  for (std::size_t column = 9; column < rows[0].size(); ++column) {
    const std::string term = rows[0][column].substr(0, rows[0][column].size() - 2);
    if (rows[6][column].empty()) continue;
    EXPECT_NEAR(std::stod(rows[6][column]), summary["energy_j"][term].get<double>(), 1e-12) << term;
  }
}

// While the job runs, for as many frames as there are.
TEST_F(HistoryTest, GrowsWithTheRun) {
  start_rest();
  const std::string name = must_create(endless_swing()).name();
  wait_for_frames(name, 5);
  const HttpAnswer answer = call("GET", path_of(name) + "/artefacts/history.csv");
  EXPECT_TRUE(answer.complete);
  EXPECT_GE(rows_of(answer.body).size(), 5U);
}

}  // namespace
}  // namespace slipstitch::test
