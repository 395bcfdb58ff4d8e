// SPDX-License-Identifier: MIT
// Handles, loads and initial velocities of random scenes.
#include <algorithm>
#include <array>

#include "gauntlet/random_parts.h"
#include "model/select.h"

namespace slipstitch::gauntlet {
namespace {

constexpr double kFastest = 20.0;  // [m/s]
constexpr double kMostPull = 0.2;  // of the distance between two handles

class Scripts {
 public:
  Scripts(Draft& draft, const Model& model) : draft_(draft), dice_(draft.dice), model_(model) {}

  void draw() {
    Scene& scene = draft_.scene;
    if (scene.knit) hold_knit();
    for (int y = 0; y < static_cast<int>(scene.yarns.size()); ++y) hold_yarn(y);
    const bool held = !scene.handles.empty();
    if (dice_.chance(held ? 0.35 : 0.15)) add_load();
    if (draft_.moves() && dice_.chance(held ? 0.3 : 0.6)) add_velocity();
  }

 private:
  void hold_knit() {
    const double kind = draft_.moves() ? dice_.unit() : dice_.uniform(0.5, 1.0);
    if (kind < 0.25) return;
    if (kind < 0.5) return move(anywhere(), draft_.radius() * dice_.log_uniform(0.2, 10.0), 1.5);
    const auto [first, second] = opposite();
    pin(first);
    if (kind < 0.8) return move(second, kMostPull * dice_.unit() * distance(first, second), 0.5);
    if (!draft_.moves() || dice_.chance(0.6)) pin(second);
  }

  void hold_yarn(int y) {
    const YarnPoint first{y, 0}, last{y, -1};
    if (!draft_.moves() || dice_.chance(0.7)) pin(first);
    if (draft_.moves() && !dice_.chance(0.6)) return;
    if (dice_.chance(0.5)) return pin(last);
    move(last, 0.5 * kMostPull * dice_.unit() * distance(first, last), 0.5);
  }

  void pin(const Selector& where) {
    Handle& handle = draft_.scene.handles.emplace_back();
    handle.where = where;
    handle.fix_arc_length = dice_.chance(0.2);
    draft_.say("pin");
  }

  /// No farther than `reach` [m], at most `turn` about any axis [rad].
  void move(const Selector& where, double reach, double turn) {
    pin(where);
    Handle& handle = draft_.scene.handles.back();
    reach = std::min({reach, 0.5 * draft_.radius() * draft_.steps, kFastest * draft_.duration_s()});
    if (dice_.chance(0.4)) {
      handle.velocity_m_per_s = reach / draft_.duration_s() * dice_.direction();
      return draft_.say("velocity");
    }
    const int keys = dice_.between(1, 4);
    const double part = keys > 1 ? 0.5 : 1.0;  // from one place to the next may be twice as far
    for (int k = 1; k <= keys; ++k) {
      const Vec3 shift = part * reach * dice_.direction();
      handle.motion.push_back({draft_.duration_s() * k / keys, shift, Vec3::Zero()});
      if (dice_.chance(0.4)) handle.motion.back().rotation_rad = turn * dice_.unit() * dice_.direction();
    }
    draft_.say(std::to_string(keys) + " keyframes");
  }

  void add_load() {
    const double length = model_.topology.rest_arc.back(), gravity = 9.81;  // of one yarn: enough for a size
    const double weight = gravity * length * draft_.scene.yarn.linear_density_kg_per_m;
    const double most = 0.01 * draft_.scene.yarn.stretch_n;
    const Selector where = anywhere();
    const double size = std::min(most, weight * dice_.log_uniform(0.1, 50.0));
    draft_.scene.loads.push_back({where, size * dice_.direction()});
    draft_.say("load");
  }

  void add_velocity() {
    const Selector where = dice_.chance(0.6) ? Selector(AllNodes{}) : anywhere();
    const double speed = std::min(kFastest, draft_.radius_a_step() * dice_.log_uniform(0.01, 2.0));
    draft_.scene.initial_velocities.push_back({where, speed * dice_.direction()});
    draft_.say("initial velocity");
  }

  Selector anywhere() {
    const int yarns = static_cast<int>(draft_.scene.yarns.size()) + (draft_.scene.knit ? 1 : 0);
    const double kind = dice_.unit();
    if (kind < 0.05) return AllNodes{};
    if (kind < 0.3 || !draft_.scene.knit) {
      const int yarn = dice_.between(0, yarns - 1);
      return YarnPoint{yarn, dice_.between(-2, 1)};
    }
    if (kind < 0.5) return dice_.pick(std::array{Corner::bottom_left, Corner::bottom_right, Corner::top_left});
    if (kind < 0.8) return dice_.pick(std::array{Edge::bottom, Edge::top, Edge::left, Edge::right});
    const Pattern& pattern = draft_.scene.knit->pattern;
    StitchRange range;
    range.first_course = dice_.between(1, pattern.courses);
    range.last_course = dice_.between(range.first_course, pattern.courses);
    range.first_wale = dice_.between(1, pattern.wales);
    range.last_wale = dice_.between(range.first_wale, pattern.wales);
    return range;
  }

  /// Two ends of the knit.
  std::pair<Selector, Selector> opposite() {
    const Pattern& pattern = draft_.scene.knit->pattern;
    if (pattern.in_the_round) return {Edge::bottom, Edge::top};
    if (draft_.moves() && dice_.chance(0.3)) return {Corner::top_left, Corner::bottom_right};
    if (draft_.moves() && dice_.chance(0.2)) return {Corner::top_left, Corner::top_right};
    if (dice_.chance(0.5)) return {Edge::top, Edge::bottom};
    return {Edge::left, Edge::right};
  }

  Vec3 middle(const Selector& where) const {
    const std::vector<int> nodes = select_nodes(where, model_.topology);
    Vec3 sum = Vec3::Zero();
    for (const int n : nodes) sum += model_.start_q.segment<3>(3 * n);
    return sum / static_cast<double>(nodes.size());
  }
  double distance(const Selector& a, const Selector& b) const { return (middle(a) - middle(b)).norm(); }

  Draft& draft_;
  Dice& dice_;
  const Model& model_;
};

}  // namespace

void draw_scripts(Draft& draft, const Model& model) { Scripts(draft, model).draw(); }

}  // namespace slipstitch::gauntlet
