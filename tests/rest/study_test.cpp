// SPDX-License-Identifier: MIT
#include "rest_fixture.h"

namespace slipstitch::test {
namespace {

class RestStudyTest : public RestTest {
 protected:
  static std::string body_of(const Json& study) {
    Json body = Json::parse(create_body(swing(5, 0.1, 30.0, 1e-2)));
    body["spec"].erase("simulate");
    body["spec"]["study"] = study;
    return body.dump();
  }
  std::string violated_field(const char* study) {
    const HttpAnswer answer = post_json("/v1/simJobs", body_of(Json::parse(study)));
    EXPECT_EQ(answer.status, 400U) << answer.body;
    const Json status = Json::parse(answer.body);
    for (const Json& detail : status["details"])
      if (detail.contains("field_violations")) return detail["field_violations"][0]["field"];
    return "";
  }
};

TEST_F(RestStudyTest, IsOrderedWatchedAndItsReportFetched) {
  start_rest();
  const HttpAnswer created = post_json("/v1/simJobs", body_of({{"quick", true}, {"budget_s", 600}}));
  ASSERT_EQ(created.status, 200U) << created.body;
  const Json job = Json::parse(created.body);
  EXPECT_EQ(job["study"]["budget_s"], 600.0);
  EXPECT_FALSE(job.contains("simulate"));
  const std::string path = path_of(job["name"]);
  EXPECT_NE(call("GET", path + "/events").body.find("\"share_done\":"), std::string::npos);
  EXPECT_EQ(Json::parse(call("GET", path).body)["state"], "SUCCEEDED");

  const std::map<std::string, std::string> types{
      {"error-newton.svg", "image/svg+xml"},      {"error-time.svg", "image/svg+xml"},
      {"scene.json", "application/json"},         {"study.csv", "text/csv; charset=utf-8"},
      {"study.html", "text/html; charset=utf-8"}, {"study.md", "text/markdown; charset=utf-8"},
      {"summary.json", "application/json"}};
  const Json listed = Json::parse(call("GET", path + "/artefacts").body)["artefacts"];
  EXPECT_EQ(listed.size(), types.size());
  for (const auto& [file, type] : types) {
    const HttpAnswer answer = call("GET", path + "/artefacts/" + file);
    EXPECT_EQ(answer.status, 200U) << file;
    EXPECT_EQ(answer.header("content-type"), type);
    EXPECT_EQ(answer.body, read_artefact(job["name"], file)) << "as by gRPC";
    EXPECT_TRUE(answer.header("content-disposition").starts_with("attachment")) << file;
  }
  for (const char* frames : {"/frames/0", "/frames:stream", "/frames:stream?follow=true"})
    expect_http_error(call("GET", path + frames), 409, "NO_FRAMES");
}

// The page shows, and could do no harm if somebody got a script into it.
TEST_F(RestStudyTest, WhatIsShownHasNoOriginAndRunsNothing) {
  start_rest();
  const std::string name = ended_job();
  write_bytes(folder_of(name).report() / "study.html", "<script>alert(1)</script>");
  const HttpAnswer shown = call("GET", path_of(name) + "/artefacts/study.html?inline=true");
  EXPECT_TRUE(shown.header("content-disposition").starts_with("inline"));
  const std::string policy = shown.header("content-security-policy");
  EXPECT_TRUE(policy.starts_with("sandbox; default-src 'none';")) << policy;
  EXPECT_EQ(policy.find("allow-"), std::string::npos) << policy;
  EXPECT_EQ(policy.find("script-src"), std::string::npos) << policy;
  EXPECT_EQ(shown.header("x-content-type-options"), "nosniff");
}

TEST_F(RestStudyTest, WrongOrdersAreRefusedByField) {
  start_rest();
  EXPECT_EQ(violated_field(R"({"budget_s": -1})"), "spec.study.budget_s");
  EXPECT_EQ(violated_field(R"({"budget_s": "60"})"), "spec.study.budget_s");
  EXPECT_EQ(violated_field(R"({"budget_s": null})"), "spec.study.budget_s");
  EXPECT_EQ(violated_field(R"({"quick": 1})"), "spec.study.quick");
  EXPECT_EQ(violated_field(R"({"budget": 1})"), "spec.study.budget");
  Json both = Json::parse(body_of(Json::object()));
  both["spec"]["simulate"] = Json::object();
  const HttpAnswer answer = post_json("/v1/simJobs", both.dump());
  EXPECT_EQ(answer.status, 400U);
  EXPECT_NE(answer.body.find("only one of them"), std::string::npos) << answer.body;
  EXPECT_EQ(Json::parse(call("GET", "/v1/simJobs").body)["jobs"].size(), 0U);
}

}  // namespace
}  // namespace slipstitch::test
