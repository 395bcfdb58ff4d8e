// SPDX-License-Identifier: MIT
#include "cli/screen/effect_table.h"

#include "cli/screen/text.h"
#include "report/effect_columns.h"

namespace slipstitch {
namespace {

constexpr std::size_t kChanges = 5;  // the first columns say what changes, the others what it costs

// The last word is the unit: "max move [R]" fits above its numbers, "time x" is "time".
std::string heading(const EffectColumn& column) {
  std::string title = column.title;
  if (title.ends_with(" x")) title.resize(title.size() - 2);
  return title;
}

std::string columns_table(const EffectStudy& study, std::span<const EffectColumn> columns, const std::string& name) {
  std::vector<std::vector<std::string>> rows{{name}};
  for (const EffectColumn& column : columns) rows[0].push_back(heading(column));
  for (const EffectPrice& price : study.prices) {
    if (!price.not_compared.empty()) continue;
    auto& row = rows.emplace_back();
    row.push_back((price.listed ? "  " : "+ ") + price.effect + (price.together.empty() ? "" : " *"));
    for (const EffectColumn& column : columns) row.push_back(cell_text(column.value(price, study)));
  }
  return table(rows);
}

}  // namespace

std::string effect_table(const EffectStudy& study) {
  const auto columns = effect_columns();
  std::string text = wrapped(study.scene + ":", about_scene(study)) + "\n" +
                     columns_table(study, columns.first(kChanges), "changes by") + "\n" +
                     columns_table(study, columns.subspan(kChanges), "costs, with / without") + "\n" +
                     "  R: yarn radius; with minus without. +: not in the scene, added with defaults.\n";
  for (const EffectPrice& price : study.prices) {
    std::string others;
    for (const std::string& name : price.together) others += (others.empty() ? "" : ", ") + name;
    if (!others.empty() && price.not_compared.empty())
      text += wrapped("  * " + price.effect + ":", "with it goes " + others);
  }
  for (const EffectPrice& price : study.prices)
    if (!price.not_compared.empty()) text += wrapped("  - " + price.effect + ":", price.not_compared);
  return text;
}

}  // namespace slipstitch
