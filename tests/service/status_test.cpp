// SPDX-License-Identifier: MIT
#include "grpc/status.h"

#include <gtest/gtest.h>

#include "google/rpc/error_details.pb.h"

namespace slipstitch {
namespace {

TEST(RpcStatus, StaysWithinTheHeadersOfHttp2) {
  Issues issues;
  for (int i = 0; i < 10'000; ++i) {
    issues.push_back({"yarns[" + std::to_string(i) + "].prestretch", std::string(10'000, 'x'), "> 0"});
  }
  const grpc::Status status = grpc_status(jobs::error_from_issues(issues));
  EXPECT_LT(status.error_details().size() * 4 / 3 + status.error_message().size(), 8000U);
  google::rpc::Status decoded;
  ASSERT_TRUE(decoded.ParseFromString(status.error_details()));
  google::rpc::ErrorInfo info;
  google::rpc::BadRequest bad_request;
  ASSERT_TRUE(decoded.details(0).UnpackTo(&info));
  ASSERT_TRUE(decoded.details(1).UnpackTo(&bad_request));
  const int left_out = std::stoi(info.metadata().at("violations_left_out"));
  EXPECT_EQ(left_out + bad_request.field_violations_size(), static_cast<int>(kMaxIssues) + 1);
}

TEST(RpcStatus, CutsTextBetweenCharacters) {
  std::string text(511, 'x');
  text += "\xc3\xa4\xc3\xa4";
  jobs::Error error = jobs::storage_failed(text);
  EXPECT_EQ(rpc_status(error).message(), std::string(511, 'x') + "...");
}

TEST(RpcStatus, LimitsAloneAreExhaustedResources) {
  const jobs::Error limit = jobs::error_from_issues({{"a", "8", "at most 7", true, 0, 0, 7}});
  EXPECT_EQ(rpc_status(limit).code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
  EXPECT_EQ(limit.metadata, (std::map<std::string, std::string>{{"limit", "7"}}));
  EXPECT_EQ(rpc_status(jobs::error_from_issues({{"a", "1", "2", true}, {"b", "1", "2", false}})).code(),
            grpc::StatusCode::INVALID_ARGUMENT);
}

}  // namespace
}  // namespace slipstitch
