// SPDX-License-Identifier: MIT
#include "sim/monitor.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "force/self_collision.h"
#include "force/stretch.h"
#include "force/wrapping.h"
#include "model/check_values.h"
#include "sim/describe_place.h"

namespace slipstitch {
namespace {

constexpr int kInteriorMargin = 2;  // courses and wales from every edge

Vec<12> gather(const std::array<int, 12>& coords, const VecX& q) {
  Vec<12> x;
  for (int i = 0; i < 12; ++i) x[i] = q[coords[static_cast<std::size_t>(i)]];
  return x;
}

bool interior(const Topology& topo, const StitchContact& contact) {
  if (contact.stitch < 0) return false;
  const Stitch& s = topo.stitches[static_cast<std::size_t>(contact.stitch)];
  return s.course > kInteriorMargin && s.course <= topo.num_courses - kInteriorMargin && s.wale > kInteriorMargin &&
         s.wale <= topo.num_wales - kInteriorMargin;
}

constexpr double kFadedAway = 1e-12;  // what is left of a wrap changes no energy, and its angle means nothing

void count_entry(bool inside, char& before, long& entries) {
  if (inside && !before) ++entries;
  before = inside ? 1 : 0;
}

struct FadeCount {
  int wraps = 0, faded = 0;
  std::optional<double> share() const {
    if (wraps == 0) return std::nullopt;
    return static_cast<double>(faded) / wraps;
  }
};

}  // namespace

Monitor::Monitor(const Simulation& sim)
    : start_arc_(sim.state().q.tail(sim.model().topology.num_visits())),
      min_gap_ratio_(std::numeric_limits<double>::infinity()) {
  observe_segments(sim);
  observe_wraps(sim);
  ridge_entries_ = fade_entries_ = crushed_entries_ = 0;
  min_gap_ratio_ = std::numeric_limits<double>::infinity();
  max_stretch_ = 0.0;
}

std::optional<std::string> Monitor::observe(const Simulation& sim, double residual) {
  residual_ = std::fmax(residual_, residual);  // of the first step where there was none before
  observe_segments(sim);
  observe_wraps(sim);
  return pulled_out(sim);
}

void Monitor::observe_segments(const Simulation& sim) {
  const Topology& topo = sim.model().topology;
  const VecX& q = sim.state().q;
  const Stretch& stretch = term_of<Stretch>(sim.forces());
  const double factor = stretch.length_factor();
  crushed_.resize(static_cast<std::size_t>(topo.num_visits()), 0);
  for (int i = 0; i + 1 < topo.num_visits(); ++i) {
    const auto v = static_cast<std::size_t>(i);
    if (topo.segment_kind[v] == SegmentKind::none) continue;
    const double arc = q[topo.arc_coord(i + 1)] - q[topo.arc_coord(i)];
    const Vec3 d = q.segment<3>(topo.x_coord(topo.visit_node[v + 1])) - q.segment<3>(topo.x_coord(topo.visit_node[v]));
    min_gap_ratio_ = std::min(min_gap_ratio_, arc / rest_length(topo, i));
    const double lambda = d.norm() / (factor * arc);
    max_stretch_ = std::max(max_stretch_, lambda);
    count_entry(stretch.size() > 0 && lambda < kCrushed, crushed_[v], crushed_entries_);
  }
}

void Monitor::observe_wraps(const Simulation& sim) {
  const auto& wraps = term_of<Wrapping>(sim.forces());
  in_cap_.resize(static_cast<std::size_t>(wraps.size()), 0);
  faded_.resize(in_cap_.size(), 0);
  for (int k = 0; k < wraps.size(); ++k) {
    const Vec<12> x = gather(wraps.coords(k), sim.state().q);
    const double psi = wrap_angle(x.segment<3>(0), x.segment<3>(3), x.segment<3>(6), x.segment<3>(9));
    const auto i = static_cast<std::size_t>(k);
    const double fade = wrap_fade(x, wraps.wrap(k).L);
    count_entry(fade > kFadedAway && wrap_in_cap(wrap_excess(psi, wraps.wrap(k).rest)), in_cap_[i], ridge_entries_);
    count_entry(fade < 1.0, faded_[i], fade_entries_);
  }
}

std::optional<std::string> Monitor::pulled_out(const Simulation& sim) const {
  const Topology& topo = sim.model().topology;
  const VecX arc = sim.state().q.tail(topo.num_visits());
  const double reach = sim.model().yarn.radius_m;
  for (int yarn = 0; yarn < topo.num_yarns(); ++yarn) {
    const auto y = static_cast<std::size_t>(yarn);
    const int first = topo.yarn_first[y], last = topo.yarn_first[y + 1] - 1;
    for (int visit = first + 1; visit < last; ++visit) {
      if (!topo.visit_slides[static_cast<std::size_t>(visit)]) continue;
      if (arc[visit] - arc[first] > reach && arc[last] - arc[visit] > reach) continue;
      return "a yarn end was pulled to within one radius of the contact at " + describe_visit(topo, yarn, visit) +
             " at t = " + number_text(sim.state().t) + " s";
    }
  }
  return std::nullopt;
}

void Monitor::report(const Simulation& sim, RunSummary& summary) const {
  const Topology& topo = sim.model().topology;
  const VecX& q = sim.state().q;
  summary.residual = residual_;
  if (std::isfinite(min_gap_ratio_)) {
    summary.min_arc_gap_ratio = min_gap_ratio_;
    summary.max_stretch = max_stretch_;
    summary.crushed_entries = crushed_entries_;
  }
  if (sim.model().effects.sliding && !std::isnan(residual_)) {
    double sum = 0.0, largest = 0.0;
    int count = 0;
    for (int i = 0; i < topo.num_visits(); ++i) {
      if (!topo.visit_slides[static_cast<std::size_t>(i)]) continue;
      const double slid = std::abs(q[topo.arc_coord(i)] - start_arc_[i]);
      sum += slid;
      largest = std::max(largest, slid);
      ++count;
    }
    summary.max_slid_m = largest;
    summary.mean_slid_m = count > 0 ? sum / count : 0.0;
  }
  if (sim.model().effects.self_collision)
    summary.self_collision_start_overlaps = term_of<SelfCollision>(sim.forces()).start_overlaps();
  const auto& wraps = term_of<Wrapping>(sim.forces());
  if (wraps.size() == 0) return;
  FadeCount all, inner;
  for (int k = 0; k < wraps.size(); ++k) {
    const bool faded = wrap_fade(gather(wraps.coords(k), q), wraps.wrap(k).L) < 1.0;
    const bool inside = interior(topo, topo.contacts[static_cast<std::size_t>(wraps.contact(k))]);
    all.wraps += 1;
    all.faded += faded;
    inner.wraps += inside;
    inner.faded += inside && faded;
  }
  summary.faded_wrap_share = all.share();
  summary.faded_wrap_share_interior = inner.share();
  summary.wrap_ridge_entries = ridge_entries_;
  summary.wrap_fade_entries = fade_entries_;
}

std::string state_hash(const VecX& q) {
  std::uint64_t hash = 1469598103934665603ULL;
  for (const double value : q) {
    auto bits = std::bit_cast<std::uint64_t>(value);
    for (int byte = 0; byte < 8; ++byte, bits >>= 8) hash = (hash ^ (bits & 0xff)) * 1099511628211ULL;
  }
  std::string text(16, '0');
  for (int digit = 15; digit >= 0; --digit, hash >>= 4) text[static_cast<std::size_t>(digit)] = "0123456789abcdef"[hash & 15];
  return text;
}

}  // namespace slipstitch
