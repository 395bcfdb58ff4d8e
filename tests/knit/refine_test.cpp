// SPDX-License-Identifier: MIT
// Nodes on free yarn let a loop's curve converge.
#include <gtest/gtest.h>

#include <cstdio>
#include <numeric>

#include "force/yarn_forces.h"
#include "sim/relax.h"
#include "swatch.h"

namespace slipstitch {
namespace {

using test::SwatchSpec;

Knit knit_of(const std::string& preset, int refine) {
  Knit knit;
  knit.pattern = test::pattern_of({preset, 6, 8, 1, 1, test::knit_effects()});
  knit.gauge = {2.9e-3, 2.03e-3, {}};
  knit.refine = refine;
  return knit;
}

RelaxedRepeat relaxed(const std::string& preset, int refine) {
  RelaxedRepeat repeat = relax_repeat(knit_of(preset, refine), YarnMaterial{}, test::knit_effects());
  EXPECT_EQ(repeat.newton.status, NewtonStatus::converged) << preset << " " << refine;
  return repeat;
}

double total(const RelaxedRepeat& repeat) {
  return std::accumulate(repeat.energies_j.begin(), repeat.energies_j.end(), 0.0,
                         [](double sum, const auto& term) { return sum + term.second; });
}

/// Of the nodes that both have [m].
double distance(const RestCell& a, const RestCell& b) {
  double largest = 0.0;
  for (std::size_t n = 0; n < a.node_position.size(); ++n)
    largest = std::max(largest, (a.node_position[n] - b.node_position[n]).norm());
  return largest;
}

VecX gradient(const YarnForces& forces, const VecX& q) {
  VecX sum = VecX::Zero(q.size());
  const auto add = [&](const auto& term) {
    using Term = std::decay_t<decltype(term)>;
    for (int k = 0; k < term.size(); ++k) {
      Vec<Term::kSize> local, g;
      const auto coords = term.coords(k);
      for (int i = 0; i < Term::kSize; ++i) local[i] = q[coords[static_cast<std::size_t>(i)]];
      term.eval(k, local, &g, nullptr);
      for (int i = 0; i < Term::kSize; ++i) sum[coords[static_cast<std::size_t>(i)]] += g[i];
    }
  };
  std::apply([&](const auto&... term) { (add(term), ...); }, forces);
  return sum;
}

/// 1: of a stitch at least three courses and wales from every edge, or on the yarn between two such nodes. (num_nodes)
std::vector<char> nodes_inside(const Topology& topology) {
  std::vector<char> inside(static_cast<std::size_t>(topology.num_nodes), 0);
  const auto is_far = [](int i, int n) { return i > 3 && i <= n - 3; };
  for (const Stitch& stitch : topology.stitches)
    for (const int node : stitch.node)
      if (is_far(stitch.course, topology.num_courses) && is_far(stitch.wale, topology.num_wales))
        inside[static_cast<std::size_t>(node)] = 1;
  const auto at = [&](int visit) -> char& {
    return inside[static_cast<std::size_t>(topology.visit_node[static_cast<std::size_t>(visit)])];
  };
  for (int i = 0; i < topology.num_visits(); ++i) {
    if (!topology.extra(i) || topology.extra(i - 1)) continue;
    int behind = i;
    while (topology.extra(behind)) ++behind;
    for (int j = i; j < behind; ++j) at(j) = static_cast<char>(at(i - 1) && at(behind));
  }
  return inside;
}

class Refined : public testing::TestWithParam<std::string> {};

// Of second order: half as long pieces, a quarter of the change. What a wrap stores does not go away with them.
TEST_P(Refined, ShapeAndEnergyOfARelaxedStitchConverge) {
  constexpr std::array kPieces{1, 2, 4, 8};
  std::vector<RelaxedRepeat> ladder;
  std::vector<double> moved, gained;
  for (const int pieces : kPieces) {
    ladder.push_back(relaxed(GetParam(), pieces - 1));
    const RelaxedRepeat& last = ladder.back();
    std::printf("%s in %d pieces: %.4g mm a wale, %.4g mm a course, %.5g uJ", GetParam().c_str(), pieces,
                1e3 * last.cell.period_course.x() / last.cell.repeat.wales,
                1e3 * last.cell.period_wale.y() / last.cell.repeat.courses, 1e6 * total(last));
    if (ladder.size() > 1) {
      const RelaxedRepeat& before = ladder[ladder.size() - 2];
      moved.push_back(distance(last.cell, before.cell));
      gained.push_back(std::abs(total(last) - total(before)));
      std::printf(", moved by %.3g um", 1e6 * moved.back());
    }
    std::printf("\n");
  }
  for (std::size_t i = 1; i < moved.size(); ++i) {
    EXPECT_LT(moved[i], moved[i - 1] / 3.0);
    EXPECT_LT(gained[i], gained[i - 1] / 3.0);
  }
  EXPECT_LT(moved.back(), 0.1 * YarnMaterial{}.radius_m);
  const double wrapping = ladder.back().energies_j.at("wrapping"), before = ladder[2].energies_j.at("wrapping");
  EXPECT_GT(wrapping, 0.25 * total(ladder.back()));
  EXPECT_NEAR(wrapping, before, 0.01 * wrapping);
}

// Tiled, relaxed stitches are at rest wherever no edge is near, their extra nodes too.
TEST_P(Refined, TheInsideOfASwatchOfRelaxedStitchesIsAtRest) {
  Scene scene;
  scene.knit = knit_of(GetParam(), 3);
  scene.knit->pattern = test::pattern_of({GetParam(), 12, 12, 1, 1, test::knit_effects()});
  scene.effects = test::knit_effects();
  const RestCell cell = relaxed(GetParam(), 3).cell;
  const Model model = compile(scene, &cell);
  const VecX force = gradient(make_forces(model), model.start_q);
  const std::vector<char> inside = nodes_inside(model.topology);
  ASSERT_TRUE(force.allFinite()) << "at the edges too";
  double largest_inside = 0.0, largest = 0.0;
  int nodes = 0;
  for (int n = 0; n < model.topology.num_nodes; ++n) {
    const double here = force.segment<3>(model.topology.x_coord(n)).norm();
    largest = std::max(largest, here);
    if (inside[static_cast<std::size_t>(n)] == 0) continue;
    largest_inside = std::max(largest_inside, here);
    ++nodes;
  }
  EXPECT_GT(nodes, 36 * 16 / 2);
  EXPECT_LT(largest_inside, 1e-6 * largest);
}

INSTANTIATE_TEST_SUITE_P(Knit, Refined, testing::Values("stockinette", "garter", "rib"));

}  // namespace
}  // namespace slipstitch
