// SPDX-License-Identifier: MIT
#include "model/effect_list.h"
#include "report/effect_columns.h"
#include "report/effect_notes.h"
#include "report/effect_report.h"
#include "report/page.h"
#include "report/svg.h"

namespace slipstitch {
namespace {

std::string table_html(const EffectStudy& study) {
  std::string text = "<div class=\"wide\"><table>\n<tr><th>effect</th><th>in the scene</th>";
  for (const EffectColumn& column : effect_columns())
    text += "<th title=\"" + escaped(column.meaning) + "\">" + escaped(column.title) + "</th>";
  text += "</tr>\n";
  for (const EffectPrice& price : study.prices) {
    text += "<tr><td>" + escaped(effect_label(price)) + "</td>";
    if (price.not_compared.empty()) {
      text += "<td>" + std::string(presence_text(price)) + "</td>";
      for (const EffectColumn& column : effect_columns())
        text += "<td>" + escaped(cell_text(column.value(price, study))) + "</td>";
    } else {
      text += std::string("<td>") + (price.listed ? "on" : "off") + "</td><td class=\"why\" colspan=\"" +
              std::to_string(effect_columns().size()) + "\">" + escaped(price.not_compared) + "</td>";
    }
    text += "</tr>\n";
  }
  return text + "</table></div>\n";
}

std::string columns_html() {
  std::string text = "<dl>\n";
  for (const EffectColumn& column : effect_columns())
    text += "<dt>" + escaped(column.title) + "</dt><dd>" + escaped(column.meaning) + "</dd>\n";
  return text + "</dl>\n";
}

std::string notes_html() {
  std::string text = "<dl>\n";
  for (const EffectEntry& effect : effect_list())
    text += "<dt>" + escaped(effect.name) + "</dt><dd>" + escaped(effect_note(effect.name)) + "</dd>\n";
  return text + "<dt>handles and loads</dt><dd>" + escaped(handles_note()) + "</dd>\n</dl>\n";
}

std::string section(const EffectReport& report) {
  return "<h2>" + escaped(report.study.scene) + "</h2>\n<p>" + escaped(about_scene(report.study)) + "</p>\n" +
         report.picture + effect_plot(report.study) + table_html(report.study);
}

}  // namespace

std::string effect_page(std::span<const EffectReport> reports, const std::string& command) {
  std::string text = page_begin("What every effect changes and what it costs") + "<p>" + escaped(how_to_read()) +
                     "</p>\n<p>Made by <code>" + escaped(command) + "</code></p>\n";
  for (const EffectReport& report : reports) text += section(report);
  return text + "<h2>The columns</h2>\n" + columns_html() + "<h2>The effects</h2>\n" + notes_html() + page_end();
}

}  // namespace slipstitch
