// SPDX-License-Identifier: MIT
#include "force/wrapping.h"
#include "golden_file.h"

namespace slipstitch::golden {
namespace {

constexpr std::array<const char*, 4> kNodes{"x0", "x1", "x3", "x4"};

Vec<12> stacked(const Json& by_node) {
  Vec<12> q;
  for (int i = 0; i < 4; ++i) q.segment<3>(3 * i) = vec<3>(by_node.at(kNodes[static_cast<std::size_t>(i)]));
  return q;
}

TEST(WrappingGolden, BareKernelMatches) {
  const Json cases = load_cases("wrapping_golden.json");
  expect_categories(cases, {"generic", "near_zero", "near_pi", "skinny_one", "skinny_both", "short_stitch", "knit_mm",
                            "near_rest", "axis_aligned"});
  for (const Json& c : cases) {
    const Vec<12> q = stacked(c);
    const double k = c.at("k_w").get<double>() * c.at("L").get<double>();
    Vec<12> g;
    Mat<12> hess;
    const double V = bare_wrapping_energy(k, c.at("psi0"), q, &g, &hess);
    expect_close(c, "psi", wrap_angle(q.segment<3>(0), q.segment<3>(3), q.segment<3>(6), q.segment<3>(9)));
    expect_close(c, "V", V);
    expect_close<Vec<12>>(c, "F", -g, stacked(c.at("F")));
    expect_close<Mat<12>>(c, "J", -hess, mat<12>(c.at("J")));
  }
}

}  // namespace
}  // namespace slipstitch::golden
