// SPDX-License-Identifier: MIT
#include "report/effect_columns.h"
#include "report/effect_notes.h"
#include "report/effect_report.h"

namespace slipstitch {
namespace {

// Rows that say why there is no comparison would only widen the table.
std::string not_compared(const EffectStudy& study) {
  std::string text;
  for (const EffectPrice& price : study.prices)
    if (!price.not_compared.empty()) text += "\n- `" + price.effect + "`: " + price.not_compared;
  return text.empty() ? "" : "\nNot compared:\n" + text + "\n";
}

std::string table_of(const EffectStudy& study) {
  std::string text = "| effect | in the scene |", rule = "|---|---|";
  for (const EffectColumn& column : effect_columns()) {
    text += std::string(" ") + column.title + " |";
    rule += "---:|";
  }
  text += "\n" + rule + "\n";
  for (const EffectPrice& price : study.prices) {
    if (!price.not_compared.empty()) continue;
    text += "| " + effect_label(price) + " | " + std::string(presence_text(price)) + " |";
    for (const EffectColumn& column : effect_columns()) text += " " + cell_text(column.value(price, study)) + " |";
    text += "\n";
  }
  return text;
}

std::string section(const EffectReport& report) {
  const EffectStudy& study = report.study;
  std::string text = "## " + study.scene + "\n\n" + about_scene(study) + "\n\n";
  if (!report.picture.empty())
    text += "![" + study.scene + " under growing sets of effects](" + picture_file(report) + ")\n\n";
  return text + "![What every effect changes and costs](" + plot_file(report) + ")\n\n" + table_of(study) +
         not_compared(study) + "\n";
}

std::string columns_list() {
  std::string text;
  for (const EffectColumn& column : effect_columns())
    text += std::string("- **") + column.title + "**: " + column.meaning + "\n";
  return text;
}

}  // namespace

std::string plot_file(const EffectReport& report) { return "effects/" + report.stem + ".svg"; }

std::string picture_file(const EffectReport& report) { return "effects/" + report.stem + "-growing.svg"; }

std::string effect_markdown(std::span<const EffectReport> reports, const std::string& command) {
  std::string text = "# What every effect changes and what it costs\n\nMade by `" + command + "`; do not edit.\n\n" +
                     how_to_read() + "\n\n" + columns_list() + "\n";
  for (const EffectReport& report : reports) text += section(report);
  return text + effect_notes_markdown();
}

}  // namespace slipstitch
