// SPDX-License-Identifier: MIT
#include "sim/cost_course.h"

#include <algorithm>
#include <cmath>

namespace slipstitch {

CostCourse::CostCourse(double duration_s, double usual_error_m)
    : bin_s_(duration_s / kBins), usual_error_m_(usual_error_m) {}

double CostCourse::Bin::rate(double pair_error_m) const {
  return std::max(least_s, times_root_m / std::sqrt(pair_error_m)) / known_s;
}

/// Calls f(index, simulated time within) for the bins from `begin_s` to `end_s`.
template <class F>
void CostCourse::each_bin(double begin_s, double end_s, F&& f) const {
  const auto bin_at = [&](double t) { return std::clamp(static_cast<int>(t / bin_s_), 0, kBins - 1); };
  for (int b = bin_at(begin_s); b <= bin_at(end_s); ++b) {
    const double from = std::max(begin_s, b * bin_s_);
    const double to = b == kBins - 1 ? end_s : std::min(end_s, (b + 1) * bin_s_);  // times may be off by rounding
    if (to > from) f(static_cast<std::size_t>(b), to - from);
  }
}

void CostCourse::add(const Pair& pair) {
  const double length = pair.end_s - pair.begin_s;
  if (!(length > 0.0)) return;
  each_bin(pair.begin_s, pair.end_s, [&](std::size_t b, double within_s) {
    const double wall = pair.wall_s * within_s / length;
    bins_[b].known_s += within_s;
    bins_[b].least_s += wall * pair.least_share;
    bins_[b].times_root_m += wall * std::sqrt(pair.error_m);
  });
  known_until_ = std::max(known_until_, pair.end_s);
}

double CostCourse::usual_rate(double pair_error_m) const {
  double wall = 0.0, least = 0.0, known = 0.0;
  each_bin(0.5 * known_until_, known_until_, [&](std::size_t b, double within_s) {
    if (bins_[b].known_s <= 0.0) return;
    wall += within_s * bins_[b].rate(pair_error_m);
    least += within_s * bins_[b].least_s / bins_[b].known_s;
    known += within_s;
  });
  return known > 0.0 ? std::max(wall, least * std::sqrt(usual_error_m_ / pair_error_m)) / known : 0.0;
}

double CostCourse::wall_s(double begin_s, double end_s, double pair_error_m) const {
  const double usual = usual_rate(pair_error_m);
  double wall = 0.0;
  each_bin(begin_s, end_s, [&](std::size_t b, double within_s) {
    wall += within_s * (bins_[b].known_s > 0.0 ? bins_[b].rate(pair_error_m) : usual);
  });
  return wall;
}

}  // namespace slipstitch
