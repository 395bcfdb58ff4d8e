// SPDX-License-Identifier: MIT
#include "rest/route.h"

#include <gtest/gtest.h>

namespace slipstitch::rest {
namespace {

std::variant<Route, HttpError> routed(const std::string& method, const std::string& target, bool has_body = false,
                                      Headers more = {}) {
  RequestHead head{method, target, {{"host", "localhost"}}, has_body};
  head.headers.insert(head.headers.end(), more.begin(), more.end());
  return route(head, {"127.0.0.1", "127.0.0.1"});
}

Route must_route(const std::string& method, const std::string& target, bool has_body = false, Headers more = {}) {
  const auto result = routed(method, target, has_body, std::move(more));
  const auto* refused = std::get_if<HttpError>(&result);
  EXPECT_EQ(refused, nullptr) << target << ": " << refused->error.message;
  return refused ? Route() : std::get<Route>(result);
}

HttpError must_refuse(const std::string& method, const std::string& target, bool has_body = false, Headers more = {}) {
  const auto result = routed(method, target, has_body, std::move(more));
  const auto* refused = std::get_if<HttpError>(&result);
  EXPECT_NE(refused, nullptr) << target;
  return refused ? *refused : HttpError();
}

TEST(Route, ArtefactsAreShownOnlyWhenAsked) {
  EXPECT_FALSE(must_route("GET", "/v1/simJobs/x/artefacts/a.html").shown);
  EXPECT_FALSE(must_route("GET", "/v1/simJobs/x/artefacts/a.html?inline=false").shown);
  EXPECT_TRUE(must_route("GET", "/v1/simJobs/x/artefacts/a.html?inline=true").shown);
  EXPECT_EQ(must_refuse("GET", "/v1/simJobs/x/artefacts/a.html?inline=1").error.reason, "INVALID_FIELD");
}

TEST(Route, EveryPathOfTheTableIsReached) {
  for (const OperationInfo& info : operations()) {
    std::string target(info.path);
    for (std::size_t open = target.find('{'); open != std::string::npos; open = target.find('{')) {
      target.replace(open, target.find('}') - open + 1, "7");
    }
    const bool has_body = !info.request.empty();
    const Headers type = has_body ? Headers{{"content-type", "application/json"}} : Headers();
    EXPECT_EQ(must_route(std::string(info.method), target, has_body, type).operation, info.operation) << target;
    EXPECT_EQ(must_refuse("PATCH", target).status, 405U);
  }
}

TEST(Route, ReadsParameters) {
  const Route list = must_route("GET", "/v1/simJobs?page_size=7&page_token=a%2Bb&state=RUNNING");
  EXPECT_EQ(list.list.page_size(), 7);
  EXPECT_EQ(list.list.page_token(), "a+b");
  EXPECT_EQ(list.list.state(), v1::SimJob::RUNNING);
  const Route stream = must_route("GET", "/v1/simJobs/x/frames:stream?first_index=4294967295&follow=true&end_index=0");
  EXPECT_EQ(stream.frames.first_index(), 4294967295U);
  EXPECT_TRUE(stream.frames.follow());
  EXPECT_TRUE(stream.frames.has_end_index());
  EXPECT_FALSE(must_route("GET", "/v1/simJobs/x/frames:stream").frames.has_end_index());
  const Route frame = must_route("GET", "/v1/simJobs/x/frames/12?format=vtp");
  EXPECT_EQ(frame.frame_index, 12U);
  EXPECT_EQ(frame.format->name, "vtp");
  EXPECT_EQ(must_route("GET", "/v1/simJobs/x/frames/0").format->name, "json");
  EXPECT_EQ(must_route("POST", "/v1/simJobs/x%3Acancel").operation, Operation::cancel_job);
  EXPECT_EQ(must_route("GET", "/v1/simJobs/x/events", false, {{"last-event-id", "18"}}).last_event_id, 18U);
  EXPECT_FALSE(must_route("GET", "/v1/simJobs/x/events", false, {{"last-event-id", "x"}}).last_event_id);
  EXPECT_TRUE(must_route("HEAD", "/v1/simJobs").head_only);
}

TEST(Route, NamesTheParameterThatIsWrong) {
  const auto field = [](const std::string& target) {
    const HttpError refused = must_refuse("GET", target);
    EXPECT_EQ(refused.status, 400U) << target;
    EXPECT_EQ(refused.error.reason, "INVALID_FIELD") << target;
    return refused.error.violations.empty() ? "" : refused.error.violations[0].path;
  };
  EXPECT_EQ(field("/v1/simJobs?page_size=x"), "page_size");
  EXPECT_EQ(field("/v1/simJobs?page_size=99999999999"), "page_size");
  EXPECT_EQ(field("/v1/simJobs?state=running"), "state");
  EXPECT_EQ(field("/v1/simJobs?state=STATE_UNSPECIFIED"), "state");
  EXPECT_EQ(field("/v1/simJobs?page_size=1&page_size=2"), "page_size");
  EXPECT_EQ(field("/v1/simJobs/x/frames:stream?stride=-1"), "stride");
  EXPECT_EQ(field("/v1/simJobs/x/frames:stream?follow=yes"), "follow");
  EXPECT_EQ(field("/v1/simJobs/x/frames/1?format=glb"), "format");
  EXPECT_EQ(field("/v1/simJobs/x/frames/-1"), "index");
  EXPECT_EQ(field("/healthz?a=b"), "a");
  const HttpError near = must_refuse("GET", "/v1/simJobs?pageSize=1");
  EXPECT_NE(near.error.message.find("did you mean \"page_size\"?"), std::string::npos) << near.error.message;
}

TEST(Route, KnowsMethodsAndTypes) {
  const HttpError put = must_refuse("PUT", "/v1/simJobs/x");
  EXPECT_EQ(put.status, 405U);
  EXPECT_EQ(put.headers, (Headers{{"Allow", "GET, HEAD, DELETE"}}));
  EXPECT_EQ(must_refuse("GET", "/v1/simJobs/x:cancel").headers, (Headers{{"Allow", "POST"}}));
  EXPECT_EQ(must_refuse("POST", "/v1/simJobs").status, 415U);
  EXPECT_EQ(must_refuse("POST", "/v1/simJobs", true, {{"content-type", "application/jsonx"}}).status, 415U);
  EXPECT_EQ(must_refuse("POST", "/v1/simJobs/x:cancel", true, {{"content-type", "text/plain"}}).status, 415U);
  must_route("POST", "/v1/simJobs", true, {{"content-type", "Application/JSON ; charset=utf-8"}});
  const HttpError packed =
      must_refuse("POST", "/v1/simJobs", true, {{"content-type", "application/json"}, {"content-encoding", "gzip"}});
  EXPECT_EQ(packed.status, 415U);
  EXPECT_EQ(packed.error.message, "the Content-Encoding is 'gzip', expected none");
  must_route("POST", "/v1/simJobs", true, {{"content-type", "application/json"}, {"content-encoding", "Identity"}});
  must_route("POST", "/v1/simJobs/x:cancel");
  EXPECT_EQ(must_refuse("DELETE", "/v1/simJobs/x", true).status, 400U);
}

TEST(Head, NoValueEndsItsHeader) {
  Response response;
  response.headers.emplace_back("A", "b\r\nSet-Cookie: c\r\n\r\n<script>");
  const std::string head = head_text(response, 0, false, true);
  EXPECT_EQ(head.find("\nSet-Cookie"), std::string::npos);
  EXPECT_EQ(head.find("\r\n\r\n"), head.size() - 4);
}

}  // namespace
}  // namespace slipstitch::rest
