// SPDX-License-Identifier: MIT
// An effect that a scene does not list changes no bit of the result, against a simulator that does not know it.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <string>

namespace slipstitch::test {
namespace {

struct Output {
  std::string terms, result;
};

Output output_of(const std::string& program) {
  const std::string path = std::string(SLIPSTITCH_BIN_DIR) + "/" + program;
  std::FILE* pipe = ::popen(path.c_str(), "r");
  std::string text;
  std::array<char, 4096> buffer{};
  while (pipe && std::fgets(buffer.data(), buffer.size(), pipe)) text += buffer.data();
  EXPECT_TRUE(pipe && ::pclose(pipe) == 0) << path << ": " << text;
  const std::size_t first = text.find('\n');
  return first == std::string::npos ? Output{text, ""} : Output{text.substr(0, first), text.substr(first + 1)};
}

TEST(ZeroCost, TheSameBitsWithAndWithoutTheTermsThatAreOff) {
  const Output all = output_of("swatch_run_all_terms"), listed = output_of("swatch_run_listed_terms");
  EXPECT_EQ(listed.terms, "5 terms");
  EXPECT_NE(all.terms, listed.terms);
  EXPECT_NE(all.result.find("succeeded"), std::string::npos) << all.result;
  EXPECT_EQ(all.result, listed.result);
}

}  // namespace
}  // namespace slipstitch::test
