// SPDX-License-Identifier: MIT
#pragma once

namespace slipstitch {

/// Ways to do it that are simpler, and lose. For comparison in tests: no scene can ask for them.
struct Naive {
  bool unsigned_angle = false;       // arccos for psi, with derivatives of the signed one
  bool unfaded_wraps = false;        // the bare wrapping energy, singular along the axis and with a ridge
  bool unfiltered_steps = false;     // Newton steps of any length
  bool unprojected_hessian = false;  // none stands in for an indefinite one
  bool explicit_friction = false;    // sliding friction as of the velocity at the start of the step
  bool no_velocity_terms = false;    // inertia M (v+ - v), without what a changing M gives
};

}  // namespace slipstitch
