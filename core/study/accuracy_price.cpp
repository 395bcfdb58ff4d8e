// SPDX-License-Identifier: MIT
#include "study/accuracy_price.h"

#include <algorithm>
#include <cmath>

namespace slipstitch {
namespace {

constexpr double kLeastDigits = 0.5;
constexpr double kNoError_m = 1e-15;  // stands for none in logarithms
constexpr double kBaselineStep_s = 1e-3, kAboutThat = 1.2;

struct Point {
  double error_m, wall_s;
};

using Error = double RungErrors::*;

bool comparable(const RungResult& result, Error error = &RungErrors::position_m) {
  return result.errors && std::isfinite((*result.errors).*error) && result.wall_s > 0.0;
}

Point point_of(const RungResult& result, Error error = &RungErrors::position_m) {
  return {std::max((*result.errors).*error, kNoError_m), result.wall_s};
}

/// b makes a superfluous.
bool beats(const Point& b, const Point& a) {
  return b.error_m <= a.error_m && b.wall_s <= a.wall_s && (b.error_m < a.error_m || b.wall_s < a.wall_s);
}

/// Those that no other beats, by falling error and so by rising time.
std::vector<Point> frontier(std::vector<Point> points) {
  std::vector<Point> front;
  for (const Point& a : points)
    if (std::none_of(points.begin(), points.end(), [&](const Point& b) { return beats(b, a); })) front.push_back(a);
  std::sort(front.begin(), front.end(), [](const Point& a, const Point& b) { return a.error_m > b.error_m; });
  return front;
}

std::vector<Point> marked_front(const std::vector<RungResult>& rungs) {
  std::vector<Point> points;
  for (const RungResult& result : rungs)
    if (result.on_front && result.resolved && result.errors->position_m > 0.0) points.push_back(point_of(result));
  return frontier(points);
}

/// On a frontier, between its ends.
double time_at(const std::vector<Point>& front, double error) {
  for (std::size_t i = 0; i + 1 < front.size(); ++i) {
    const Point &a = front[i], &b = front[i + 1];
    if (error < b.error_m) continue;
    if (a.error_m == b.error_m) return a.wall_s;
    const double share = std::log(a.error_m / error) / std::log(a.error_m / b.error_m);
    return a.wall_s * std::pow(b.wall_s / a.wall_s, share);
  }
  return front.back().wall_s;
}

bool within(const std::vector<Point>& front, double error) {
  return error <= front.front().error_m && error >= front.back().error_m;
}

/// Beyond the ends as of a method of first order.
double extended_time_at(const std::vector<Point>& front, double error) {
  if (within(front, error)) return time_at(front, error);
  const Point& end = error > front.front().error_m ? front.front() : front.back();
  return end.wall_s * end.error_m / error;
}

std::vector<Point> frontier_of(const std::vector<RungResult>& rungs, std::string_view method,
                               Error error = &RungErrors::position_m) {
  std::vector<Point> points;
  for (const RungResult& result : rungs)
    if (result.rung.method == method && comparable(result, error)) points.push_back(point_of(result, error));
  return frontier(std::move(points));
}

void compare_with_baseline(std::vector<RungResult>& rungs, Error error, std::optional<Speedup> RungResult::*speedup) {
  const std::vector<Point> front = frontier_of(rungs, kBaselineMethod, error);
  if (front.empty()) return;
  for (RungResult& result : rungs) {
    if (!comparable(result, error)) continue;
    const Point here = point_of(result, error);
    result.*speedup = Speedup{extended_time_at(front, here.error_m) / here.wall_s, !within(front, here.error_m)};
  }
}

}  // namespace

void set_orders(std::vector<RungResult>& rungs) {
  const RungResult* before = nullptr;
  for (RungResult& r : rungs) {
    if (!comparable(r) || r.rung.method == kStaticMethod) continue;
    if (before != nullptr && before->rung.method == r.rung.method && before->resolved && r.resolved)
      r.order = std::log(before->errors->position_m / r.errors->position_m) / std::log(before->rung.size / r.rung.size);
    before = &r;
  }
}

void mark_front(std::vector<RungResult>& rungs) {
  for (RungResult& a : rungs) {
    const auto wins = [&](const RungResult& b) { return comparable(b) && beats(point_of(b), point_of(a)); };
    a.on_front = comparable(a) && std::none_of(rungs.begin(), rungs.end(), wins);
  }
}

void compare_with_baseline(std::vector<RungResult>& rungs) {
  compare_with_baseline(rungs, &RungErrors::position_m, &RungResult::speedup);
  compare_with_baseline(rungs, &RungErrors::most_m, &RungResult::speedup_most);
}

std::optional<DefaultGain> default_gain(const std::vector<RungResult>& rungs, double share) {
  const auto a_millisecond = std::find_if(rungs.begin(), rungs.end(), [](const RungResult& r) {
    return r.rung.method == kBaselineMethod && comparable(r) && r.rung.size < kAboutThat * kBaselineStep_s &&
           r.rung.size > kBaselineStep_s / kAboutThat;
  });
  const std::vector<Point> own = frontier_of(rungs, kAccuracyMethod);
  if (a_millisecond == rungs.end() || own.empty()) return std::nullopt;
  DefaultGain gain;
  gain.error_m = share * point_of(*a_millisecond).error_m;
  if (gain.error_m < own.back().error_m) return std::nullopt;
  gain.default_s = gain.error_m > own.front().error_m ? own.front().wall_s : time_at(own, gain.error_m);
  const std::vector<Point> baseline = frontier_of(rungs, kBaselineMethod);
  const bool measured = share == 1.0;  // which another of its steps may beat
  gain.baseline_extrapolated = !measured && !within(baseline, gain.error_m);
  gain.baseline_s = measured ? a_millisecond->wall_s : extended_time_at(baseline, gain.error_m);
  return gain;
}

std::vector<DigitPrice> digit_prices(const std::vector<RungResult>& rungs) {
  const std::vector<Point> front = marked_front(rungs);
  std::vector<DigitPrice> prices;
  if (front.size() < 2) return prices;
  const int first = static_cast<int>(std::floor(std::log10(front.front().error_m) + 1e-9));
  for (int exponent = first;; --exponent) {
    const double from = std::pow(10.0, exponent), to = std::pow(10.0, exponent - 1);
    if (!within(front, to)) return prices;
    prices.push_back({from, to, time_at(front, to) / time_at(front, from)});
  }
}

std::optional<double> mean_digit_factor(const std::vector<RungResult>& rungs) {
  const std::vector<Point> front = marked_front(rungs);
  if (front.size() < 2) return std::nullopt;
  const double digits = std::log10(front.front().error_m / front.back().error_m);
  if (digits < kLeastDigits) return std::nullopt;
  return std::pow(front.back().wall_s / front.front().wall_s, 1.0 / digits);
}

}  // namespace slipstitch
