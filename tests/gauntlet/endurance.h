// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "sim/simulation.h"

namespace slipstitch::gauntlet {

enum class Friction { on, off };  // on: it holds yarn where it has got to, and lets go at a touch

/// A relaxed swatch of 5 x 5 stitches that has come to rest, under the default numerics.
class RestingSwatch {
 public:
  explicit RestingSwatch(Friction friction);
  RestingSwatch(const RestingSwatch&) = delete;
  RestingSwatch& operator=(const RestingSwatch&) = delete;

  double radius_m() const { return sim_->model().yarn.radius_m; }
  /// Fastest node [m/s].
  double speed() const;
  /// Farthest that a node is from where it came to rest [m].
  double distance() const;
  /// Steps of 1/240 s. `after_step` may be empty.
  void advance(long steps, const std::function<void()>& after_step);
  double energy();  // kinetic energy included [J]
  /// Puts a corner stitch out of its place by `way` [m].
  void kick(double way);
  long newton_iterations() const { return newton_iterations_; }

 private:
  void advance(long steps, double step_s, const std::function<void()>& after_step);
  void stop();

  std::optional<Simulation> sim_;
  VecX rest_;
  long newton_iterations_ = 0;
};

/// What `steps` steps of rest did to it.
struct Rest {
  long steps = 0, newton_iterations = 0;
  double farthest_m = 0.0;  // from where it began, at any step
  double fastest_m_per_s = 0.0;
};
Rest rest(long steps, const std::function<void(long done)>& on_progress);
std::string rest_text(const Rest& found);

/// A load drags yarn through stiff damping for 0.1 s, while all else has come to rest; each step is solved to the
/// default velocity tolerance times `tolerance_share`.
struct Crept {
  double mean_m = 0.0;           // that yarn slides through a stitch
  double fastest_m_per_s = 0.0;  // of all nodes meanwhile
};
Crept crept(double tolerance_share);

}  // namespace slipstitch::gauntlet
