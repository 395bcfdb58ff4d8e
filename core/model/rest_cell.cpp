// SPDX-License-Identifier: MIT
#include "model/rest_cell.h"

#include "model/drawn_loop.h"

namespace slipstitch {
namespace {

// Stockinette of worsted acrylic near zero force, Singal et al. 2024: cell and true yarn length of a stitch.
constexpr double kDefaultWidth = 2.9e-3;
constexpr double kDefaultHeight = 2.03e-3;
constexpr double kDefaultYarnPerStitch = 11.28e-3;

int floor_div(int a, int b) { return (a >= 0 ? a : a - b + 1) / b; }
int floor_mod(int a, int b) { return a - floor_div(a, b) * b; }

DrawnLoop loop_of(const Gauge& gauge, double radius) {
  if (gauge.yarn_per_stitch_m) {
    const double scale = *gauge.yarn_per_stitch_m / kDefaultYarnPerStitch;
    return draw_loop(scale * kDefaultWidth, scale * kDefaultHeight, radius);
  }
  return draw_loop(gauge.course_spacing_m.value_or(kDefaultWidth), gauge.wale_spacing_m.value_or(kDefaultHeight),
                   radius);
}

struct Signs {
  const Pattern& pattern;
  Repeat repeat;
  double at(int course, int wale) const {
    const int c = floor_mod(course - 1, repeat.courses) + 1, w = floor_mod(wale - 1, repeat.wales) + 1;
    return pattern.at(c, w) == StitchKind::knit ? 1.0 : -1.0;
  }
};

void place_nodes(const DrawnLoop& loop, const Signs& signs, RestCell& cell) {
  for (int c = 1; c <= cell.repeat.courses; ++c) {
    for (int w = 1; w <= cell.repeat.wales; ++w) {
      const double x = (w - 0.5) * loop.width_m, y = (c - 1) * loop.height_m, z = signs.at(c, w) * loop.z;
      cell.node_position.emplace_back(x - loop.p1_x, y, z);
      cell.node_position.emplace_back(x - loop.p2_x, y + loop.p2_y, z);
      cell.node_position.emplace_back(x + loop.p1_x, y, z);
      cell.node_position.emplace_back(x + loop.p2_x, y + loop.p2_y, z);
    }
  }
}

// Calls f(from, to) with the ends of every segment of the polyline, in the cell's order.
template <class F>
void for_each_segment(const RestCell& cell, F&& f) {
  for (int c = 1; c <= cell.repeat.courses; ++c) {
    for (int w = 1; w <= cell.repeat.wales; ++w) {
      for (std::size_t k = 0; k < kVisitsPerStitch; ++k) {
        const LoopNode from = kLoopNodes[k], to = kLoopNodes[(k + 1) % kVisitsPerStitch];
        const int next_wale = k + 1 < kVisitsPerStitch ? w : w + 1;
        f(cell.position(c + from.course_above, w, from.base), cell.position(c + to.course_above, next_wale, to.base));
      }
    }
  }
}

// Lengths of the polyline's segments; returns their sum.
double measure_segments(RestCell& cell) {
  double total = 0.0;
  for_each_segment(cell, [&](const Vec3& from, const Vec3& to) {
    cell.rest_length.push_back((to - from).norm());
    total += cell.rest_length.back();
  });
  return total;
}

void place_between(int extra_nodes, RestCell& cell) {
  cell.extra_nodes = extra_nodes;
  for_each_segment(cell, [&](const Vec3& from, const Vec3& to) {
    for (int piece = 1; piece <= extra_nodes; ++piece)
      cell.between.push_back(from + piece / (extra_nodes + 1.0) * (to - from));
  });
}

double true_length(const DrawnLoop& loop, const Signs& signs) {
  double total = 0.0;
  for (int c = 1; c <= signs.repeat.courses; ++c) {
    for (int w = 1; w <= signs.repeat.wales; ++w) {
      const LoopFaces faces{signs.at(c, w), signs.at(c + 1, w), signs.at(c, w - 1), signs.at(c, w + 1)};
      total += centreline_length(loop, faces);
    }
  }
  return total;
}

}  // namespace

int RestCell::stitch_at(int course, int wale) const {
  return floor_mod(course - 1, repeat.courses) * repeat.wales + floor_mod(wale - 1, repeat.wales);
}

Vec3 RestCell::shift_of(int course, int wale) const {
  return floor_div(wale - 1, repeat.wales) * period_course + floor_div(course - 1, repeat.courses) * period_wale;
}

Vec3 RestCell::position(int course, int wale, BaseNode node) const {
  const std::size_t master = static_cast<std::size_t>(kNodesPerStitch * stitch_at(course, wale) + node);
  return node_position[master] + shift_of(course, wale);
}

Vec3 RestCell::position_between(int course, int wale, int segment, int piece) const {
  const int s = kVisitsPerStitch * stitch_at(course, wale) + segment;
  return between[static_cast<std::size_t>(s * extra_nodes + piece - 1)] + shift_of(course, wale);
}

RestCell drawn_cell(const Pattern& pattern, const Gauge& gauge, const YarnMaterial& yarn, int extra_nodes) {
  const DrawnLoop loop = loop_of(gauge, yarn.radius_m);
  RestCell cell;
  cell.repeat = smallest_repeat(pattern);
  cell.period_course = cell.repeat.wales * loop.width_m * Vec3::UnitX();
  cell.period_wale = cell.repeat.courses * loop.height_m * Vec3::UnitY();
  const Signs signs{pattern, cell.repeat};
  place_nodes(loop, signs, cell);
  const double drawn = measure_segments(cell);
  place_between(extra_nodes, cell);
  const double yarn_length = true_length(loop, signs);
  cell.density_scale = yarn_length / drawn;
  if (gauge.yarn_per_stitch_m) {
    const double factor = *gauge.yarn_per_stitch_m * cell.stitches() / yarn_length;
    for (double& length : cell.rest_length) length *= factor;
  }
  cell.start_length = cell.rest_length;
  return cell;
}

}  // namespace slipstitch
