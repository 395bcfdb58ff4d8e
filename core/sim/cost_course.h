// SPDX-License-Identifier: MIT
#pragma once

#include <array>

namespace slipstitch {

/// Wall time of a run in pairs of steps over simulated time, as far as it is known, for whatever pairs may be off by.
/// Beyond, it goes on as in the last half of what is known, but no pair is taken to be off by less than `usual_error_m`
/// there, however smooth the motion was so far. The number of pairs goes with the root of what they may be
/// off by: ten times less takes 2.7 to 3.4 times the steps in scenes/accuracy, as stiff yarn and friction leave no more
/// of the order.
class CostCourse {
 public:
  struct Pair {
    double begin_s = 0.0, end_s = 0.0;  // simulated
    double wall_s = 0.0;
    double error_m = 0.0;      // that sets its length
    double least_share = 1.0;  // of its wall time that larger errors do not save
  };

  CostCourse(double duration_s, double usual_error_m);
  void add(const Pair& pair);
  /// Of pairs that are off by `pair_error_m`, between two simulated times [s]; 0 while nothing is known.
  double wall_s(double begin_s, double end_s, double pair_error_m) const;
  double known_until_s() const { return known_until_; }

 private:
  struct Bin {
    double known_s = 0.0;                    // simulated
    double least_s = 0.0;                    // of wall time
    double times_root_m = 0.0;               // wall time by the root of the error [s m^(1/2)]
    double rate(double pair_error_m) const;  // wall time by simulated time
  };
  static constexpr int kBins = 64;
  double usual_rate(double pair_error_m) const;
  template <class F>
  void each_bin(double begin_s, double end_s, F&& f) const;

  std::array<Bin, kBins> bins_{};
  double bin_s_, usual_error_m_;
  double known_until_ = 0.0;
};

}  // namespace slipstitch
