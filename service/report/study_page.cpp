// SPDX-License-Identifier: MIT
#include "report/page.h"
#include "report/study_columns.h"
#include "report/study_report.h"
#include "report/study_text.h"
#include "report/svg.h"

namespace slipstitch {
namespace {

std::string paragraph(const std::string& text) { return text.empty() ? "" : "<p>" + escaped(text) + "</p>\n"; }

std::string table_html(const WorkPrecision& study, std::span<const StudyColumn> columns) {
  std::string text = "<div class=\"wide\"><table>\n<tr><th></th><th>rung</th>";
  for (const StudyColumn& column : columns)
    if (is_shown(column, study))
      text += "<th title=\"" + escaped(column.meaning) + "\">" + escaped(column.title) + "</th>";
  text += "</tr>\n";
  for (const RungResult& r : study.rungs) {
    if (!r.no_result.empty()) continue;
    text += std::string(r.on_front ? "<tr class=\"front\"" : "<tr") + "><td>" + front_text(r) + "</td><td>" +
            escaped(rung_name(r.rung)) + "</td>";
    for (const StudyColumn& column : columns)
      if (is_shown(column, study)) text += "<td>" + escaped(column.text(r, study)) + "</td>";
    text += "</tr>\n";
  }
  return text + "</table></div>\n";
}

std::string columns_html(const WorkPrecision& study) {
  std::string text = "<dl>\n";
  for (const auto columns : {study_position_columns(), study_other_columns()})
    for (const StudyColumn& column : columns)
      if (is_shown(column, study))
        text += "<dt>" + escaped(column.title) + "</dt><dd>" + escaped(column.meaning) + "</dd>\n";
  return text + "</dl>\n";
}

std::string missing_html(const WorkPrecision& study) {
  std::string text;
  for (const std::string& reason : without_result(study)) text += "<li>" + escaped(reason) + "</li>\n";
  return text.empty() ? "" : "<ul>\n" + text + "</ul>\n";
}

}  // namespace

std::string study_page(const WorkPrecision& study, const std::string& command, const std::string& job) {
  return page_begin(study.scene + ": accuracy against time") + paragraph(about_study(study)) +
         paragraph(about_reference(study)) + paragraph(about_horizon(study)) + paragraph(about_worst_place(study)) +
         paragraph(about_digits(study)) + study_plot(study, StudyAxis::wall_time) +
         study_plot(study, StudyAxis::newton_iterations) + "<h2>Positions, and the time they take</h2>\n" +
         table_html(study, study_position_columns()) + "<h2>Energy, force and length, and what else it takes</h2>\n" +
         table_html(study, study_other_columns()) + missing_html(study) + "<h2>How to read it</h2>\n" +
         paragraph(how_to_read_study()) + columns_html(study) + "<p>Made by " +
         (job.empty() ? "" : "a server as " + escaped(job) + "; ") + "<code>" + escaped(command) + "</code>" +
         (job.empty() ? "" : " makes another such") + "</p>\n" + page_end();
}

}  // namespace slipstitch
