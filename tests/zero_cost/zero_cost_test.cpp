// SPDX-License-Identifier: MIT
// An effect that a scene does not list changes no bit of the result, against a simulator that does not know it.
#include <gtest/gtest.h>

#include "program_output.h"

namespace slipstitch::test {
namespace {

struct Output {
  std::string terms, result;
};

Output run_of(const std::string& program) {
  const std::string text = output_of(in_bin(program));
  const std::size_t first = text.find('\n');
  return first == std::string::npos ? Output{text, ""} : Output{text.substr(0, first), text.substr(first + 1)};
}

TEST(ZeroCost, TheSameBitsWithAndWithoutTheTermsThatAreOff) {
  const Output all = run_of("swatch_run_all_terms"), listed = run_of("swatch_run_listed_terms");
  EXPECT_EQ(listed.terms, "5 terms");
  EXPECT_NE(all.terms, listed.terms);
  EXPECT_NE(all.result.find("succeeded"), std::string::npos) << all.result;
  EXPECT_EQ(all.result, listed.result);
}

}  // namespace
}  // namespace slipstitch::test
