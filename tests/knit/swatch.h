// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "model/model.h"
#include "sim/relax.h"
#include "sim/run.h"

namespace slipstitch::test {

/// Free swatches of the demo yarn, brought to rest without gravity, friction and sliding from the flat tiled repeat
/// plus noise.
struct SwatchSpec {
  std::string preset = "stockinette";
  int courses = 18, wales = 6;
  int rib = 1;   // rib x rib, only for preset "rib"
  int seed = 1;  // noise of seed * 2e-6 m, so that five seeds span 2e-6 to 1e-5 m
  Effects effects;
};

/// Stretch, bending with jamming, wrapping at their defaults.
Effects knit_effects();

Pattern pattern_of(const SwatchSpec& spec);
RelaxedRepeat repeat_of(const SwatchSpec& spec);
double course_period(const SwatchSpec& spec);  // width of a stitch in the relaxed repeat [m]

/// Flat, tiled from the repeat that is relaxed with knit_effects(), whatever spec.effects are.
Model flat_swatch(const SwatchSpec& spec);

/// Loop centres (means of a stitch's 8 nodes) of a swatch at rest.
struct Swatch {
  int courses = 0, wales = 0;
  std::vector<Vec3> centres;          // course by course
  RunSummary measured;                // residual, shares of faded wraps
  std::vector<double> faded_by_wale;  // share of faded wraps in the courses from the third to the last but two
  VecX q;

  const Vec3& centre(int course, int wale) const {  // 1-based
    return centres[static_cast<std::size_t>((course - 1) * wales + wale - 1)];
  }
};

/// Residual at most 1e-6 EI/L^2, L the contact's rest length; a test failure otherwise.
Swatch bring_to_rest(Model model);
Swatch swatch_at_rest(const SwatchSpec& spec);

/// Median curvature [1/m] of the rows of loop centres, positive towards the right side: across the wales (along the
/// courses) and along the wales. `group`: means over so many courses are taken first (a full repeat).
double curvature_across_wales(const Swatch& swatch, int group = 1);
double curvature_along_wales(const Swatch& swatch, int group = 1);

/// Mean distance of loop centres two stitches apart in one course, away from the edges [m].
double two_stitch_distance(const Swatch& swatch);

}  // namespace slipstitch::test
