// SPDX-License-Identifier: MIT
// The curl and rib checks must fail for models that are wrong in known ways.
#include <gtest/gtest.h>

#include <cstdio>
#include <functional>

#include "force/wrapping.h"
#include "swatch.h"

namespace slipstitch {
namespace {

using test::Swatch;
using test::SwatchSpec;

using Mutation = std::function<Swatch(Model)>;

struct Behaviour {
  double tall_across = 0.0, wide_along = 0.0;  // [1/m]
  double rib_share = 0.0;                      // 1x1 rib's width by stockinette's
  bool as_knitted() const { return tall_across < -50.0 && wide_along > 50.0 && rib_share <= 0.8; }
};

Behaviour behaviour(const char* name, const Effects& effects, const Mutation& at_rest) {
  const auto solve = [&](const char* preset, int courses, int wales) {
    return at_rest(test::flat_swatch({preset, courses, wales, 1, 1, effects}));
  };
  const Swatch wide = solve("stockinette", 6, 18);
  Behaviour b;
  b.tall_across = test::curvature_across_wales(solve("stockinette", 18, 6));
  b.wide_along = test::curvature_along_wales(wide);
  b.rib_share = test::two_stitch_distance(solve("rib", 6, 18)) / test::two_stitch_distance(wide);
  std::printf("%s: tall across wales %.0f /m, wide along wales %.0f /m, rib %.3f of stockinette\n", name, b.tall_across,
              b.wide_along, b.rib_share);
  return b;
}

Swatch with_all_signs_plus(Model model) {
  for (StitchContact& contact : model.topology.contacts) contact.sign = 1;
  return test::bring_to_rest(std::move(model));
}

/// One contact per diagonal, so that each can carry a sign of its own.
void split_diagonals(Topology& topology) {
  std::vector<StitchContact> halves;
  for (const StitchContact& contact : topology.contacts) {
    StitchContact first = contact, second = contact;
    first.q2 = first.q5 = -1;
    second.q3 = second.q4 = -1;
    halves.push_back(first);
    halves.push_back(second);
  }
  topology.contacts = std::move(halves);
}

bool take_sign_of_angle(Topology& topology, const VecX& q) {
  bool changed = false;
  const auto x = [&](int node) { return Vec3(q.segment<3>(3 * node)); };
  for (StitchContact& c : topology.contacts) {
    const bool first = c.q3 >= 0 && c.q4 >= 0, second = c.q2 >= 0 && c.q5 >= 0;
    if (!first && !second) continue;
    const double psi =
        first ? wrap_angle(x(c.q0), x(c.q1), x(c.q3), x(c.q4)) : wrap_angle(x(c.q1), x(c.q0), x(c.q2), x(c.q5));
    const int sign = psi < 0.0 ? -1 : 1;
    changed = changed || sign != c.sign;
    c.sign = sign;
  }
  return changed;
}

/// Minimises the energy of the unsigned angle, 1/2 k_w L (|psi| - psi0)^2 = min over s of 1/2 k_w L (psi - s psi0)^2,
/// by turns in the nodes and in the signs.
Swatch with_unsigned_angle(Model model) {
  split_diagonals(model.topology);
  take_sign_of_angle(model.topology, model.start_q);
  for (int round = 0; round < 50; ++round) {
    Swatch swatch = test::bring_to_rest(model);
    if (!take_sign_of_angle(model.topology, swatch.q)) return swatch;
    model.start_q = swatch.q;
  }
  ADD_FAILURE() << "the signs of the angles do not settle";
  return {};
}

TEST(Mutation, NoneIsAsKnitted) {
  EXPECT_TRUE(behaviour("unchanged", test::knit_effects(), test::bring_to_rest).as_knitted());
}

TEST(Mutation, AllSignsPlus) {
  EXPECT_FALSE(behaviour("all signs +1", test::knit_effects(), with_all_signs_plus).as_knitted());
}

TEST(Mutation, RestAngleZero) {
  Effects effects = test::knit_effects();
  effects.wrapping->rest_angle_rad = 0.0;
  EXPECT_FALSE(behaviour("psi0 = 0", effects, test::bring_to_rest).as_knitted());
}

TEST(Mutation, NoWrapping) {
  Effects effects = test::knit_effects();
  effects.wrapping->alpha = 0.0;
  EXPECT_FALSE(behaviour("k_w = 0", effects, test::bring_to_rest).as_knitted());
}

TEST(Mutation, UnsignedAngle) {
  EXPECT_FALSE(behaviour("unsigned angle", test::knit_effects(), with_unsigned_angle).as_knitted());
}

}  // namespace
}  // namespace slipstitch
