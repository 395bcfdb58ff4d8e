// SPDX-License-Identifier: MIT
#include "report/study_columns.h"
#include "report/study_report.h"
#include "report/study_text.h"

namespace slipstitch {
namespace {

std::string table_of(const WorkPrecision& study, std::span<const StudyColumn> columns) {
  std::string text = "| | rung |", rule = "|---|---|";
  for (const StudyColumn& column : columns) {
    if (!is_shown(column, study)) continue;
    text += std::string(" ") + column.title + " |";
    rule += "---:|";
  }
  text += "\n" + rule + "\n";
  for (const RungResult& r : study.rungs) {
    if (!r.no_result.empty()) continue;
    text += "| " + front_text(r) + " | " + rung_name(r.rung) + " |";
    for (const StudyColumn& column : columns)
      if (is_shown(column, study)) text += " " + column.text(r, study) + " |";
    text += "\n";
  }
  return text + "\n";
}

std::string columns_list(const WorkPrecision& study) {
  std::string text;
  for (const auto columns : {study_position_columns(), study_other_columns()})
    for (const StudyColumn& column : columns)
      if (is_shown(column, study)) text += std::string("- **") + column.title + "**: " + column.meaning + "\n";
  return text;
}

}  // namespace

std::string study_plot_file(StudyAxis axis) {
  return axis == StudyAxis::wall_time ? "error-time.svg" : "error-newton.svg";
}

std::string study_markdown(const WorkPrecision& study, const std::string& command, const std::string& job) {
  std::string text = "# " + study.scene + ": accuracy against time\n\n" +
                     (job.empty() ? "Made by `" + command + "`"
                                  : "Made by a server as " + job + "; `" + command + "` makes another such") +
                     "; do not edit.\n\n";
  return text + study_section(study, "") + study_legend(study);
}

std::string study_section(const WorkPrecision& study, const std::string& folder) {
  std::string text;
  for (const std::string& paragraph : {about_study(study), about_reference(study), about_horizon(study),
                                       about_worst_place(study), about_digits(study)})
    if (!paragraph.empty()) text += paragraph + "\n\n";
  text += "![Error of positions against wall time](" + folder + study_plot_file(StudyAxis::wall_time) +
          ")\n\n![Error of positions against Newton iterations](" + folder +
          study_plot_file(StudyAxis::newton_iterations) + ")\n\n" + table_of(study, study_position_columns()) +
          table_of(study, study_other_columns());
  for (const std::string& reason : without_result(study)) text += "- " + reason + "\n";
  return text + (without_result(study).empty() ? "" : "\n");
}

std::string study_legend(const WorkPrecision& study) { return how_to_read_study() + "\n\n" + columns_list(study); }

}  // namespace slipstitch
