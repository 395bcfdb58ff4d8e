// SPDX-License-Identifier: MIT
#include <signal.h>

#include "rest_fixture.h"

namespace slipstitch::test {
namespace {

class RestStreamsTest : public RestTest {
 protected:
  std::unique_ptr<HttpConnection> open(const std::string& target, const HttpHeaders& headers = {}) {
    auto connection = std::make_unique<HttpConnection>(http());
    connection->send_request("GET", target, headers);
    EXPECT_EQ(connection->read_answer(true).status, 200U) << target;
    return connection;
  }

  // Until there is one.
  static ServerEvent next_event(HttpConnection& connection) {
    std::string text;
    std::vector<ServerEvent> events;
    while (events.empty()) {
      const std::string part = connection.read_part();
      if (part.empty()) return {"no event", "", ""};
      text += part;
      events = take_events(text);
    }
    return events.front();
  }
};

TEST_F(RestStreamsTest, EventsTellEveryStateAndTheEnd) {
  start_rest();
  const std::string name = must_create(swing(3, 2.0, 50.0, 1e-3)).name();
  std::string text = call("GET", path_of(name) + "/events").body;
  const std::vector<ServerEvent> events = take_events(text);
  ASSERT_GE(events.size(), 2U);
  EXPECT_EQ(events.back().event, "end");
  EXPECT_EQ(events.back().data, "{}");
  std::uint64_t revision = 0;
  for (std::size_t i = 0; i + 1 < events.size(); ++i) {
    EXPECT_EQ(events[i].event, "job");
    EXPECT_GT(std::stoull(events[i].id), revision);
    revision = std::stoull(events[i].id);
    EXPECT_EQ(Json::parse(events[i].data)["revision"], events[i].id);
  }
  EXPECT_EQ(Json::parse(events[events.size() - 2].data)["state"], "SUCCEEDED");
}

TEST_F(RestStreamsTest, EventsGoOnBehindTheLastOneSeen) {
  start_rest({"--slots", "1"});
  const std::string busy = must_create(endless_swing()).name();
  wait_for_frames(busy, 1);
  const std::string name = must_create(endless_swing()).name();  // waits, and does not change
  const ServerEvent first = next_event(*open(path_of(name) + "/events"));
  EXPECT_EQ(first.id, std::to_string(get(name).revision()));
  const auto again = open(path_of(name) + "/events", {{"Last-Event-ID", first.id}});
  cancel(name);
  const ServerEvent next = next_event(*again);
  EXPECT_NE(next.id, first.id) << "what was seen is not sent again";
  EXPECT_EQ(Json::parse(next.data)["state"], "CANCELLED");
  std::string rest = call("GET", path_of(name) + "/events", {{"Last-Event-ID", next.id}}).body;
  const std::vector<ServerEvent> end = take_events(rest);
  ASSERT_EQ(end.size(), 1U);
  EXPECT_EQ(end[0].event, "end");
  std::string older = call("GET", path_of(name) + "/events", {{"Last-Event-ID", first.id}}).body;
  EXPECT_EQ(take_events(older).size(), 2U);
}

TEST_F(RestStreamsTest, FramesOfARunningJobComeAsTheyAreMade) {
  start_rest();
  const std::string name = must_create(endless_swing()).name();
  const auto stream = open(path_of(name) + "/frames:stream?follow=true");
  std::string bytes;
  std::vector<StreamedRecord> records;
  while (records.size() < 6) {
    const std::string part = stream->read_part();
    ASSERT_NE(part, "");
    bytes += part;
    for (StreamedRecord& record : take_records(bytes)) records.push_back(std::move(record));
  }
  EXPECT_EQ(records[0].kind, 1U);
  for (std::uint32_t i = 1; i < 6; ++i) EXPECT_EQ(records[i].index, i - 1);
  EXPECT_EQ(get(name).state(), v1::SimJob::RUNNING);
  cancel(name);
  for (std::string part = stream->read_part(); !part.empty(); part = stream->read_part()) bytes += part;
  EXPECT_TRUE(stream->ended());
  records = take_records(bytes);
  ASSERT_FALSE(records.empty());
  EXPECT_EQ(records.back().kind, 3U);
  EXPECT_EQ(Json::parse(records.back().payload)["state"], "CANCELLED");
}

TEST_F(RestStreamsTest, FramesGoOnAtAnyIndex) {
  start_rest();
  const std::string name = must_create(swing(3, 1.0, 10.0, 1e-2)).name();
  wait_for_end(name);
  const auto read = [&](const std::string& query) {
    std::string bytes = call("GET", path_of(name) + "/frames:stream?" + query).body;
    return take_records(bytes);
  };
  const std::vector<StreamedRecord> all = read("");
  ASSERT_EQ(all.size(), 13U);
  const std::vector<StreamedRecord> rest = read("first_index=4&stride=3&end_index=10");
  ASSERT_EQ(rest.size(), 4U);  // the header, 4 and 7, the end
  EXPECT_EQ(rest[0].payload, all[0].payload);
  for (const std::size_t i : {1U, 2U}) {
    EXPECT_EQ(rest[i].index, 1 + 3 * i);
    EXPECT_EQ(rest[i].payload, all[rest[i].index + 1].payload);
  }
  EXPECT_EQ(Json::parse(rest[3].payload)["reason"], "END_OF_RANGE");
}

TEST_F(RestStreamsTest, ALostServerLeavesNoEnd) {
  start_rest();
  const std::string name = must_create(endless_swing()).name();
  const auto stream = open(path_of(name) + "/frames:stream?follow=true");
  ASSERT_NE(stream->read_part(), "");
  server_->signal(SIGTERM);
  while (!stream->read_part().empty()) {
  }
  EXPECT_EQ(server_->wait(), 0);
  EXPECT_FALSE(stream->ended());
}

// Watching costs no thread and no turn: with 200 clients that wait for events, others are answered.
TEST_F(RestStreamsTest, TwoHundredWaitingClientsHoldUpNobody) {
  start_rest({"--slots", "1"});
  const std::string busy = must_create(endless_swing()).name();
  wait_for_frames(busy, 1);
  const std::string name = must_create(endless_swing()).name();
  std::vector<std::unique_ptr<HttpConnection>> watching;
  for (int i = 0; i < 200; ++i) {
    watching.push_back(open(path_of(name) + "/events"));
    EXPECT_EQ(next_event(*watching.back()).event, "job");
  }
  EXPECT_EQ(call("GET", path_of(name)).status, 200U);
  EXPECT_NE(call("GET", "/metrics").body.find("slipstitch_http_streams 200\n"), std::string::npos);
  cancel(name);
  for (const auto& connection : watching) EXPECT_EQ(next_event(*connection).event, "job");
}

}  // namespace
}  // namespace slipstitch::test
