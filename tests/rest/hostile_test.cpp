// SPDX-License-Identifier: MIT
#include "rest_fixture.h"
#include "support/resident_memory.h"

namespace slipstitch::test {
namespace {

constexpr char kHost[] = "Host: localhost\r\n";

class HostileTest : public RestTest {
 protected:
  // The answer to any bytes, on a connection of its own.
  HttpAnswer raw(const std::string& bytes) {
    HttpConnection connection(http());
    connection.send(bytes);
    return connection.read_answer();
  }

  void expect_alive() { EXPECT_EQ(call("GET", "/healthz").body, "ok\n"); }
};

TEST_F(HostileTest, WhatIsNoHttpIsRefused) {
  start_rest();
  const std::string post = std::string("POST /v1/simJobs HTTP/1.1\r\nContent-Type: application/json\r\n") + kHost;
  for (const std::string& bytes :
       std::vector<std::string>{"\r\n\r\n\r\nnonsense\r\n\r\n",
                                "GET  / HTTP/1.1\r\n\r\n",
                                "GET / HTTP/9.9\r\n\r\n",
                                std::string("GET /\x01 HTTP/1.1\r\n") + kHost + "\r\n",
                                std::string("GET /healthz HTTP/1.1\r\nA\x01: b\r\n") + kHost + "\r\n",
                                std::string("GET /healthz HTTP/1.1\r\nA: b\rc\r\n") + kHost + "\r\n",
                                std::string("GET /healthz HTTP/1.1\r\nA: b\r\n c\r\n") + kHost + "\r\n",
                                std::string("GET /healthz HTTP/1.1\r\n") + kHost + "A: b\r\n\t\r\n\r\n",
                                std::string("GET /healthz HTTP/1.1\r\n A: b\r\n") + kHost + "\r\n",
                                std::string("GET /healthz HTTP/1.1\r\nA: b\n c\r\n") + kHost + "\r\n",
                                std::string("GET /healthz HTTP/1.1\r\nA: b\x01\r\n") + kHost + "\r\n",
                                "GET /healthz HTTP/1.1\r\n\r\n",
                                std::string("GET /healthz HTTP/1.1\r\n") + kHost + kHost + "\r\n",
                                std::string("GET /healthz HTTP/1.1\r\nContent-Length: 5\r\n") + kHost + "\r\nabcde",
                                std::string("GET /%zz HTTP/1.1\r\n") + kHost + "\r\n",
                                std::string("GET /a%0d%0aSet-Cookie:x HTTP/1.1\r\n") + kHost + "\r\n",
                                std::string("GET http://localhost/healthz HTTP/1.1\r\n") + kHost + "\r\n",
                                post + "Content-Length: -2\r\n\r\n",
                                post + "Content-Length: 2\r\nContent-Length: 3\r\n\r\n{}",
                                post + "Content-Length: 2\r\nTransfer-Encoding: chunked\r\n\r\n2\r\n{}\r\n0\r\n\r\n",
                                post + "Transfer-Encoding: chunked\r\n\r\n-2\r\n{}\r\n0\r\n\r\n",
                                post + "Transfer-Encoding: chunked\r\n\r\nfffffffffffffffff\r\n{}",
                                post + "Transfer-Encoding: chunked\r\n\r\n0x2\r\n{}\r\n0\r\n\r\n"}) {
    SCOPED_TRACE(bytes);
    expect_http_error(raw(bytes), 400, "MALFORMED_REQUEST");
  }
  expect_alive();
}

// What others may take for the body of a request is never answered as a request of its own.
TEST_F(HostileTest, NoRequestHidesInABody) {
  start_rest();
  const std::string hidden = std::string("GET /version HTTP/1.1\r\n") + kHost + "\r\n";
  const auto expect_one_answer = [&](const std::string& version, const std::string& headers, const std::string& names) {
    SCOPED_TRACE(version + " " + headers);
    HttpConnection connection(http());
    connection.send("POST /v1/simJobs/x:cancel HTTP/" + version + "\r\n" + kHost + headers + "\r\n" + hidden);
    const HttpAnswer answer = connection.read_answer();
    expect_http_error(answer, 400, "MALFORMED_REQUEST");
    EXPECT_NE(answer.body.find(names), std::string::npos) << answer.body;
    EXPECT_EQ(answer.header("connection"), "close");
    EXPECT_EQ(connection.read_rest(), "");
  };
  const std::string coding = "Transfer-Encoding: ";
  for (const std::string value : {"xchunked", "identity", "gzip", "chunked, gzip", "gzip, chunked", "chunked, chunked",
                                  "", "chunked;a=b", "\"chunked\""}) {
    expect_one_answer("1.1", coding + value + "\r\n", "Transfer-Encoding");
  }
  const std::string chunked = coding + "chunked\r\n";
  expect_one_answer("1.1", chunked + chunked, "Transfer-Encoding");
  expect_one_answer("1.1", chunked + "transfer-encoding: identity\r\n", "Transfer-Encoding");
  expect_one_answer("1.0", chunked, "Transfer-Encoding");
  expect_one_answer("1.0", "Connection: keep-alive\r\n" + chunked, "Transfer-Encoding");
  expect_one_answer("1.1", "Content-Length: 5\r\n" + chunked, "Transfer-Encoding");
  expect_one_answer("1.1", chunked + "Content-Length: 5\r\n", "Content-Length");
  expect_one_answer("1.1", "Transfer-Encoding : chunked\r\n", "");
  expect_one_answer("1.1", "Content-Length: 5\r\nContent-Length: 6\r\n", "Content-Length");
  expect_one_answer("1.1", "Content-Length: 5, 6\r\n", "Content-Length");
  expect_one_answer("1.1", "Content-Length: +5\r\n", "Content-Length");
  expect_one_answer("1.1", "A: b\r\n Content-Length: 5\r\n", "second line");
  expect_alive();
}

TEST_F(HostileTest, EndlessHeadersAreCutOff) {
  start_rest();
  const long before = resident_bytes(server_->pid());
  HttpConnection many(http());
  many.send(std::string("GET / HTTP/1.1\r\n") + kHost);
  for (int i = 0; i < 200'000 && many.send("a: b\r\n"); ++i) {
  }
  expect_http_error(many.read_answer(), 431, "HEADERS_TOO_BIG");
  HttpConnection one(http());
  one.send(std::string("GET / HTTP/1.1\r\n") + kHost + "a: ");
  const std::string part(1 << 16, 'x');
  for (int i = 0; i < 1000 && one.send(part); ++i) {
  }
  expect_http_error(one.read_answer(), 431, "HEADERS_TOO_BIG");
  expect_http_error(raw("GET /" + std::string(20'000, 'x') + " HTTP/1.1\r\n" + kHost + "\r\n"), 431, "HEADERS_TOO_BIG");
  EXPECT_LT(resident_bytes(server_->pid()) - before, 20L << 20);
  expect_alive();
}

TEST_F(HostileTest, SlowRequestsRunOutOfTime) {
  start_rest({"--http-timeout", "0.3"});
  const HttpAnswer head = raw(std::string("GET /healthz HTTP/1.1\r\n") + kHost);
  expect_http_error(head, 408, "REQUEST_TIMEOUT");
  EXPECT_NE(head.body.find("--http-timeout"), std::string::npos);
  expect_http_error(raw(std::string("POST /v1/simJobs HTTP/1.1\r\nContent-Type: application/json\r\n") + kHost +
                        "Content-Length: 100\r\n\r\n{"),
                    408, "REQUEST_TIMEOUT");
  expect_http_error(raw(""), 408, "REQUEST_TIMEOUT");
  HttpConnection idle(http());  // between requests it is only closed: there is no request to answer
  idle.send_request("GET", "/healthz");
  EXPECT_EQ(idle.read_answer().status, 200U);
  EXPECT_EQ(idle.read_rest(), "");
}

TEST_F(HostileTest, BodiesAboveTheLimitAreRefusedUnread) {
  start_rest({"--max-scene-mib", "1"});
  const std::string post = std::string("POST /v1/simJobs HTTP/1.1\r\nContent-Type: application/json\r\n") + kHost;
  const HttpAnswer announced = raw(post + "Content-Length: 2000000000\r\n\r\n");
  expect_http_error(announced, 413, "SCENE_TOO_BIG");
  EXPECT_NE(announced.body.find("--max-scene-mib"), std::string::npos);
  HttpConnection chunked(http());
  chunked.send(post + "Transfer-Encoding: chunked\r\n\r\n");
  const std::string chunk = "10000\r\n" + std::string(0x10000, ' ') + "\r\n";
  for (int i = 0; i < 40 && chunked.send(chunk); ++i) {
  }
  expect_http_error(chunked.read_answer(), 413, "SCENE_TOO_BIG");
  const HttpAnswer asked = raw(post + "Expect: 100-continue\r\nContent-Length: 2000000000\r\n\r\n");
  expect_http_error(asked, 413, "SCENE_TOO_BIG");
  EXPECT_EQ(raw(post + "Expect: 100-continue\r\nContent-Length: 2\r\n\r\n{}").status, 400U);  // read and refused
  EXPECT_TRUE(list_names().empty());
}

// No number is told that nobody knows.
TEST_F(HostileTest, WhatIsTooBigIsNotGivenAWrongSize) {
  start_rest({"--max-scene-mib", "1"});
  const std::string post = std::string("POST /v1/simJobs HTTP/1.1\r\nContent-Type: application/json\r\n") + kHost;
  HttpConnection chunked(http());
  chunked.send(post + "Transfer-Encoding: chunked\r\n\r\n200000\r\n" + std::string(0x200000, ' '));
  for (const HttpAnswer& answer : {raw(post + "Content-Length: 2000000000\r\n\r\n"),
                                   raw(post + "Content-Length: 18446744073709551615\r\n\r\n"), chunked.read_answer()}) {
    expect_http_error(answer, 413, "SCENE_TOO_BIG");
    EXPECT_NE(answer.body.find("the scene has more than the 1 MiB this server takes"), std::string::npos)
        << answer.body;
    EXPECT_EQ(answer.body.find("1048577"), std::string::npos) << answer.body;
  }
}

TEST_F(HostileTest, ACancelTakesNoBodyButAnEmptyOne) {
  start_rest();
  const std::string name = must_create(endless_swing()).name();
  for (const std::string body : {"}}{{", "}{", "{}{}", "{{}}", "{", "[]", "null", " ", R"({"name":"a"})"}) {
    SCOPED_TRACE(body);
    expect_http_error(post_json(path_of(name) + ":cancel", body), 400, "INVALID_FIELD");
  }
  EXPECT_FALSE(get(name).cancel_requested());
  EXPECT_EQ(post_json(path_of(name) + ":cancel", " {\n} ").status, 200U);
}

TEST_F(HostileTest, HostileJsonIsRefused) {
  start_rest();
  for (const std::string& body : std::vector<std::string>{
           std::string(200'000, '['), std::string(100'000, '{'), R"({"spec":)", R"({"request_id":"a",})", "{'a':1}", "",
           "[]", "null", R"({"request_id":1e999})", "{\"request_id\":\"\xff\"}",
           R"({"validate_only":true,"validate_only":false})", R"({"spec":{"scene":)" + std::string(70, '[')}) {
    SCOPED_TRACE(body.substr(0, 60));
    const HttpAnswer answer = post_json("/v1/simJobs", body);
    EXPECT_EQ(answer.status, 400U) << answer.body;
    EXPECT_NE(reason_of(answer), "");
  }
  expect_alive();
}

std::string many(std::size_t bytes, const std::string& before, const std::string& part, const std::string& after) {
  std::string scene = before;
  while (scene.size() < bytes) scene += part;
  return R"({"spec":{"scene":{)" + scene + after + R"(},"simulate":{}}})";
}

// Each takes, or once took, much more memory than its text.
TEST_F(HostileTest, MemoryOfABodyIsBounded) {
  start_rest();
  constexpr std::size_t kBytes = 15'000'000;
  const std::string yarns = R"("yarns":[)", rows = R"("knit":{"chart":{"rows":[)";
  for (const std::string& body : {many(kBytes, yarns, "{},", "{}]"), many(kBytes, rows, R"("",)", R"(""]}})"),
                                  many(kBytes, "", R"("a":1,)", R"("a":1)")}) {
    const HttpAnswer answer = post_json("/v1/simJobs", body);
    EXPECT_EQ(answer.status, body.find("\"a\"") == std::string::npos ? 413U : 400U) << answer.body;
    EXPECT_NE(answer.body.find("spec"), std::string::npos);
  }
  const std::string letters = std::string(7'000'000, 'X') + R"(",")" + std::string(6'000'000, 'Z');
  const HttpAnswer chart = post_json("/v1/simJobs", many(0, rows + '"' + letters, "", R"("]}})"));
  expect_http_error(chart, 400, "INVALID_SCENE");
  EXPECT_NE(chart.body.find("at most 250000 stitches"), std::string::npos);
  EXPECT_LT(peak_bytes(server_->pid()), 400L << 20);
}

TEST_F(HostileTest, PathsLeadNowhereElse) {
  start_rest({"--viewer", (folder_ / "viewer").string()});
  const std::string name = must_create(swing(3, 0.1, 10.0, 1e-2)).name();
  wait_for_end(name);
  for (const std::string& target : std::vector<std::string>{
           "/../etc/passwd", "/..%2f..%2fetc/passwd", "/%2e%2e/%2e%2e/etc/passwd", "//etc/passwd", "/v1/simJobs/..",
           "/v1/simJobs/" + std::string("%2e%2e") + "/artefacts", path_of(name) + "/artefacts/..%2fjob.json",
           path_of(name) + "/artefacts/../job.json", path_of(name) + "/artefacts/%2e%2e%2fjob.json",
           path_of(name) + "/artefacts/.", path_of(name) + "/artefacts/job.json", path_of(name) + "/",
           path_of(name) + ":delete", path_of(name) + "/artefacts/scene.json/", "/v1", "/v1/", "/V1/simJobs"}) {
    SCOPED_TRACE(target);
    const HttpAnswer answer = call("GET", target);
    EXPECT_EQ(answer.status, 404U) << answer.body;
    EXPECT_EQ(answer.body.find("root:"), std::string::npos);
    EXPECT_NE(reason_of(answer), "");
  }
}

TEST_F(HostileTest, OnlyItsOwnHostsAndPages) {
  start_rest();
  const auto with_host = [&](const std::string& host) { return call("GET", "/healthz", {{"Host", host}}); };
  for (const std::string host : {"localhost", "LOCALHOST:1", "127.0.0.1", "127.1.2.3:80", "[::1]:5"}) {
    EXPECT_EQ(with_host(host).status, 200U) << host;
  }
  for (const std::string host : {"example.com", "127.0.0.1.example.com", "localhost.example.com", "0.0.0.0", "[::2]",
                                 "127.0.0.1:x", "127.0.0", "[::1", "user@127.0.0.1", "10.0.0.1"}) {
    expect_http_error(with_host(host), 421, "WRONG_HOST");
  }
  const auto with_origin = [&](const std::string& origin) {
    return call("GET", "/healthz", {{"Host", "localhost:7"}, {"Origin", origin}});
  };
  EXPECT_EQ(with_origin("http://localhost:7").status, 200U);
  for (const std::string origin : {"http://example.com", "null", "http://localhost", "https://localhost:7",
                                   "http://localhost:7.example.com", "http://localhost:70"}) {
    const HttpAnswer answer = with_origin(origin);
    expect_http_error(answer, 403, "WRONG_ORIGIN");
    EXPECT_EQ(answer.header("access-control-allow-origin"), "");
  }
  expect_http_error(call("OPTIONS", "/v1/simJobs", {{"Access-Control-Request-Method", "POST"}}), 405,
                    "METHOD_NOT_ALLOWED");
}

TEST_F(HostileTest, OneConnectionServesManyRequests) {
  start_rest();
  HttpConnection connection(http());
  const std::string request = std::string("GET /healthz HTTP/1.1\r\n") + kHost + "\r\n";
  connection.send(request + request + "HEAD /version HTTP/1.1\r\n" + kHost + "\r\n" + request);  // all at once
  EXPECT_EQ(connection.read_answer().body, "ok\n");
  EXPECT_EQ(connection.read_answer().body, "ok\n");
  const HttpAnswer head = connection.read_answer(true);
  EXPECT_NE(head.header("content-length"), "0");
  EXPECT_EQ(connection.read_answer().body, "ok\n");
  HttpConnection old(http());
  old.send(std::string("GET /healthz HTTP/1.0\r\n") + kHost + "\r\n");
  EXPECT_TRUE(old.read_rest().ends_with("\r\n\r\nok\n"));
}

}  // namespace
}  // namespace slipstitch::test
