// SPDX-License-Identifier: MIT
#include "gauntlet/gauntlet_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "gauntlet/invariants.h"

namespace slipstitch::gauntlet {
namespace {

template <class... T>
std::string formatted(const char* format, const T&... values) {
  std::array<char, 512> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

const Reading& worst_reading(const CellResult& result) {
  static const Reading none{"-", 0.0, 0.0};
  if (result.readings.empty()) return none;
  return *std::max_element(result.readings.begin(), result.readings.end(), [](const Reading& a, const Reading& b) {
    return !std::isnan(a.share) && (std::isnan(b.share) || a.share < b.share);
  });
}

/// Sums over the cells of one case.
struct CaseRow {
  const GauntletCase* item = nullptr;
  std::array<int, 4> outcomes{};
  Reading worst{"-", 0.0, 0.0};
  long rejected = 0, convex = 0, ridge = 0, fade = 0, rises = 0;

  void add(const CellRow& row) {
    item = row.item;
    ++outcomes[static_cast<std::size_t>(row.result.outcome)];
    const Reading& reading = worst_reading(row.result);
    if (!(reading.share <= worst.share)) worst = reading;
    const RunSummary& s = row.result.summary;
    rejected = std::max(rejected, s.rejected_steps);
    convex = std::max(convex, s.convex_hessians);
    ridge = std::max(ridge, s.wrap_ridge_entries.value_or(0));
    fade = std::max(fade, s.wrap_fade_entries.value_or(0));
    rises = std::max(rises, row.result.energy_rises);
  }
};

std::vector<CaseRow> by_case(std::span<const CellRow> rows) {
  std::vector<CaseRow> cases;
  for (const CellRow& row : rows) {
    auto found = std::find_if(cases.begin(), cases.end(), [&](const CaseRow& c) { return c.item == row.item; });
    if (found == cases.end()) found = cases.insert(cases.end(), CaseRow{});
    found->add(row);
  }
  return cases;
}

std::string case_table(std::span<const CellRow> rows) {
  std::string text =
      "| case | what | pass | cut | refused | fail | worst invariant | cut steps | indefinite | ridge | fade | rises "
      "|\n"
      "|---|---|---:|---:|---:|---:|---|---:|---:|---:|---:|---:|\n";
  for (const CaseRow& row : by_case(rows))
    text += formatted("| %s | %s | %d | %d | %d | %d | %s %.2g | %ld | %ld | %ld | %ld | %ld |\n",
                      row.item->name.c_str(), row.item->about.c_str(), row.outcomes[0], row.outcomes[1],
                      row.outcomes[2], row.outcomes[3], row.worst.invariant.c_str(), row.worst.share, row.rejected,
                      row.convex, row.ridge, row.fade, row.rises);
  return text;
}

}  // namespace

std::string terminal_line(const CellRow& row) {
  const RunSummary& s = row.result.summary;
  const Reading& worst = worst_reading(row.result);
  std::string line = formatted(
      "%-8s %-24s %-46s %5ld steps %4ld cut %6ld Newton %5ld convex %6.1f s  %s %.2g  ridge %ld fade %ld rises %ld",
      std::string(to_string(row.result.outcome)).c_str(), row.item->name.c_str(),
      settings_text(row.cell.settings).c_str(), s.steps, s.rejected_steps, s.newton_iterations, s.convex_hessians,
      row.wall_s, worst.invariant.c_str(), worst.share, s.wrap_ridge_entries.value_or(0),
      s.wrap_fade_entries.value_or(0), row.result.energy_rises);
  if (!row.result.why.empty()) line += "\n         " + row.result.why;
  return line;
}

std::string stability_markdown(std::span<const CellRow> rows, const std::string& command) {
  std::array<int, 4> outcomes{};
  for (const CellRow& row : rows) ++outcomes[static_cast<std::size_t>(row.result.outcome)];
  std::string text = "# Hard cases, and what holds in them\n\nMade by `" + command + "`; do not edit.\n\n";
  text += formatted("%zu cells: %d pass, %d pass with steps cut, %d are refused, %d fail.\n\n", rows.size(),
                    outcomes[0], outcomes[1], outcomes[2], outcomes[3]);
  text += "Checked at every accepted step of every cell, as a share of what is allowed (above 1: broken):\n\n";
  for (const Invariant& invariant : invariants())
    text += std::string("- **") + invariant.name + "**: " + invariant.meaning + "\n";
  text += "\n" + case_table(rows) + "\n";
  text += "Not as it should be:\n\n";
  for (const CellRow& row : rows)
    if (row.result.outcome == Outcome::failed)
      text += "- " + row.item->name + ", " + settings_text(row.cell.settings) + ": " + row.result.why + "\n";
  return text;
}

std::string stability_csv(std::span<const CellRow> rows) {
  std::string text =
      "case,settings,outcome,steps,rejected_steps,newton_iterations,convex_hessians,max_stretch,"
      "ridge_entries,fade_entries,passages,energy_rises,end_speed_m_per_s";
  for (const Invariant& invariant : invariants()) text += std::string(",") + invariant.name;
  text += "\n";
  for (const CellRow& row : rows) {
    const RunSummary& s = row.result.summary;
    text += formatted("%s,\"%s\",%s,%ld,%ld,%ld,%ld,%.6g,%ld,%ld,%ld,%ld,%.6g", row.item->name.c_str(),
                      settings_text(row.cell.settings).c_str(), std::string(to_string(row.result.outcome)).c_str(),
                      s.steps, s.rejected_steps, s.newton_iterations, s.convex_hessians, s.max_stretch.value_or(0.0),
                      s.wrap_ridge_entries.value_or(0), s.wrap_fade_entries.value_or(0), row.result.passages,
                      row.result.energy_rises, row.result.end_speed_m_per_s);
    for (const Reading& reading : row.result.readings) text += formatted(",%.6g", reading.share);
    text += "\n";
  }
  return text;
}

}  // namespace slipstitch::gauntlet
