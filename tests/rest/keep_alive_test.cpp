// SPDX-License-Identifier: MIT
// In one process with the server, whose settings no option of the program reaches.
#include <functional>

#include "rest/rest_server.h"
#include "rest_fixture.h"
#include "service/store_helpers.h"

namespace slipstitch::test {
namespace {

class KeepAliveTest : public ::testing::Test {
 protected:
  void SetUp() override {
    store_ = jobs::open_store(folder_.path(), work_);
    const jobs::Outcome<jobs::Job> job = store_->create(jobs::new_job(""));
    ASSERT_TRUE(job);
    jobs::wait_for_state(*store_, job->id, jobs::JobState::running);
    path_ = "/v1/simJobs/" + job->id;
    rest::RestOptions options;
    options.address = "127.0.0.1:0";
    options.keep_alive = std::chrono::milliseconds(5);
    auto server = rest::RestServer::start(*store_, predictor_, options);
    ASSERT_TRUE(server) << server.error().message;
    server_ = std::move(*server);
  }

  // A stream of a job that does not change, until that is enough.
  std::string read(const std::string& target, const std::function<bool(const std::string&)>& enough) {
    HttpConnection connection(server_->address());
    connection.send_request("GET", path_ + target);
    EXPECT_EQ(connection.read_answer(true).status, 200U);
    std::string text;
    while (!enough(text)) {
      const std::string part = connection.read_part();
      if (part.empty()) return text;
      text += part;
    }
    return text;
  }

  TemporaryFolder folder_;
  jobs::HeldWork work_;
  std::unique_ptr<jobs::JobStore, jobs::LetGo> store_;
  Predictor predictor_{"no-worker", std::chrono::milliseconds(1)};
  std::unique_ptr<rest::RestServer> server_;
  std::string path_;
};

TEST_F(KeepAliveTest, EventsSayThatTheyAreThere) {
  std::string text = read("/events", [](const std::string& read) { return read.ends_with("\n\n:\n\n:\n\n:\n\n"); });
  EXPECT_EQ(take_events(text).size(), 1U) << "the job did not change";
}

TEST_F(KeepAliveTest, FramesSayThatTheyAreThere) {
  std::string bytes = read("/frames:stream?follow=true", [](const std::string& read) { return read.size() >= 72; });
  const std::vector<StreamedRecord> records = take_records(bytes);
  ASSERT_GE(records.size(), 3U);
  for (const StreamedRecord& record : records) {
    EXPECT_EQ(record.kind, 0U);
    EXPECT_EQ(record.payload, "");
  }
}

}  // namespace
}  // namespace slipstitch::test
