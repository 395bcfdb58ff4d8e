// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "report/svg.h"

namespace slipstitch {

enum class MarkShape { circle, square, triangle, diamond, cross, star };

/// How the points of one curve look.
struct MarkStyle {
  MarkShape shape = MarkShape::circle;
  std::string_view color;
};

/// `hollow`: outline only. `title` is shown by browsers where the pointer is.
void draw_mark(Svg& svg, double x, double y, const MarkStyle& style, bool hollow, std::string_view title);

}  // namespace slipstitch
