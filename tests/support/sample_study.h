// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "study/accuracy_price.h"
#include "study/work_precision.h"

namespace slipstitch::test {

inline RungResult sample_rung(const std::string& method, const std::string& label, double size, double error_m,
                              double wall_s) {
  RungResult r;
  r.rung = {method, label, size, FixedNumerics{}};
  r.times = 3;
  r.wall_s = wall_s;
  r.memory_bytes = 2.5e6;
  r.steps = 48;
  r.rejected_steps = 2;
  r.newton_iterations = static_cast<long>(1000.0 * wall_s);
  r.factorizations = 170;
  r.cg_iterations = 585;
  r.errors = RungErrors{error_m, 0.5 * error_m, 0.1 * error_m, 2e-7, 3e-3, 4e-5};
  r.resolved = error_m > 3e-6;
  return r;
}

/// Two methods, one rung too accurate to be resolved, one that failed and two that were not run.
inline WorkPrecision sample_work_precision() {
  WorkPrecision study;
  study.scene = "a <b> & \"c\"";
  study.radius_m = 5e-4;
  study.duration_s = 0.4;
  study.loops = 144;
  study.dofs = 2930;
  study.frames = 13;
  study.rungs = {sample_rung("LINEARISED_EULER", "16.7 ms", 1.0 / 60, 1e-2, 0.1),
                 sample_rung("LINEARISED_EULER", "8.33 ms", 1.0 / 120, 5e-3, 0.2),
                 sample_rung("LINEARISED_EULER", "4.17 ms", 1.0 / 240, 2.5e-3, 0.4),
                 sample_rung("SDIRK2", "16.7 ms", 1.0 / 60, 1e-3, 0.5),
                 sample_rung("SDIRK2", "8.33 ms", 1.0 / 120, 2.5e-4, 1.0),
                 sample_rung("SDIRK2", "4.17 ms", 1.0 / 240, 2e-6, 70.0)};
  RungResult failed;
  failed.rung = {"BDF2", "16.7 ms", 1.0 / 60, FixedNumerics{}};
  failed.failed = true;
  failed.no_result = "no step converges, \"at all\"";
  study.rungs.push_back(failed);
  for (const char* label : {"8.33 ms", "4.17 ms"}) {
    RungResult missing;
    missing.rung = {"BDF2", label, 1.0 / 120, FixedNumerics{}};
    missing.no_result = "did not fit into the time";
    study.rungs.push_back(missing);
  }
  study.rungs[5].predictable_until_s = 0.1;
  study.rungs[3].errors->force_n = std::numeric_limits<double>::infinity();
  study.stored_j = 1e-4;
  study.force_n = 0.03;
  study.length_m = 1.0;
  study.worst_place = "point 0 of yarn 0";
  study.at_worst_place = 5;
  StudyReference& reference = study.reference;
  reference.method = "SDIRK2";
  reference.step_s = 1e-3;
  reference.wall_s = 140.0;
  reference.refinements = 2;
  reference.change_m = {1.2e-5, 3e-6};
  reference.order = 2.0;
  reference.error_m = 1e-6;
  reference.extrapolated = true;
  reference.settled = true;
  reference.twin_step_s = 1e-3;
  reference.twin_distance_m = 2e-6;
  set_orders(study.rungs);
  mark_front(study.rungs);
  compare_with_baseline(study.rungs);
  study.digits = digit_prices(study.rungs);
  study.digit_factor = mean_digit_factor(study.rungs);
  return study;
}

}  // namespace slipstitch::test
