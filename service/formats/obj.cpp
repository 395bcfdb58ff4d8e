// SPDX-License-Identifier: MIT
#include "formats/formats.h"
#include "formats/number_text.h"

namespace slipstitch {
namespace {

void append_yarn(std::string& text, const CurveFrame& frame, int yarn) {
  const int first = frame.first[static_cast<std::size_t>(yarn)];
  const int end = frame.first[static_cast<std::size_t>(yarn) + 1];
  text += "o yarn_" + std::to_string(yarn) + "\n";
  for (int point = first; point < end; ++point) {
    text += "v";
    for (const double coordinate : frame.points[static_cast<std::size_t>(point)]) {
      text += " ";
      append_number(text, coordinate);
    }
    text += "\n";
  }
  if (end - first < 2) return;  // no line
  text += "l";
  for (int point = first; point < end; ++point) text += " " + std::to_string(point + 1);
  text += "\n";
}

}  // namespace

std::string write_obj(const CurveFrame& frame) {
  std::string text = "# slipstitch frame " + std::to_string(frame.index) + ", t = ";
  append_number(text, frame.t);
  text += " s, yarn radius ";
  append_number(text, frame.radius_m);
  text += " m\n# unit: metre\n";
  for (int yarn = 0; yarn < frame.num_yarns(); ++yarn) append_yarn(text, frame, yarn);
  return text;
}

}  // namespace slipstitch
