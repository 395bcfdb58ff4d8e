// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "report/number_text.h"
#include "report/plot_marks.h"
#include "report/study_columns.h"
#include "report/study_report.h"
#include "report/svg.h"

namespace slipstitch {
namespace {

constexpr double kWidth = 960.0, kHeight = 540.0, kLeft = 84.0, kRight = 760.0, kTop = 64.0, kBottom = 484.0;
constexpr double kLabelX = 782.0, kLabelSpace = 17.0;
constexpr std::string_view kGrid = "#e3e3e3", kFaint = "#777", kFront = "#f6dc8a";

struct MethodStyle {
  std::string_view method;
  MarkStyle style;
};
constexpr std::array kStyles{MethodStyle{"LINEARISED_EULER", {MarkShape::cross, "#555555"}},
                             MethodStyle{"IMPLICIT_EULER", {MarkShape::square, "#c05621"}},
                             MethodStyle{"BDF2", {MarkShape::triangle, "#2f855a"}},
                             MethodStyle{"SDIRK2", {MarkShape::circle, "#2b6cb0"}},
                             MethodStyle{"IMPLICIT_MIDPOINT", {MarkShape::diamond, "#7b45b8"}},
                             MethodStyle{"STATIC", {MarkShape::circle, "#2b6cb0"}},
                             MethodStyle{"ACCURACY", {MarkShape::star, "#c2185b"}}};

MarkStyle style_of(std::string_view method) {
  for (const MethodStyle& entry : kStyles)
    if (entry.method == method) return entry.style;
  return {MarkShape::circle, "#222222"};
}

struct Axis {
  double low = 1.0, high = 10.0, from = 0.0, to = 1.0;  // values, pixels
  double at(double value) const {
    return from + (to - from) * std::clamp(std::log(value / low) / std::log(high / low), 0.0, 1.0);
  }
  double decades() const { return std::log10(high / low); }
};

struct Mark {
  const RungResult* result;
  double cost, error;
};

std::vector<Mark> marks_of(const WorkPrecision& study, StudyAxis axis) {
  std::vector<Mark> marks;
  for (const RungResult& r : study.rungs) {
    const double cost = axis == StudyAxis::wall_time ? r.wall_s : static_cast<double>(r.newton_iterations);
    if (r.errors && std::isfinite(r.errors->position_m) && cost > 0.0)
      marks.push_back({&r, cost, r.errors->position_m});
  }
  return marks;
}

Axis cost_axis(const std::vector<Mark>& marks) {
  const auto [least, most] =
      std::minmax_element(marks.begin(), marks.end(), [](const Mark& a, const Mark& b) { return a.cost < b.cost; });
  const double range = std::max(1.5, most->cost / least->cost);
  return {least->cost * std::pow(range, -0.09), most->cost * std::pow(range, 0.04), kLeft, kRight};  // room for labels
}

/// With the error of the reference, if that is not far below.
Axis error_axis(const std::vector<Mark>& marks, const std::optional<double>& reference_m) {
  double low = 1.0, high = 1e-15;
  for (const Mark& mark : marks) {
    if (mark.error > 0.0) low = std::min(low, mark.error);
    high = std::max(high, mark.error);
  }
  if (low > high) low = 0.1 * high;  // no error at all
  low = std::min(low, std::max(reference_m.value_or(low), 0.1 * low));
  return {std::pow(10.0, std::floor(std::log10(low) - 1e-9)), std::pow(10.0, std::ceil(std::log10(high) + 1e-9)),
          kBottom, kTop};
}

void draw_grid(Svg& svg, const Axis& cost, const Axis& error, StudyAxis axis) {
  const bool sparse = cost.decades() > 2.5;
  for (int k = static_cast<int>(std::floor(std::log10(cost.low))); k <= static_cast<int>(std::log10(cost.high)) + 1;
       ++k)
    for (const double digit : {1.0, 2.0, 5.0}) {
      const double value = digit * std::pow(10.0, k);
      if (value < cost.low || value > cost.high || (sparse && digit > 1.0)) continue;
      svg.line(cost.at(value), kTop, cost.at(value), kBottom, kGrid);
      const std::string text =
          axis == StudyAxis::wall_time ? short_number(value) + " s" : thousands(std::lround(value));
      svg.text(cost.at(value), kBottom + 18.0, text, "middle", kFaint);
    }
  const int decades = static_cast<int>(std::lround(error.decades()));
  for (int k = 0; k <= decades; ++k) {
    const double value = error.low * std::pow(10.0, k);
    svg.line(kLeft, error.at(value), kRight, error.at(value), kGrid);
    svg.text(kLeft - 8.0, error.at(value) + 4.0, metres_text(value), "end", kFaint);
  }
}

void draw_level(Svg& svg, const Axis& error, double value, const std::string& text) {
  if (!(value > error.low && value < error.high)) return;
  const double y = error.at(value);
  svg.raw("<line x1=\"" + coordinate(kLeft) + "\" y1=\"" + coordinate(y) + "\" x2=\"" + coordinate(kRight) +
          "\" y2=\"" + coordinate(y) + "\" stroke=\"#999\" stroke-dasharray=\"2 4\"/>\n");
  svg.text(kLeft + 6.0, y - 5.0, text, "start", kFaint, "font-size=\"11\"");
}

std::string polyline(const std::vector<Mark>& marks, const Axis& cost, const Axis& error, const std::string& style) {
  std::string points;
  for (const Mark& mark : marks)
    points += (points.empty() ? "" : " ") + coordinate(cost.at(mark.cost)) + "," + coordinate(error.at(mark.error));
  return "<polyline points=\"" + points + "\" fill=\"none\" " + style + "/>\n";
}

/// Those than which no other is both more accurate and cheaper on this axis, by falling error.
std::vector<Mark> front_of(const std::vector<Mark>& marks) {
  std::vector<Mark> front;
  for (const Mark& a : marks)
    if (std::none_of(marks.begin(), marks.end(), [&](const Mark& b) {
          return b.error <= a.error && b.cost <= a.cost && (b.error < a.error || b.cost < a.cost);
        }))
      front.push_back(a);
  std::sort(front.begin(), front.end(), [](const Mark& a, const Mark& b) { return a.error > b.error; });
  return front;
}

void draw_front(Svg& svg, const std::vector<Mark>& all, const Axis& cost, const Axis& error) {
  const std::vector<Mark> marks = front_of(all);
  svg.raw(polyline(
      marks, cost, error,
      "stroke=\"" + std::string(kFront) + "\" stroke-width=\"13\" stroke-linecap=\"round\" stroke-linejoin=\"round\""));
  for (const Mark& mark : marks) svg.circle(cost.at(mark.cost), error.at(mark.error), 9.0, kFront);
}

/// Left and below, where the front leaves room; not where two would meet.
void label_front(Svg& svg, const std::vector<Mark>& all, const Axis& cost, const Axis& error) {
  constexpr double kTall = 13.0, kLong = 60.0;
  double last_x = -kLong, last_y = -kTall;
  for (const Mark& mark : front_of(all)) {
    const double x = cost.at(mark.cost) - 10.0, y = error.at(mark.error) + 19.0;
    if (std::abs(x - last_x) < kLong && std::abs(y - last_y) < kTall) continue;
    svg.text(x, y, mark.result->rung.label, "end", kFaint, "font-size=\"11\"");
    last_x = x;
    last_y = y;
  }
}

struct Label {
  std::string_view method;
  double x, y, label_y;
};

/// Labels in one column, none over another, each as near as can be to the height of its curve's end.
void spread(std::vector<Label>& labels) {
  std::sort(labels.begin(), labels.end(), [](const Label& a, const Label& b) { return a.y < b.y; });
  double last = kTop - kLabelSpace;
  for (Label& label : labels) last = label.label_y = std::max(label.y, last + kLabelSpace);
  double next = kBottom + kLabelSpace;
  for (auto label = labels.rbegin(); label != labels.rend(); ++label)
    next = label->label_y = std::min(label->label_y, next - kLabelSpace);
}

std::string title_of(const Mark& mark) {
  const RungResult& r = *mark.result;
  return rung_name(r.rung) + ": " + error_text(mark.error) + ", " + duration_text(r.wall_s) + ", " +
         thousands(r.newton_iterations) + " Newton iterations";
}

void draw_curves(Svg& svg, const std::vector<Mark>& marks, const Axis& cost, const Axis& error) {
  std::vector<Label> labels;
  for (const MethodStyle& entry : kStyles) {
    std::vector<Mark> curve;
    for (const Mark& mark : marks)
      if (mark.result->rung.method == entry.method) curve.push_back(mark);
    if (curve.empty()) continue;
    const std::string color(entry.style.color);
    if (entry.method != kStaticMethod)
      svg.raw(polyline(curve, cost, error, "stroke=\"" + color + "\" stroke-width=\"1.6\""));
    const Mark& end = curve.back();
    labels.push_back({entry.method, cost.at(end.cost), error.at(end.error), 0.0});
  }
  spread(labels);
  for (const Label& label : labels) {
    const MarkStyle style = style_of(label.method);
    svg.raw("<polyline points=\"" + coordinate(label.x + 8.0) + "," + coordinate(label.y) + " " +
            coordinate(kRight + 4.0) + "," + coordinate(label.label_y) + " " + coordinate(kLabelX - 4.0) + "," +
            coordinate(label.label_y) + "\" fill=\"none\" stroke=\"" + std::string(style.color) +
            "\" stroke-width=\"0.8\" stroke-dasharray=\"1 3\"/>\n");
    draw_mark(svg, kLabelX + 4.0, label.label_y, style, false, label.method);
    svg.text(kLabelX + 16.0, label.label_y + 4.0, label.method, "start", style.color, "font-weight=\"600\"");
  }
  for (const Mark& mark : marks)
    draw_mark(svg, cost.at(mark.cost), error.at(mark.error), style_of(mark.result->rung.method), !mark.result->resolved,
              title_of(mark));
}

}  // namespace

std::string study_plot(const WorkPrecision& study, StudyAxis axis) {
  const std::string over = axis == StudyAxis::wall_time ? "wall time" : "Newton iterations";
  Svg svg(kWidth, kHeight, study.scene + ": error of positions against " + over);
  svg.text(16.0, 24.0, study.scene, "start", "#222", "font-size=\"15\" font-weight=\"600\"");
  svg.text(kLeft, 46.0,
           "largest error of any position" +
               (study.horizon_s ? " up to " + short_number(*study.horizon_s) + " s" : std::string()),
           "start", "#222", "font-weight=\"600\"");
  svg.text(kRight, kBottom + 40.0, over, "end", "#222", "font-weight=\"600\"");
  const std::vector<Mark> marks = marks_of(study, axis);
  if (marks.empty()) {
    svg.text(0.5 * kWidth, 0.5 * kHeight, "nothing to compare", "middle", kFaint);
    return svg.finish();
  }
  const Axis cost = cost_axis(marks), error = error_axis(marks, study.reference.error_m);
  draw_grid(svg, cost, error, axis);
  draw_level(svg, error, study.radius_m, "radius of the yarn");
  if (study.reference.error_m) draw_level(svg, error, *study.reference.error_m, "error of the reference");
  draw_front(svg, marks, cost, error);
  label_front(svg, marks, cost, error);
  draw_curves(svg, marks, cost, error);
  svg.rect(kLabelX, kBottom - 10.0, 18.0, 10.0, kFront);
  svg.text(kLabelX + 24.0, kBottom - 1.0, "front", "start", kFaint);
  svg.text(kLabelX, kBottom + 18.0, "hollow: not resolved", "start", kFaint);
  return svg.finish();
}

}  // namespace slipstitch
