// SPDX-License-Identifier: MIT
#pragma once

#include "solve/newton_direction.h"

namespace slipstitch {

enum class Search { decreased, flat, failed };

/// Lets the value rise for a few full steps before insisting on descent [Chamberlain et al. 1982; Nocedal and Wright
/// 2006, 15.6]. Yarn is a thousand times stiffer in stretch than in bending: a step that turns a segment by phi
/// stretches it by phi^2/2, which plain Armijo answers with small turns but the next full step simply removes.
class Watchdog {
 public:
  /// Moves x along point.step. Returns what the search at the reference point gave.
  Search advance(Objective& objective, VecX& x, const NewtonPoint& point, NewtonReport& report);
  /// Gives up the trial and searches from the reference point along its direction. Only while watching.
  Search turn_back(Objective& objective, VecX& x, NewtonReport& report);
  bool watching() const { return left_ > 0; }
  /// Whether x is where the last direction led: neither on trial nor back at the reference point.
  bool settled() const { return left_ == 0 && !turned_back_; }
  /// Of the last direction, that advance() went; 0 where it failed.
  double share() const { return share_; }

 private:
  void watch(const VecX& x, const NewtonPoint& point, double slope, double a);

  VecX x_, step_;  // where the value last was lowest, and the direction there
  double value_ = 0.0, slope_ = 0.0, a_ = 1.0;
  double share_ = 0.0;
  int left_ = 0, trusted_ = 0;  // steps on trial; steps in a row whose decrease round-off hides
  int turns_ = 0;               // trials given up
  bool turned_back_ = false;
};

}  // namespace slipstitch
