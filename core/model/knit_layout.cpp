// SPDX-License-Identifier: MIT
#include "model/knit_layout.h"

#include <numeric>

namespace slipstitch {
namespace {

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

// Polyline length of one repeat.
double cell_polyline(const RestCell& cell) {
  double total = 0.0;
  for (int c = 1; c <= cell.repeat.courses; ++c) {
    for (int w = 1; w <= cell.repeat.wales; ++w) {
      for (std::size_t k = 0; k < kLoopNodes.size(); ++k) {
        const LoopNode from = kLoopNodes[k], to = kLoopNodes[(k + 1) % kLoopNodes.size()];
        const int next_wale = k + 1 < kLoopNodes.size() ? w : w + 1;
        total += (cell.position(c + to.course_above, next_wale, to.base) -
                  cell.position(c + from.course_above, w, from.base))
                     .norm();
      }
    }
  }
  return total;
}

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

}  // namespace

KnitLayout::KnitLayout(const Pattern& pattern, const RestCell& cell)
    : cell_(cell),
      courses_(pattern.courses),
      wales_(pattern.wales),
      in_the_round_(pattern.in_the_round),
      bind_off_(kNodesPerStitch * courses_ * wales_),
      turns_(bind_off_ + 2 * (wales_ + 1)),
      tails_(turns_ + (in_the_round_ ? 0 : 2 * (courses_ - 1))),
      rest_ratio_(sum(cell.start_length) / cell_polyline(cell)),
      position_(idx(num_nodes())) {
  for (int c = 1; c <= courses_; ++c) {
    for (int w = 1; w <= wales_; ++w) {
      for (const BaseNode node : {kBaseLeft1, kBaseLeft2, kBaseRight1, kBaseRight2}) {
        position_[idx(base(c, w, node))] = plane_position(c, w, node);
      }
    }
  }
  place_bind_off();
  place_turns();
  place_tails();
}

// In the round courses run -x and climb by one course pitch a turn.
Vec3 KnitLayout::plane_position(int course, int wale, BaseNode node) const {
  const Vec3 x = cell_.position(course, wale, node);
  if (!in_the_round_) return x;
  const Vec3 pitch = cell_.period_wale / cell_.repeat.courses;
  return x + pitch * (static_cast<double>(wales_ - wale) / wales_);
}

void KnitLayout::place_bind_off() {
  for (const bool top : {false, true}) {
    const BaseNode left_head = top ? kBaseLeft2 : kBaseLeft1, right_head = top ? kBaseRight2 : kBaseRight1;
    position_[idx(bind_off(0, top))] = plane_position(courses_ + 1, 1, left_head);
    position_[idx(bind_off(wales_, top))] = plane_position(courses_ + 1, wales_, right_head);
    for (int w = 1; w < wales_; ++w) {
      position_[idx(bind_off(w, top))] =
          0.5 * (plane_position(courses_ + 1, w, right_head) + plane_position(courses_ + 1, w + 1, left_head));
    }
  }
}

// At the middles of the sinkers that would lead to the next stitch.
void KnitLayout::place_turns() {
  if (in_the_round_) return;
  for (int c = 1; c < courses_; ++c) {
    const int left_wale = c % 2 == 1 ? 0 : wales_;
    for (const bool upper : {false, true}) {
      const int course = upper ? c + 1 : c;
      position_[idx(turn(c, upper))] =
          0.5 * (cell_.position(course, left_wale, kBaseRight1) + cell_.position(course, left_wale + 1, kBaseLeft1));
    }
  }
}

// Straight on from the last segment when flat, so that the ends start unbent; outwards when round, clear of the fabric.
void KnitLayout::place_tails() {
  const double length = sum(cell_.start_length) / cell_.stitches() / rest_ratio_;
  const auto tail_from = [&](int before, int last) {
    const Vec3 way = in_the_round_ ? Vec3(0.0, 0.0, 1.0) : position_[idx(last)] - position_[idx(before)];
    return Vec3(position_[idx(last)] + length * way.normalized());
  };
  const bool ends_left = in_the_round_ || courses_ % 2 == 1;
  position_[idx(tail(false))] = tail_from(base(1, wales_, kBaseRight2), base(1, wales_, kBaseRight1));
  position_[idx(tail(true))] = ends_left ? tail_from(base(courses_, 1, kBaseLeft2), base(courses_, 1, kBaseLeft1))
                                         : tail_from(base(courses_, wales_, kBaseRight2), base(courses_, wales_, kBaseRight1));
}

int KnitLayout::loop_node(int course, int wale, int k) const {
  const LoopNode node = kLoopNodes[idx(k)];
  if (node.course_above == 0) return base(course, wale, node.base);
  if (course < courses_) return base(course + 1, wale, node.base);
  const bool left = node.base == kBaseLeft1 || node.base == kBaseLeft2;
  return bind_off(left ? wale - 1 : wale, node.base == kBaseLeft2 || node.base == kBaseRight2);
}

bool KnitLayout::in_clasp(int node) const {
  const bool cast_on = node < base(2, 1, kBaseLeft1);
  const bool outermost_head = node == bind_off(0, false) || node == bind_off(0, true) ||
                              node == bind_off(wales_, false) || node == bind_off(wales_, true);
  return !cast_on && !outermost_head && node < turns_;
}

}  // namespace slipstitch
