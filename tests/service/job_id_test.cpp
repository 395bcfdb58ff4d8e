// SPDX-License-Identifier: MIT
#include "jobs/job_id.h"

#include <gtest/gtest.h>

namespace slipstitch::jobs {
namespace {

TEST(JobId, SortsByTimeOfCreation) {
  JobIdMaker maker;
  std::string last = maker.next();
  for (int i = 0; i < 1000; ++i) {
    const std::string next = maker.next();
    EXPECT_TRUE(is_job_id(next)) << next;
    EXPECT_LT(last, next);
    last = next;
  }
}

TEST(JobId, StaysAboveIdsOfAnEarlierServerWithAClockAhead) {
  const std::string future = "7zzzzzzz00000000";
  JobIdMaker maker;
  maker.keep_above(future);
  EXPECT_GT(maker.next(), future);
}

TEST(JobId, IsNothingThatCouldLeaveTheFolder) {
  for (const char* text : {"", ".", "..", "../etc", "0123456789abcde", "0123456789abcdefg", "0123456789ABCDEF",
                           "0123456789abcd/f", "0123456789abcdeu"}) {
    EXPECT_FALSE(is_job_id(text)) << text;
  }
}

TEST(PageToken, ComesBackAsItWas) {
  const auto mark = decode_page_token(encode_page_token({"0123456789abcdef", 'C'}));
  ASSERT_TRUE(mark);
  EXPECT_EQ(mark->last_id, "0123456789abcdef");
  EXPECT_EQ(mark->list, 'C');
}

TEST(PageToken, RefusesOtherText) {
  for (const char* token : {"", "p", "p1", "p1a", "x1afedcba9876543210", "p1afedcba987654321", "0123456789abcdef"}) {
    EXPECT_FALSE(decode_page_token(token)) << token;
  }
}

}  // namespace
}  // namespace slipstitch::jobs
