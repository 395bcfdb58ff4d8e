// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "model/issue.h"
#include "report/effect_columns.h"
#include "report/effect_report.h"
#include "report/number_text.h"
#include "report/svg.h"

namespace slipstitch {
namespace {

constexpr double kWidth = 960.0, kTop = 74.0, kRow = 24.0, kBottom = 34.0;
constexpr int kTicks = 3;  // of the time axis, on either side of 1
constexpr std::string_view kGrid = "#e3e3e3", kAxis = "#888", kFaint = "#777";
constexpr std::string_view kMove = "#2b6cb0", kRms = "#90b8de", kCost = "#c05621", kSaving = "#2f855a";

/// A logarithmic axis from x0 to x1.
struct LogAxis {
  double low, high, x0, x1;
  double at(double value) const {
    const double share = std::log(value / low) / std::log(high / low);
    return x0 + (x1 - x0) * std::clamp(share, 0.0, 1.0);
  }
};

bool compared(const EffectPrice& price) { return price.not_compared.empty(); }

LogAxis displacement_axis(const EffectStudy& study) {
  double high = 1.0;
  for (const EffectPrice& price : study.prices)
    if (compared(price)) high = std::max(high, price.max_displacement_m / study.radius_m);
  return {1e-4, std::pow(10.0, std::ceil(std::log10(high) - 1e-9)), 200.0, 520.0};
}

LogAxis time_axis(const EffectStudy& study) {
  double extreme = 1.9;
  for (const EffectPrice& price : study.prices)
    if (compared(price) && price.time_ratio > 0.0)
      extreme = std::max({extreme, price.time_ratio, 1.0 / price.time_ratio});
  const double high = std::exp2(std::ceil(std::log2(extreme) - 1e-9));
  return {1.0 / high, high, 650.0, 900.0};
}

void draw_axes(Svg& svg, const LogAxis& move, const LogAxis& time, double bottom) {
  const int decades = static_cast<int>(std::lround(std::log10(move.high / move.low)));
  for (int k = 0; k <= decades; ++k) {
    const double value = move.low * std::pow(10.0, k);
    svg.line(move.at(value), kTop - 8.0, move.at(value), bottom, kGrid);
    svg.text(move.at(value), bottom + 16.0, k == 0 ? "<1e-4" : plain_number(value, 1), "middle", kFaint);
  }
  const int octaves = static_cast<int>(std::lround(std::log2(time.high)));  // on either side
  const int apart = 1 + (octaves - 1) / kTicks, ticks = octaves / apart;
  for (int k = -ticks; k <= ticks; ++k) {
    const double value = std::exp2(k * apart);
    svg.line(time.at(value), kTop - 8.0, time.at(value), bottom, value == 1.0 ? kAxis : kGrid);
    svg.text(time.at(value), bottom + 16.0, "x" + short_number(value), "middle", kFaint);
  }
}

void draw_prices(Svg& svg, const EffectPrice& price, const EffectStudy& study, const LogAxis& move, const LogAxis& time,
                 double y) {
  const double rms = price.rms_displacement_m / study.radius_m, max = price.max_displacement_m / study.radius_m;
  if (max > 0.0) {
    svg.line(move.at(rms), y, move.at(max), y, kRms, 3.0);
    svg.circle(move.at(rms), y, 3.5, kRms);
    svg.circle(move.at(max), y, 4.5, kMove);
  }
  svg.text(move.x1 + 10.0, y + 4.0, max > 0.0 ? cell_text(max) : "none", "start", max > 0.0 ? "#222" : kFaint);
  const double one = time.at(1.0), here = time.at(price.time_ratio);
  svg.rect(std::min(one, here), y - 6.0, std::abs(here - one), 12.0, here > one ? kCost : kSaving);
  svg.text(here > one ? here + 5.0 : here - 5.0, y + 4.0, "x" + cell_text(price.time_ratio),
           here > one ? "start" : "end");
}

}  // namespace

std::string effect_plot(const EffectStudy& study) {
  std::vector<const EffectPrice*> rows;
  for (const EffectPrice& price : study.prices)
    if (compared(price) || price.listed) rows.push_back(&price);
  const double bottom = kTop + kRow * static_cast<double>(rows.size());
  Svg svg(kWidth, bottom + kBottom, study.scene + ": what every effect changes and costs");
  const LogAxis move = displacement_axis(study), time = time_axis(study);
  svg.text(16.0, 24.0, study.scene, "start", "#222", "font-size=\"15\" font-weight=\"600\"");
  svg.text(move.x0, 24.0, "moves the fabric by, in yarn radii", "start", "#222", "font-weight=\"600\"");
  svg.circle(move.x0 + 5.0, 43.0, 4.5, kMove);
  svg.text(move.x0 + 14.0, 47.0, "largest of any node and frame", "start", kFaint);
  svg.circle(move.x0 + 225.0, 43.0, 3.5, kRms);
  svg.text(move.x0 + 234.0, 47.0, "root mean square", "start", kFaint);
  svg.text(time.x0, 24.0, "wall time with / without", "start", "#222", "font-weight=\"600\"");
  draw_axes(svg, move, time, bottom);
  double y = kTop + 4.0;
  for (const EffectPrice* price : rows) {
    svg.text(16.0, y + 4.0, price->effect + (price->listed ? "" : " (added)"), "start",
             price->listed ? "#222" : kFaint);
    if (compared(*price)) {
      draw_prices(svg, *price, study, move, time, y);
    } else {
      svg.rect(move.x0, y - 9.0, time.x1 - move.x0, 18.0, "#fff");
      svg.text(move.x0, y + 4.0, shortened(price->not_compared, 97), "start", kFaint, "font-style=\"italic\"");
    }
    y += kRow;
  }
  return svg.finish();
}

}  // namespace slipstitch
