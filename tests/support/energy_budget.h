// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "sim/simulation.h"

namespace slipstitch::test {

/// Energy of a simulation against what it had at the start and the work that was done on it since: implicit Euler only
/// loses some. Work is that of the held coordinates' supports and of bodies that all move by the same way, each
/// with the force at the end of the step.
class EnergyBudget {
 public:
  explicit EnergyBudget(Simulation& sim) : sim_(sim), start_(total()), last_(start_), q_(sim.state().q) {}

  /// After every accepted step; `way`: of the bodies in it [m].
  void after_step(const Vec3& way = Vec3::Zero()) {
    const VecX& q = sim_.state().q;
    const double work = sim_.reactions().dot(q - q_) + body_force(q).dot(way);
    q_ = q;
    work_ += work;
    const double now = total();
    rise_ = now - last_ - work;
    worst_step_ = std::max(worst_step_, rise_);
    excess_ = std::max(excess_, now - start_ - work_);
    last_ = now;
    turnover_ = std::max({turnover_, std::abs(work_), stored_ + kinetic_, std::abs(now - start_)});
  }

  /// Most by which the energy ever exceeded what it may be, as a share of the most that was about: in motion, stored, or
  /// worked in.
  double excess() const { return excess_ / turnover_; }
  /// The same of any one step.
  double worst_step() const { return worst_step_ / turnover_; }
  /// Of the last step.
  double last_rise() const { return turnover_ > 0.0 ? rise_ / turnover_ : 0.0; }

 private:
  double total() {
    stored_ = kinetic_ = 0.0;
    double sum = 0.0;
    for (const auto& [term, energy] : sim_.energies()) {
      sum += energy;
      if (term == "kinetic") {
        kinetic_ += energy;
      } else if (term != "gravity") {
        stored_ += energy;
      }
    }
    return sum;
  }

  Vec3 body_force(const VecX& q) const {
    VecX gradient = VecX::Zero(q.size());
    add_full_gradient(term_of<ColliderContact>(sim_.forces()), q, {}, gradient);
    add_full_gradient(term_of<ColliderFriction>(sim_.forces()), q, {}, gradient);
    const int nodes = sim_.model().topology.num_nodes;
    return -Eigen::Map<const Eigen::Matrix3Xd>(gradient.data(), 3, nodes).rowwise().sum();
  }

  Simulation& sim_;
  double stored_ = 0.0, kinetic_ = 0.0;  // at the last look [J]
  double start_, last_;                  // [J]
  double work_ = 0.0, rise_ = 0.0, excess_ = 0.0, worst_step_ = 0.0, turnover_ = 0.0;
  VecX q_;
};

}  // namespace slipstitch::test
