// SPDX-License-Identifier: MIT
#include "report/plot_marks.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace slipstitch {
namespace {

constexpr double kRadius = 5.0;

struct Point {
  double x, y;
};

/// Corners at a radius of 1, y down.
std::vector<Point> corners(MarkShape shape) {
  constexpr double kArm = 0.42;  // half the width of a cross's arms
  std::vector<Point> points;
  switch (shape) {
    case MarkShape::circle:
      break;
    case MarkShape::square:
      return {{-0.88, -0.88}, {0.88, -0.88}, {0.88, 0.88}, {-0.88, 0.88}};
    case MarkShape::triangle:
      return {{0.0, -1.15}, {1.05, 0.75}, {-1.05, 0.75}};
    case MarkShape::diamond:
      return {{0.0, -1.2}, {1.2, 0.0}, {0.0, 1.2}, {-1.2, 0.0}};
    case MarkShape::cross:
      return {{-kArm, -1.1}, {kArm, -1.1}, {kArm, -kArm}, {1.1, -kArm}, {1.1, kArm},   {kArm, kArm},
              {kArm, 1.1},   {-kArm, 1.1}, {-kArm, kArm}, {-1.1, kArm}, {-1.1, -kArm}, {-kArm, -kArm}};
    case MarkShape::star:
      for (int i = 0; i < 10; ++i) {
        const double radius = i % 2 == 0 ? 1.3 : 0.6, angle = std::numbers::pi * (i / 5.0 - 0.5);
        points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
      }
      break;
  }
  return points;
}

}  // namespace

void draw_mark(Svg& svg, double x, double y, const MarkStyle& style, bool hollow, std::string_view title) {
  const std::string color(style.color);
  const std::string paint = hollow ? "fill=\"#fff\" stroke=\"" + color + "\" stroke-width=\"1.6\""
                                   : "fill=\"" + color + "\" stroke=\"#fff\" stroke-width=\"0.8\"";
  std::string element;
  if (style.shape == MarkShape::circle) {
    element = "<circle cx=\"" + coordinate(x) + "\" cy=\"" + coordinate(y) + "\" r=\"" + coordinate(kRadius) + "\" ";
  } else {
    element = "<polygon points=\"";
    for (const Point& p : corners(style.shape))
      element +=
          (element.back() == '"' ? "" : " ") + coordinate(x + kRadius * p.x) + "," + coordinate(y + kRadius * p.y);
    element += "\" ";
  }
  const char* name = style.shape == MarkShape::circle ? "circle" : "polygon";
  svg.raw(element + paint + "><title>" + escaped(title) + "</title></" + name + ">\n");
}

}  // namespace slipstitch
