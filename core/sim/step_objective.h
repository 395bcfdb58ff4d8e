// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <map>
#include <string>

#include "sim/assembly.h"
#include "sim/simulation.h"

namespace slipstitch {

/// Adds its lifetime to a counter of seconds.
class Stopwatch {
 public:
  explicit Stopwatch(double& seconds) : seconds_(seconds), start_(std::chrono::steady_clock::now()) {}
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;
  ~Stopwatch() { seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  double& seconds_;
  std::chrono::steady_clock::time_point start_;
};

/// The sum of all terms in the unknowns, with the two limits on a Newton step: arc lengths keep their order and no
/// wrap turns by more than a quarter of pi.
class StepObjective final : public Objective {
 public:
  StepObjective(const YarnForces& forces, const DofMap& map, Assembly& assembly, const Topology& topology,
                std::map<std::string, double>& wall)
      : forces_(forces), map_(map), assembly_(assembly), topology_(topology), wall_(wall) {}

  double value(const VecX& y) override;
  double derivatives(const VecX& y, HessianMode mode, VecX& g, SparseMatrix& h) override;
  double max_step(const VecX& y, const VecX& dy) override;
  double value_scale() const override { return assembly_.scale(); }

  /// Moves y along h v, as far as the step limits allow. The guess may stretch yarn that turns; Newton removes that
  /// in one iteration, and has less turning left to do.
  void extrapolate(VecX& y, double h, const VecX& v);

 private:
  bool turns_too_far(const VecX& q, const VecX& dq, double a) const;

  const YarnForces& forces_;
  const DofMap& map_;
  Assembly& assembly_;
  const Topology& topology_;
  std::map<std::string, double>& wall_;
  VecX q_, dq_;  // scratch
};

}  // namespace slipstitch
