// SPDX-License-Identifier: MIT
#include "cli/screen/study_table.h"

#include <sstream>

#include "cli/screen/text.h"
#include "report/study_columns.h"
#include "report/study_text.h"

namespace slipstitch {
namespace {

/// A heading over the rows of every method.
std::string columns_table(const WorkPrecision& study, std::span<const StudyColumn> columns, const std::string& name) {
  std::vector<std::vector<std::string>> rows{{name}};
  std::vector<std::string> methods{""};
  for (const StudyColumn& column : columns)
    if (!column.wide && is_shown(column, study)) rows[0].push_back(column.title);
  for (const RungResult& result : study.rungs) {
    if (!result.no_result.empty()) continue;
    methods.push_back(result.rung.method);
    auto& row = rows.emplace_back();
    row.push_back((result.on_front ? "* " : "  ") + result.rung.label);
    for (const StudyColumn& column : columns)
      if (!column.wide && is_shown(column, study)) row.push_back(column.text(result, study));
  }
  std::istringstream lines(table(rows));
  std::string text, line;
  for (std::size_t i = 0; std::getline(lines, line); ++i) {
    if (i > 0 && methods[i] != methods[i - 1]) text += methods[i] + "\n";
    text += line + "\n";
  }
  return text;
}

}  // namespace

std::string study_table(const WorkPrecision& study) {
  std::string text = wrapped(study.scene + ":", about_study(study)) + "\n" +
                     columns_table(study, study_position_columns(), "positions") + "\n" +
                     columns_table(study, study_other_columns(), "others") + "\n" +
                     wrapped("  *:",
                             "nothing that was run is both faster and more accurate. ~: error below three times the "
                             "reference's own. e: the baseline's time to that error is extrapolated.");
  for (const std::string& sentence :
       {about_reference(study), about_horizon(study), about_worst_place(study), about_digits(study)})
    if (!sentence.empty()) text += wrapped("  -", sentence);
  for (const std::string& reason : without_result(study)) text += wrapped("  -", reason);
  return text;
}

}  // namespace slipstitch
