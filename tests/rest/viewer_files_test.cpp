// SPDX-License-Identifier: MIT
#include "rest_fixture.h"

namespace slipstitch::test {
namespace {

class ViewerFilesTest : public RestTest {
 protected:
  void start_with_viewer() {
    const std::filesystem::path viewer = folder_ / "viewer";
    std::filesystem::create_directories(viewer / "assets");
    write_bytes(viewer / "index.html", "<!doctype html>");
    write_bytes(viewer / "assets" / "main.js", "export {};");
    write_bytes(folder_ / "secret", "secret");
    std::filesystem::create_symlink(folder_ / "secret", viewer / "link.html");
    std::filesystem::create_directory_symlink(folder_.path(), viewer / "up");
    start_rest({"--viewer", viewer.string()});
  }
};

TEST_F(ViewerFilesTest, AreServedByExactPath) {
  start_with_viewer();
  const HttpAnswer index = call("GET", "/");
  EXPECT_EQ(index.body, "<!doctype html>");
  EXPECT_EQ(index.header("content-type"), "text/html; charset=utf-8");
  EXPECT_EQ(index.header("x-content-type-options"), "nosniff");
  EXPECT_TRUE(index.header("content-security-policy").starts_with("default-src 'self';"));
  const HttpAnswer script = call("GET", "/assets/main.js");
  EXPECT_EQ(script.body, "export {};");
  EXPECT_EQ(script.header("content-type"), "text/javascript; charset=utf-8");
  EXPECT_EQ(call("HEAD", "/assets/main.js").header("content-length"), "10");
  for (const char* path : {"/link.html", "/up/secret", "/assets", "/assets/", "/assets/../index.html", "/index.htm"}) {
    expect_http_error(call("GET", path), 404, "NO_SUCH_PATH");
  }
  expect_http_error(call("POST", "/", {{"Content-Type", "application/json"}}, "{}"), 405, "METHOD_NOT_ALLOWED");
}

TEST_F(ViewerFilesTest, AreNotSentAgainWhenTheyAreTheSame) {
  start_with_viewer();
  const std::string tag = call("GET", "/").header("etag");
  EXPECT_EQ(tag.size(), 18U);
  HttpConnection connection(http());
  connection.send_request("GET", "/", {{"If-None-Match", tag}});
  EXPECT_EQ(connection.read_answer(true).status, 304U);
  connection.send_request("GET", "/assets/main.js", {{"If-None-Match", tag}});
  EXPECT_EQ(connection.read_answer().body, "export {};");
}

TEST_F(ViewerFilesTest, AreMissedWithAHint) {
  start_rest({"--viewer", (folder_ / "nothing").string()});
  const HttpAnswer answer = call("GET", "/");
  EXPECT_EQ(answer.status, 404U);
  EXPECT_NE(answer.body.find("./run build"), std::string::npos);
}

}  // namespace
}  // namespace slipstitch::test
