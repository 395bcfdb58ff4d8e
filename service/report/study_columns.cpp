// SPDX-License-Identifier: MIT
#include "report/study_columns.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "report/number_text.h"

namespace slipstitch {
namespace {

constexpr const char* kNone = "-";

bool any_estimate(const WorkPrecision& study) {
  return std::any_of(study.rungs.begin(), study.rungs.end(), [](const RungResult& r) { return r.error_estimate_m; });
}

bool any_parts(const WorkPrecision& study) {
  return std::any_of(study.rungs.begin(), study.rungs.end(), [](const RungResult& r) { return r.predictable_until_s; });
}

std::string share_text(double error, double whole) {
  if (!(whole > 0.0)) return kNone;
  const double percent = 100.0 * error / whole;
  if (!std::isfinite(percent)) return "far off";
  return percent < 1e-3 && percent > 0.0
             ? "<0.001 %"
             : (percent < 100.0 ? short_number(percent, percent < 0.1 ? 1 : 2) : thousands(std::lround(percent))) +
                   " %";
}

std::string seconds_text(double wall_s) { return wall_s < 59.95 ? short_number(wall_s) + " s" : duration_text(wall_s); }

std::string position_text(const RungResult& r, const WorkPrecision&) {
  return r.errors ? (r.resolved || std::isnan(r.errors->position_m) ? "" : "~") + error_text(r.errors->position_m)
                  : kNone;
}
std::string rms_text(const RungResult& r, const WorkPrecision&) {
  return r.errors ? error_text(r.errors->rms_m) : kNone;
}

template <auto kError, auto kWhole>
std::string relative_text(const RungResult& r, const WorkPrecision& study) {
  return r.errors ? share_text((*r.errors).*kError, study.*kWhole) : kNone;
}

template <auto kSpeedup>
std::string speedup_text(const RungResult& r, const WorkPrecision&) {
  const std::optional<Speedup>& speedup = r.*kSpeedup;
  if (!speedup) return kNone;
  const double x = speedup->factor;
  return "x" + (x >= 100.0 ? thousands(std::lround(x)) : short_number(x, 2)) + (speedup->extrapolated ? " e" : "");
}

template <auto kCount>
std::string count_text(const RungResult& r, const WorkPrecision&) {
  return thousands(r.*kCount);
}

constexpr std::array kPositionColumns{
    StudyColumn{"error", "largest error of the position of any node at any frame up to the horizon", position_text,
                nullptr},
    StudyColumn{"95 %", "the same that 95 of 100 nodes keep to",
                [](const RungResult& r, const WorkPrecision&) {
                  return r.errors ? error_text(r.errors->most_m) : std::string(kNone);
                },
                nullptr},
    StudyColumn{"rms", "the same of all, root mean square over nodes and frames", rms_text, nullptr, true},
    StudyColumn{"order", "power of the step, or tolerance, with which the error has fallen since the row before",
                [](const RungResult& r, const WorkPrecision&) {
                  return r.order ? short_number(std::round(100.0 * *r.order) / 100.0) : std::string(kNone);
                },
                nullptr},
    StudyColumn{"estimate", "the run's own estimate of its largest error",
                [](const RungResult& r, const WorkPrecision&) {
                  return r.error_estimate_m ? error_text(*r.error_estimate_m) : std::string(kNone);
                },
                any_estimate},
    StudyColumn{"until", "from where on its error can no longer be told from what the smallest noise does",
                [](const RungResult& r, const WorkPrecision&) {
                  return r.predictable_until_s ? short_number(*r.predictable_until_s) + " s" : std::string("end");
                },
                any_parts},
    StudyColumn{"time", "wall time, the median where it was run more than once",
                [](const RungResult& r, const WorkPrecision&) { return seconds_text(r.wall_s); }, nullptr},
    StudyColumn{"vs base",
                "time of the baseline, linearised implicit Euler, to the same error / its own; e: extrapolated",
                speedup_text<&RungResult::speedup>, nullptr},
    StudyColumn{"vs base 95 %", "the same for the error that 95 of 100 nodes keep to",
                speedup_text<&RungResult::speedup_most>, nullptr, true},
};

constexpr std::array kOtherColumns{
    StudyColumn{"energy", "largest error of the energy stored in yarn and contacts at any frame, of its largest value",
                relative_text<&RungErrors::stored_j, &WorkPrecision::stored_j>, nullptr},
    StudyColumn{"force",
                "the same of the largest force on any handle, or of the largest tension where there is no handle",
                relative_text<&RungErrors::force_n, &WorkPrecision::force_n>, nullptr},
    StudyColumn{"length", "the same of the length of all yarn, stretched as it is",
                relative_text<&RungErrors::length_m, &WorkPrecision::length_m>, nullptr},
    StudyColumn{"steps", "accepted steps", count_text<&RungResult::steps>, nullptr},
    StudyColumn{"cut", "steps that were done again, shorter", count_text<&RungResult::rejected_steps>, nullptr},
    StudyColumn{"Newton", "Newton iterations", count_text<&RungResult::newton_iterations>, nullptr},
    StudyColumn{"factors", "factorisations of the Hessian", count_text<&RungResult::factorizations>, nullptr},
    StudyColumn{"CG", "iterations of conjugate gradients", count_text<&RungResult::cg_iterations>, nullptr},
    StudyColumn{"memory", "heap in use at the last step",
                [](const RungResult& r, const WorkPrecision&) { return bytes_text(r.memory_bytes); }, nullptr, true},
};

}  // namespace

std::string error_text(double metres) {
  if (std::isnan(metres)) return kNone;
  return std::isfinite(metres) ? metres_text(metres) : "far off";
}

std::span<const StudyColumn> study_position_columns() { return kPositionColumns; }
std::span<const StudyColumn> study_other_columns() { return kOtherColumns; }

bool is_shown(const StudyColumn& column, const WorkPrecision& study) {
  return column.shown == nullptr || column.shown(study);
}

std::string front_text(const RungResult& result) { return result.on_front ? "*" : ""; }

}  // namespace slipstitch
