// SPDX-License-Identifier: MIT
#include <set>

#include "force/bending.h"
#include "force/contact_length.h"
#include "force/gravity.h"
#include "force/parallel_contact.h"
#include "force/stretch.h"
#include "golden_file.h"

namespace slipstitch::golden {
namespace {

// Energy, force and force Jacobian of kernel(q, g, hess) against the case. The file has F = -g and J = -hess.
template <int N, class Kernel>
void check_kernel(const Json& c, Kernel&& kernel) {
  Vec<N> g;
  Mat<N> hess;
  const double V = kernel(vec<N>(c.at("q")), &g, &hess);
  expect_close(c, "V", V);
  expect_close<Vec<N>>(c, "F", -g, vec<N>(c.at("F")));
  expect_close<Mat<N>>(c, "J", -hess, mat<N>(c.at("J")));
}

TEST(TermsGolden, StretchMatches) {
  const Json cases = cases_of_term("stretch");
  expect_categories(cases, {"generic", "near_rest"});
  for (const Json& c : cases) {
    const double k_s = c.at("params").at("k_s");
    check_kernel<8>(c, [&](const Vec<8>& q, Vec<8>* g, Mat<8>* h) { return stretch_energy(k_s, q, g, h); });
  }
}

// The file also lists the middle arc length u0, on which nothing depends.
double bending_with_middle_arc(double k_b, const Vec<12>& q, Vec<12>* g, Mat<12>* hess) {
  Eigen::Matrix<double, 12, 11> embed = Eigen::Matrix<double, 12, 11>::Zero();
  for (int i = 0; i < 11; ++i) embed(i < 7 ? i : i + 1, i) = 1.0;
  Vec<11> g11;
  Mat<11> h11;
  const double V = bending_energy(k_b, embed.transpose() * q, &g11, &h11);
  *g = embed * g11;
  *hess = embed * h11 * embed.transpose();
  return V;
}

TEST(TermsGolden, BendingMatches) {
  const Json cases = cases_of_term("bending");
  expect_categories(cases, {"generic", "near_straight", "near_pi", "exactly_straight", "exact_right_angle"});
  for (const Json& c : cases) {
    const double k_b = c.at("params").at("k_b");
    check_kernel<12>(c,
                     [&](const Vec<12>& q, Vec<12>* g, Mat<12>* h) { return bending_with_middle_arc(k_b, q, g, h); });
  }
}

TEST(TermsGolden, ContactLengthMatches) {
  const Json cases = cases_of_term("stitch_length");
  expect_categories(cases, {"generic"});
  for (const Json& c : cases) {
    const double k_l = c.at("params").at("k_l"), L = c.at("params").at("L");
    check_kernel<2>(c, [&](const Vec<2>& q, Vec<2>* g, Mat<2>* h) { return contact_length_energy(k_l, L, q, g, h); });
  }
}

TEST(TermsGolden, ParallelContactMatches) {
  const Json cases = cases_of_term("parallel_contact");
  expect_categories(cases, {"active", "inactive"});
  for (const Json& c : cases) {
    const Json& p = c.at("params");
    const double k_c = p.at("k_c"), L = p.at("L"), d = p.at("d");
    check_kernel<2>(c,
                    [&](const Vec<2>& q, Vec<2>* g, Mat<2>* h) { return parallel_contact_energy(k_c, L, d, q, g, h); });
  }
}

TEST(TermsGolden, GravityMatches) {
  const Json cases = cases_of_term("gravity");
  expect_categories(cases, {"generic"});
  for (const Json& c : cases) {
    const double rho = c.at("params").at("rho");
    const Vec3 a = vec<3>(c.at("params").at("g"));
    check_kernel<8>(c, [&](const Vec<8>& q, Vec<8>* g, Mat<8>* h) { return gravity_energy(rho, a, q, g, h); });
  }
}

TEST(TermsGolden, EveryTermOfTheFileIsChecked) {
  const std::set<std::string> checked{"stretch", "bending", "stitch_length", "parallel_contact", "gravity", "kinetic"};
  for (const Json& c : load_cases("terms_golden.json")) {
    EXPECT_TRUE(checked.contains(c.at("term").get<std::string>())) << c.at("name") << " is of an unknown term";
  }
}

}  // namespace
}  // namespace slipstitch::golden
