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

bool is_naive(const CellRow& row) { return !naive_name(row.cell.settings).empty(); }

/// Sums over the cells of one case.
struct CaseRow {
  const GauntletCase* item = nullptr;
  Totals outcomes;
  Reading worst{"-", 0.0, 0.0};
  long rejected = 0, convex = 0, ridge = 0, fade = 0, crushed = 0, rises = 0;

  void add(const CellRow& row) {
    item = row.item;
    const Reading& reading = worst_reading(row.result);
    if (!(reading.share <= worst.share)) worst = reading;
    const RunSummary& s = row.result.summary;
    rejected = std::max(rejected, s.rejected_steps);
    convex = std::max(convex, s.convex_hessians);
    ridge = std::max(ridge, s.wrap_ridge_entries.value_or(0));
    fade = std::max(fade, s.wrap_fade_entries.value_or(0));
    crushed = std::max(crushed, s.crushed_entries.value_or(0));
    rises = std::max(rises, row.result.energy_rises);
  }
};

void count(const CellRow& row, Totals& sum) {
  switch (row.result.outcome) {
    case Outcome::passed:
      ++sum.passed;
      break;
    case Outcome::cut:
      ++sum.cut;
      break;
    case Outcome::refused:
      ++sum.refused;
      break;
    case Outcome::failed:
      ++sum.failed;
      break;
  }
}

std::vector<CaseRow> by_case(std::span<const CellRow> rows) {
  std::vector<CaseRow> cases;
  for (const CellRow& row : rows) {
    if (is_naive(row)) continue;
    auto found = std::find_if(cases.begin(), cases.end(), [&](const CaseRow& c) { return c.item == row.item; });
    if (found == cases.end()) found = cases.insert(cases.end(), CaseRow{});
    found->add(row);
    count(row, found->outcomes);
  }
  return cases;
}

std::string case_table(std::span<const CellRow> rows) {
  std::string text =
      "| case | what | may be refused | pass | cut | refused | fail | worst invariant | cut steps | indefinite | "
      "ridge | fade | crushed | rises |\n"
      "|---|---|---|---:|---:|---:|---:|---|---:|---:|---:|---:|---:|---:|\n";
  for (const CaseRow& row : by_case(rows))
    text += formatted(
        "| %s | %s | %s | %d | %d | %d | %d | %s %.2g | %ld | %ld | %ld of %ld | %ld of %ld | %ld of %ld | %ld |\n",
        row.item->name.c_str(), row.item->about.c_str(), row.item->limits.impossible ? "yes" : "", row.outcomes.passed,
        row.outcomes.cut, row.outcomes.refused, row.outcomes.failed, row.worst.invariant.c_str(), row.worst.share,
        row.rejected, row.convex, row.ridge, row.item->limits.max_ridge_entries, row.fade,
        row.item->limits.max_fade_entries, row.crushed, row.item->limits.max_crushed_entries, row.rises);
  return text;
}

/// Whether the same cell ends well without the variant.
bool is_lost(const CellRow& naive, std::span<const CellRow> rows) {
  if (naive.result.outcome != Outcome::failed) return false;
  Settings settings = naive.cell.settings;
  settings.naive = {};
  settings.integrator = Integrator::implicit_euler;
  return std::any_of(rows.begin(), rows.end(), [&](const CellRow& row) {
    return row.item == naive.item && settings_text(row.cell.settings) == settings_text(settings) &&
           row.result.outcome != Outcome::failed;
  });
}

std::string naive_table(std::span<const CellRow> rows) {
  std::string text = "| variant | cells lost | of | which |\n|---|---:|---:|---|\n";
  for (const NaiveVariant& variant : naive_variants()) {
    int lost = 0, all = 0;
    std::string which;
    for (const CellRow& row : rows) {
      if (naive_name(row.cell.settings) != variant.name) continue;
      ++all;
      if (!is_lost(row, rows)) continue;
      ++lost;
      which += (which.empty() ? "" : ", ") + row.item->name;
    }
    if (all == 0) return {};
    text += formatted("| %s | %d | %d | ", variant.name, lost, all) + which + " |\n";
  }
  return text;
}

/// A line for every cell of that outcome.
std::string list_of(std::span<const CellRow> rows, Outcome outcome) {
  std::string text;
  for (const CellRow& row : rows)
    if (row.result.outcome == outcome && !is_naive(row))
      text += "- " + row.item->name + ", " + settings_text(row.cell.settings) + ": " + row.result.why + "\n";
  return text.empty() ? "None.\n" : text;
}

}  // namespace

std::string terminal_line(const CellRow& row) {
  const RunSummary& s = row.result.summary;
  const Reading& worst = worst_reading(row.result);
  std::string line = formatted(
      "%-8s %-24s %-46s %5ld steps %4ld cut %6ld Newton %5ld convex %6.1f s  %s %.2g  ridge %ld fade %ld crushed %ld "
      "rises %ld",
      std::string(to_string(row.result.outcome)).c_str(), row.item->name.c_str(),
      settings_text(row.cell.settings).c_str(), s.steps, s.rejected_steps, s.newton_iterations, s.convex_hessians,
      row.wall_s, worst.invariant.c_str(), worst.share, s.wrap_ridge_entries.value_or(0),
      s.wrap_fade_entries.value_or(0), s.crushed_entries.value_or(0), row.result.energy_rises);
  if (!row.result.why.empty()) line += "\n         " + row.result.why;
  return line;
}

Totals totals(std::span<const CellRow> rows) {
  Totals sum;
  for (const CellRow& row : rows)
    if (!is_naive(row)) count(row, sum);
  return sum;
}

std::string stability_markdown(std::span<const CellRow> rows, const std::string& command) {
  const Totals all = totals(rows);
  std::string text =
      "# Hard cases, and what holds in them\n\n"
      "Made by `" +
      command +
      "`; do not edit. One row of stability.csv beside it is one cell: a case under one choice "
      "of "
      "step, stiffness, integrator and solver. The choices cover every two of these, and the case, together.\n\n";
  text += formatted("%d cells: %d pass, %d pass with steps cut, %d are refused, %d fail.\n\n",
                    all.passed + all.cut + all.refused + all.failed, all.passed, all.cut, all.refused, all.failed);
  text += "Checked at every accepted step of every cell, as a share of what is allowed (above 1: broken):\n\n";
  for (const Invariant& invariant : invariants())
    text += std::string("- **") + invariant.name + "**: " + invariant.meaning + "\n";
  text +=
      "\n*Cut*: the end was reached, but steps had to be halved. *Refused*: the run stopped and named place, effect "
      "and "
      "time, where physics allows no more. Of the counts the largest of the cells: steps cut, indefinite Hessians that "
      "their convex part stood in for, wraps that met the ridge of their branch or were faded, segments that were "
      "crushed "
      "(and how many of these the case may use), steps in which energy rose by more than the work done.\n\n";
  text += case_table(rows) + "\n## Refused\n\n" + list_of(rows, Outcome::refused);
  text += "\n## Failed\n\n" + list_of(rows, Outcome::failed);
  if (const std::string naive = naive_table(rows); !naive.empty())
    text +=
        "\n## What simpler ways would lose\n\nEvery case as it is, with one safeguard less each; lost is a cell that "
        "ends well with it.\n\n" +
        naive;
  return text;
}

std::string stability_csv(std::span<const CellRow> rows) {
  std::string text =
      "case,settings,outcome,steps,rejected_steps,newton_iterations,convex_hessians,max_stretch,"
      "ridge_entries,fade_entries,crushed_entries,passages,energy_rises,end_speed_m_per_s";
  for (const Invariant& invariant : invariants()) text += std::string(",") + invariant.name;
  text += "\n";
  for (const CellRow& row : rows) {
    const RunSummary& s = row.result.summary;
    text += formatted("%s,\"%s\",%s,%ld,%ld,%ld,%ld,%.6g,%ld,%ld,%ld,%ld,%ld,%.6g", row.item->name.c_str(),
                      settings_text(row.cell.settings).c_str(), std::string(to_string(row.result.outcome)).c_str(),
                      s.steps, s.rejected_steps, s.newton_iterations, s.convex_hessians, s.max_stretch.value_or(0.0),
                      s.wrap_ridge_entries.value_or(0), s.wrap_fade_entries.value_or(0), s.crushed_entries.value_or(0),
                      row.result.passages, row.result.energy_rises, row.result.end_speed_m_per_s);
    for (const Reading& reading : row.result.readings) text += formatted(",%.6g", reading.share);
    text += "\n";
  }
  return text;
}

}  // namespace slipstitch::gauntlet
