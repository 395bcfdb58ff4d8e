// SPDX-License-Identifier: MIT
#include "report/study_text.h"

#include <algorithm>
#include <cmath>

#include "report/number_text.h"
#include "report/study_columns.h"

namespace slipstitch {
namespace {

std::string orders_text(const StudyReference& reference) {
  if (reference.error_m && reference.extrapolated)
    return "; by the order that its changes show, " + short_number(*reference.order, 2) + ", its own error is about " +
           error_text(*reference.error_m);
  return "; its own error is taken to be as large";
}

}  // namespace

std::vector<std::string> without_result(const WorkPrecision& study) {
  std::vector<std::string> reasons;  // in the order in which they come
  for (const RungResult& r : study.rungs)
    if (!r.no_result.empty() && std::find(reasons.begin(), reasons.end(), r.no_result) == reasons.end())
      reasons.push_back(r.no_result);
  for (std::string& reason : reasons) {
    std::string names;
    bool failed = false;
    for (const RungResult& r : study.rungs) {
      if (r.no_result != reason) continue;
      names += (names.empty() ? "" : ", ") + rung_name(r.rung);
      failed = r.failed;
    }
    reason = (failed ? "failed: " : "not run: ") + names + ": " + reason;
  }
  return reasons;
}

std::string about_study(const WorkPrecision& study) {
  const auto missing =
      std::count_if(study.rungs.begin(), study.rungs.end(), [](const RungResult& r) { return !r.no_result.empty(); });
  std::string text = study.loops > 0 ? count_of(study.loops, "loop", "loops") + ", " : "";
  text += count_of(study.dofs, "unknown", "unknowns") + ", " + short_number(study.duration_s) + " s in " +
          count_of(study.frames, "frame", "frames") + ", run in " +
          count_of(static_cast<long>(study.rungs.size()) - missing, "way", "ways") + " on " +
          count_of(study.threads, "thread", "threads");
  return text + (missing > 0 ? "; " + std::to_string(missing) + " more without a result." : ".");
}

std::string about_reference(const WorkPrecision& study) {
  const StudyReference& reference = study.reference;
  if (!reference.failure.empty())
    return "There is no reference, and so there are no errors: " + reference.failure + ".";
  if (reference.refinements == 0) return "There is no reference, and so there are no errors.";
  std::string text = "The reference is " + reference.method + " with steps of " + short_number(1e3 * reference.step_s) +
                     " ms (" + duration_text(reference.wall_s) + ")";
  if (!reference.error_m) return text + "; how far it is off is not known.";
  text += ", which its last refinement changed by " + error_text(reference.change_m.back()) + orders_text(reference);
  if (reference.settled) return text + ".";
  if (reference.at_noise) return text + ". It is no finer because noise at the start (below) moves it as far.";
  return text + ". It has not settled: that is more than a tenth of the smallest error in the table" +
         (reference.out_of_time ? ", and there was no time for more." : ".");
}

std::string about_horizon(const WorkPrecision& study) {
  const StudyReference& reference = study.reference;
  if (reference.refinements == 0) return {};
  if (!reference.twin_step_s) return "How far the motion can be predicted was not looked at: there was no time.";
  const std::string twin =
      "A twin of the reference that begins with noise of " + metres_text(kTwinNoise_m) + " in every free coordinate ";
  const std::string away = error_text(reference.twin_distance_m);
  const bool never = std::none_of(study.rungs.begin(), study.rungs.end(),
                                  [](const RungResult& r) { return r.errors && !std::isnan(r.errors->position_m); });
  if (study.horizon_s && never)
    return twin + "comes to be " + away + " away from it, and to the errors of most it is lost before " +
           short_number(*study.horizon_s) +
           " s, the first frame: positions are not compared at all; energy, force and length are.";
  if (study.horizon_s)
    return twin + "comes to be " + away + " away from it: positions are not predictable beyond " +
           short_number(*study.horizon_s) + " s and are compared up to there; energy, force and length to the end.";
  const auto parted = std::count_if(study.rungs.begin(), study.rungs.end(),
                                    [](const RungResult& r) { return r.predictable_until_s.has_value(); });
  if (parted == 0)
    return twin + "is never farther from it than " + away +
           ": to the errors in the table the motion is predictable to the end.";
  return twin + "comes to be " + away +
         " away from it. The motion is predictable to the end to most errors in the table; " +
         count_of(parted, "of them is", "of them are") + " too small for that (until).";
}

std::string about_worst_place(const WorkPrecision& study) {
  if (study.worst_place.empty()) return {};
  const auto compared =
      std::count_if(study.rungs.begin(), study.rungs.end(), [](const RungResult& r) { return r.errors.has_value(); });
  return std::to_string(study.at_worst_place) + " of " + count_of(compared, "way has", "ways have") +
         " the largest error at " + study.worst_place + ".";
}

std::string about_digits(const WorkPrecision& study) {
  if (!study.digit_factor) return "The front is too short to say what a digit costs.";
  std::string text =
      "One more digit costs x" + short_number(*study.digit_factor, 2) + " in time along the front, on average";
  for (std::size_t i = 0; i < study.digits.size(); ++i) {
    const DigitPrice& digit = study.digits[i];
    text += (i == 0 ? "; from " : ", from ") + metres_text(digit.from_m) + " to " + metres_text(digit.to_m) + " x" +
            short_number(digit.time_factor, 2);
  }
  return text + ".";
}

std::string how_to_read_study() {
  return "Every row is one way to run the scene: a method of time integration with its largest step, or a tolerance "
         "that "
         "the run keeps by itself. Errors are differences from a reference, a run refined until it no longer changes; "
         "~ "
         "marks errors of less than three times the reference's own. Energies, forces and lengths are told in parts of "
         "the largest value that the reference has. * marks the front: nothing else that was run is both faster and "
         "more "
         "accurate. Times are wall times on one machine; runs of less than two seconds are done three times, in turn, "
         "and "
         "their median is taken.";
}

}  // namespace slipstitch
