// SPDX-License-Identifier: MIT
#include "collide/near_segments.h"

#include <algorithm>
#include <cmath>

#include "collide/closest_point.h"
#include "collide/overlaps.h"
#include "math/bytes.h"

namespace slipstitch {
namespace {

constexpr std::size_t kFew = 16;  // segments for which no tree is worth building

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

double distance_of(const std::array<Vec3, 2>& a, const std::array<Vec3, 2>& b) {
  const SegmentPair close = closest_of_segments(a[0], a[1], b[0], b[1]);
  return (a[0] + close.s * (a[1] - a[0]) - b[0] - close.t * (b[1] - b[0])).norm();
}

}  // namespace

double distance_of_segments(const std::array<int, 6>& a, const std::array<int, 6>& b, const VecX& q) {
  return distance_of({q.segment<3>(a[0]), q.segment<3>(a[3])}, {q.segment<3>(b[0]), q.segment<3>(b[3])});
}

NearSegments::NearSegments(std::vector<std::array<int, 6>> segments, double reach, double margin)
    : segments_(std::move(segments)),
      reach_(reach),
      margin_(margin),
      boxes_(segments_.size()),
      moved_(segments_.size()) {}

long NearSegments::bytes() const { return bytes_of(segments_, place_, boxes_, moved_, pairs_); }

NearSegments::Ends NearSegments::ends_at(std::size_t segment, const VecX& q) const {
  return {q.segment<3>(segments_[segment][0]), q.segment<3>(segments_[segment][3])};
}

void NearSegments::cover(const VecX& q, const VecX& dq, const Touch& touch) {
  if (segments_.empty()) return;
  const bool first = place_.empty();
  if (first) place_.assign(segments_.size(), Ends{Vec3::Zero(), Vec3::Zero()});
  const Way way = measure(q, dq);
  std::vector<int> strays;
  for (std::size_t i = 0; i < segments_.size(); ++i)
    if (first || moved_[i] > margin_) strays.push_back(static_cast<int>(i));
  if (strays.empty()) return;
  ++searches_;
  if (first || strays.size() > kFew) {
    for (std::size_t i = 0; i < segments_.size(); ++i) place(i, q, dq, way);
    search_all(touch);
  } else {
    for (int i : strays) place(idx(i), q, dq, way);
    search_for(strays, touch);
  }
}

NearSegments::Way NearSegments::measure(const VecX& q, const VecX& dq) {
  const double ends = 2.0 * static_cast<double>(segments_.size());
  Way way{Vec3::Zero(), Vec3::Zero()};
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const Ends x = ends_at(i, q), dx = ends_at(i, dq);
    for (std::size_t e : {0, 1}) {
      way.from_mean += (x[e] - place_[i][e]) / ends;
      way.to_mean += (x[e] + dx[e] - place_[i][e]) / ends;
    }
  }
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const Ends x = ends_at(i, q), dx = ends_at(i, dq);
    double furthest2 = 0.0;
    for (std::size_t e : {0, 1}) {
      const Vec3 from = x[e] - place_[i][e];
      furthest2 =
          std::max({furthest2, (from - way.from_mean).squaredNorm(), (from + dx[e] - way.to_mean).squaredNorm()});
    }
    moved_[i] = std::sqrt(furthest2);
  }
  return way;
}

/// Gives a segment a new place, the end of the way. The box has the way too, however far it goes.
void NearSegments::place(std::size_t segment, const VecX& q, const VecX& dq, const Way& way) {
  const Ends x = ends_at(segment, q), dx = ends_at(segment, dq);
  Eigen::AlignedBox3d box;
  double furthest2 = 0.0;
  for (std::size_t e : {0, 1}) {
    const Vec3 from = x[e] - way.from_mean, to = x[e] + dx[e] - way.to_mean;
    box.extend(from);
    box.extend(to);
    place_[segment][e] = to;
    furthest2 = std::max(furthest2, (to - from).squaredNorm());
  }
  moved_[segment] = std::sqrt(furthest2);
  const double around = 0.5 * reach_ + margin_;
  boxes_[segment] = {box.min().array() - around, box.max().array() + around};
}

void NearSegments::add(int a, int b, const Touch& touch) {
  if (a > b) std::swap(a, b);
  const double at = touch(a, b);
  if (at >= 0.0) pairs_.push_back({a, b, at, distance_of(place_[idx(a)], place_[idx(b)])});
}

void NearSegments::search_all(const Touch& touch) {
  pairs_.clear();
  for_each_overlap(boxes_, [&](int a, int b) { add(a, b, touch); });
}

void NearSegments::search_for(std::span<const int> strays, const Touch& touch) {
  const auto stray = [&](int i) { return std::binary_search(strays.begin(), strays.end(), i); };
  std::erase_if(pairs_, [&](const Pair& pair) { return stray(pair.a) || stray(pair.b); });
  for (int a : strays)
    for (int b = 0; b < static_cast<int>(boxes_.size()); ++b)
      if (boxes_[idx(a)].intersects(boxes_[idx(b)]) && (a < b || !stray(b))) add(a, b, touch);
}

}  // namespace slipstitch
