// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "report/accuracy_report.h"
#include "report/number_text.h"
#include "report/study_columns.h"
#include "report/study_report.h"
#include "study/accuracy_price.h"
#include "study/median.h"

namespace slipstitch {
namespace {

constexpr double kTenth = 0.1;

std::string gain_cells(const std::optional<DefaultGain>& gain) {
  if (!gain) return " - | - | - |";
  return " " + std::string(gain->baseline_extrapolated ? "~" : "") + short_number(gain->baseline_s) + " s | " +
         short_number(gain->default_s) + " s | **" + short_number(gain->baseline_s / gain->default_s, 2) + "** |";
}

std::string row_of(const NamedStudy& named) {
  const WorkPrecision& study = named.study;
  const auto equal = default_gain(study.rungs, 1.0), tenth = default_gain(study.rungs, kTenth);
  return "| [" + study.scene + "](#" + study.scene + ") | " + (equal ? error_text(equal->error_m) : "-") + " |" +
         gain_cells(equal) + gain_cells(tenth) + " " +
         (study.digit_factor ? "x" + short_number(*study.digit_factor, 2) : "-") + " | " +
         (study.horizon_s ? "to " + short_number(*study.horizon_s) + " s" : "to the end") + " |\n";
}

/// Scenes in which the default is never so accurate count as no gain at all.
std::string median_gain(std::span<const NamedStudy> studies, double share) {
  std::vector<double> gains;
  for (const NamedStudy& named : studies) {
    const auto gain = default_gain(named.study.rungs, share);
    gains.push_back(gain ? gain->baseline_s / gain->default_s : 0.0);
  }
  return short_number(median(gains), 2);
}

std::string overview(std::span<const NamedStudy> studies) {
  std::string text =
      "| scene | baseline's error | baseline | default | times faster | baseline, a tenth | default, a tenth | times "
      "faster | one more digit | predictable |\n|---|---:|---:|---:|---:|---:|---:|---:|---:|---|\n";
  for (const NamedStudy& named : studies) text += row_of(named);
  return text + "| median | | | | **" + median_gain(studies, 1.0) + "** | | | **" + median_gain(studies, kTenth) +
         "** | | |\n\n";
}

constexpr const char* kAbout =
    "The baseline is implicit Euler with one linear solve a step, steps of a millisecond; the default is `accuracy`, a "
    "tolerance that the run keeps by itself. Both use the same assembly, linear solver and threads, and were run in "
    "turn in one process. The first columns compare them at the error that the baseline has, the next at a tenth of "
    "that; ~ marks times of the baseline beyond what was run of it, as of a method of first order. \"One more digit\" "
    "is what ten times less error costs along the front of all that was run.";

}  // namespace

std::string accuracy_folder(const NamedStudy& named) { return "accuracy/" + named.stem; }

std::string accuracy_markdown(std::span<const NamedStudy> studies, const std::string& command) {
  std::string text = "# What accuracy costs in time\n\nMade by `" + command + "`; do not edit.\n\n" + kAbout + "\n\n" +
                     overview(studies);
  for (const NamedStudy& named : studies)
    text += "## " + named.study.scene + "\n\n" + study_section(named.study, accuracy_folder(named) + "/");
  return text + "## How to read the tables\n\n" +
         study_legend(studies.empty() ? WorkPrecision{} : studies.front().study);
}

}  // namespace slipstitch
