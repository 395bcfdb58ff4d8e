// SPDX-License-Identifier: MIT
#include "force/kinetic.h"
#include "golden_file.h"

namespace slipstitch::golden {
namespace {

TEST(KineticGolden, EnergyMomentumAndVelocityTermsMatch) {
  const Json cases = cases_of_term("kinetic");
  expect_categories(cases, {"generic", "no_sliding", "null_motion"});
  for (const Json& c : cases) {
    const double rho = c.at("params").at("rho");
    const Vec<8> q = vec<8>(c.at("q")), qdot = vec<8>(c.at("qdot"));
    const Mat<8> M = kinetic_mass(rho, q);
    expect_close(c, "T", kinetic_energy(rho, q, qdot));
    expect_close<Mat<8>>(c, "M", M, mat<8>(c.at("M")));
    expect_close<Vec<8>>(c, "p", M * qdot, vec<8>(c.at("p")));
    expect_close<Vec<8>>(c, "dTdq", kinetic_gradient(rho, q, qdot), vec<8>(c.at("dTdq")));
    expect_close<Vec<8>>(c, "Mdot_qdot", kinetic_mass_rate(rho, q, qdot), vec<8>(c.at("Mdot_qdot")));
  }
}

}  // namespace
}  // namespace slipstitch::golden
