// SPDX-License-Identifier: MIT
#include "request_fuzz.h"

#include <gtest/gtest.h>

namespace slipstitch::test {
namespace {

constexpr int kMutations = 400;  // of every file; request_fuzz makes more

TEST(RequestFuzz, TheCorpusIsTakenOrRefusedInOrder) {
  const std::vector<std::string> requests = request_corpus();
  ASSERT_GE(requests.size(), 20U);
  for (const std::string& request : requests) EXPECT_EQ(request_flaw(request), "") << request.substr(0, 200);
}

TEST(RequestFuzz, SoAreItsMutations) {
  const std::vector<std::string> requests = request_corpus();
  std::mt19937_64 random(20261123);
  for (const std::string& request : requests) {
    for (int i = 0; i < kMutations; ++i) {
      const std::string text = mutated_request(request, requests, random);
      ASSERT_EQ(request_flaw(text), "") << ::testing::PrintToString(text);
    }
  }
}

}  // namespace
}  // namespace slipstitch::test
