// SPDX-License-Identifier: MIT
#include "run_dir/history_csv.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/sample_run.h"

namespace slipstitch::test {
namespace {

constexpr char kColumns[] =
    "frame,t_s,steps,rejected_steps,newton_iterations,linear_iterations,step_s,residual,error_estimate_m,kinetic_j,"
    "gravity_j,stretch_j\n";

FrameReport start() {
  FrameReport report;
  report.energy_j = {{"stretch", 0.5}, {"kinetic", std::nullopt}, {"gravity", std::nullopt}};
  return report;
}

TEST(HistoryCsv, HasEmptyCellsForWhatWasNotMeasured) {
  const TemporaryFolder folder;
  Result<HistoryCsv> csv = HistoryCsv::create(folder.path(), start());
  ASSERT_TRUE(csv) << csv.error;
  EXPECT_EQ(csv->append(start()), "");
  FrameReport next = start();
  next = {1, 0.1, 12, 1, 34, 56, 1e-3, 1.0 / 3.0, 1e-6, {{"kinetic", 1e-9}, {"gravity", NAN}, {"other", 1.0}}};
  EXPECT_EQ(csv->append(next), "");
  EXPECT_EQ(read_bytes(folder / "history.csv"), std::string(kColumns) +
                                                    "0,0,0,0,0,0,,,,,,0.5\n"
                                                    "1,0.1,12,1,34,56,0.001,0.3333333333333333,1e-06,1e-09,,\n");
}

TEST(HistoryCsv, TellsWhereItCannotBeWritten) {
  const TemporaryFolder folder;
  const Result<HistoryCsv> csv = HistoryCsv::create(folder / "nothing", start());
  EXPECT_FALSE(csv);
  EXPECT_NE(csv.error.find("history.csv"), std::string::npos) << csv.error;
}

}  // namespace
}  // namespace slipstitch::test
