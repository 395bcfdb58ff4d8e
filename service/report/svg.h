// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace slipstitch {

/// &, <, > and quotes as SVG and HTML want them.
std::string escaped(std::string_view text);

/// A drawing in pixels, y down, on white.
class Svg {
 public:
  Svg(double width, double height, std::string_view title);

  void rect(double x, double y, double width, double height, std::string_view fill);
  void line(double x1, double y1, double x2, double y2, std::string_view stroke, double width = 1.0);
  void circle(double x, double y, double radius, std::string_view fill);
  /// anchor: start, middle or end. style: more attributes, e.g. font-weight="600".
  void text(double x, double y, std::string_view text, std::string_view anchor = "start",
            std::string_view fill = "#222", std::string_view style = "");
  /// Anything else, well-formed.
  void raw(std::string_view element) { body_ += element; }

  std::string finish() const { return body_ + "</svg>\n"; }

 private:
  std::string body_;
};

/// A coordinate with at most two decimals.
std::string coordinate(double value);

}  // namespace slipstitch
