// SPDX-License-Identifier: MIT
// Many clients, and clients that do not read: what they cost, and whom they hold up.
#include "rest_fixture.h"
#include "run_dir/frame_log.h"
#include "support/resident_memory.h"

namespace slipstitch::test {
namespace {

class RestLoadTest : public RestTest {
 protected:
  using Connections = std::vector<std::unique_ptr<HttpConnection>>;

  HttpAnswer raw(const std::string& bytes) {
    HttpConnection connection(http());
    connection.send(bytes);
    return connection.read_answer();
  }

  Connections ask(const std::string& target, int times) { return ask("GET", target, "", times); }
  Connections ask(const std::string& method, const std::string& target, const std::string& body, int times) {
    const HttpHeaders headers = body.empty() ? HttpHeaders() : HttpHeaders{{"Content-Type", "application/json"}};
    Connections connections;
    for (int i = 0; i < times; ++i) {
      connections.push_back(std::make_unique<HttpConnection>(http()));
      connections.back()->send_request(method, target, headers, body);
    }
    EXPECT_EQ(call("GET", "/healthz").status, 200U);  // accepted after those, so those have begun
    return connections;
  }

  long metric(const std::string& name) {
    const std::string text = call("GET", "/metrics").body, start = "\n" + name + " ";
    const std::size_t at = text.find(start);
    EXPECT_NE(at, std::string::npos) << name;
    return at == std::string::npos ? 0 : std::stol(text.substr(at + start.size()));
  }
  void wait_for_metric(const std::string& name, long value) {
    while (metric(name) != value && !HasFailure()) {
    }
  }
};

TEST_F(RestLoadTest, ConnectionsAboveTheLimitAreTold) {
  start_rest({"--http-connections", "2"});
  HttpConnection first(http()), second(http());
  for (HttpConnection* connection : {&first, &second}) {
    connection->send_request("GET", "/healthz");
    EXPECT_EQ(connection->read_answer().status, 200U);
  }
  const HttpAnswer refused = call("GET", "/healthz");
  expect_http_error(refused, 503, "TOO_MANY_CONNECTIONS");
  EXPECT_NE(refused.body.find("--http-connections"), std::string::npos);
  EXPECT_EQ(refused.header("retry-after"), "1");
  first.send_request("GET", "/healthz");
  EXPECT_EQ(first.read_answer().status, 200U) << "who is in stays in";
}

// So many more that there is no reading what they ask.
TEST_F(RestLoadTest, ConnectionsFarAboveTheLimitAreToldToo) {
  start_rest({"--http-connections", "1"});
  HttpConnection first(http());
  first.send_request("GET", "/healthz");
  EXPECT_EQ(first.read_answer().status, 200U);
  Connections more;
  for (int i = 0; i < 300; ++i) more.push_back(std::make_unique<HttpConnection>(http()));
  for (const auto& connection : more) {
    const HttpAnswer refused = connection->read_answer();
    ASSERT_EQ(refused.status, 503U);
    EXPECT_EQ(reason_of(refused), "TOO_MANY_CONNECTIONS");
    EXPECT_EQ(refused.header("connection"), "close");
  }
}

TEST_F(RestLoadTest, LargeRequestsWaitForEachOther) {
  start_rest();
  const std::string post = "POST /v1/simJobs HTTP/1.1\r\nContent-Type: application/json\r\nHost: localhost\r\n";
  Connections sending;
  for (int i = 0; i < 8; ++i) {
    sending.push_back(std::make_unique<HttpConnection>(http()));
    sending.back()->send(post + "Content-Length: 100000\r\n\r\n{");
  }
  const HttpAnswer refused = raw(post + "Content-Length: 100000\r\n\r\n{");
  expect_http_error(refused, 503, "TOO_MANY_UPLOADS");
  EXPECT_EQ(refused.header("retry-after"), "1");
  EXPECT_EQ(raw(post + "Content-Length: 2\r\n\r\n{}").status, 400U) << "small ones never wait";
  sending.back()->send(std::string(99'999, '}'));
  EXPECT_EQ(sending.back()->read_answer().status, 400U);
  HttpConnection next(http());
  next.send(post + "Content-Length: 100000\r\n\r\n" + std::string(100'000, '{'));
  EXPECT_EQ(next.read_answer().status, 400U) << "a place is free again";
}

constexpr int kLargeVisits = 100'000;
constexpr long kLargeFrameBytes = 4L * kLargeVisits * 8;

// Puts ten frames of 3.2 MB, as JSON with all digits of 12 MB, where a job's were.
void write_large_log(const std::filesystem::path& file) {
  constexpr int visits = kLargeVisits;
  FrameHeader header;
  header.topology.num_nodes = visits;
  header.topology.yarn_first = {0, visits};
  header.topology.visit_node.resize(visits);
  for (int i = 0; i < visits; ++i) header.topology.visit_node[static_cast<std::size_t>(i)] = i;
  header.topology.visit_slides.assign(visits, 0);
  header.topology.segment_kind.assign(visits, SegmentKind::free);
  header.topology.segment_kind.back() = SegmentKind::none;
  header.topology.rest_arc.assign(visits, 0.0);
  header.topology.yarn_material = {0};
  header.topology.density_scale = {1.0};
  header.yarn = {1e-3, 1e-4, 1.0, 1e-8};
  header.frames_per_s = 10.0;
  header.num_frames = 10;
  std::filesystem::remove(file);
  Result<FrameLogWriter> log = FrameLogWriter::create(file);
  ASSERT_TRUE(log) << log.error;
  ASSERT_EQ(log->append_header(header), "");
  for (int i = 0; i < 10; ++i)
    ASSERT_EQ(log->append_frame({i, 0.1 * i, VecX::Constant(4 * visits, -1e-100 / 3.0)}), "");
}

TEST_F(RestLoadTest, WhoDoesNotReadCostsAFewFramesAndIsCutOff) {
  start_rest({"--stall-timeout", "2"});
  const std::string name = must_create(swing(3, 0.1, 10.0, 1e-2)).name();
  wait_for_end(name);
  write_large_log(folder_of(name).frames());
  const std::string target = path_of(name) + "/frames:stream";
  const HttpAnswer whole = call("GET", target);
  EXPECT_TRUE(whole.complete);
  EXPECT_GT(whole.body.size(), static_cast<std::size_t>(10 * kLargeFrameBytes));
  const long before = resident_bytes(server_->pid());
  std::vector<std::unique_ptr<HttpConnection>> stalled;
  for (int i = 0; i < 16; ++i) {
    stalled.push_back(std::make_unique<HttpConnection>(http()));
    stalled.back()->send_request("GET", target);
    EXPECT_EQ(stalled.back()->read_answer(true).status, 200U);
  }
  const auto metrics = [&] { return call("GET", "/metrics").body; };
  long most = 0;
  while (metrics().find("slipstitch_http_streams 0\n") == std::string::npos) {
    most = std::max(most, resident_bytes(server_->pid()) - before);
  }
  RecordProperty("most_bytes", std::to_string(most));
  EXPECT_LT(most, 16 * 7 * kLargeFrameBytes) << "16 clients, each with a header and a frame in hand";
  while (!stalled.front()->read_part().empty()) {
  }
  EXPECT_FALSE(stalled.front()->ended());
}

// A prediction takes half a second and more; the lane for them has room for a few, and the rest go without.
TEST_F(RestLoadTest, NobodyWaitsForManyPredictions) {
  start_rest();
  Json request = Json::parse(create_body(swing(200, 10.0, 10.0, 1e-3)));
  request["validate_only"] = true;
  const Connections asked = ask("POST", "/v1/simJobs", request.dump(), 20);
  EXPECT_EQ(post_json("/v1/simJobs", create_body(swing(3, 0.1, 10.0, 1e-2))).status, 200U);
  int without = 0;
  for (const auto& connection : asked) {
    const HttpAnswer answer = connection->read_answer();
    EXPECT_EQ(answer.status, 200U);
    without += Json::parse(answer.body).contains("prediction") ? 0 : 1;
  }
  EXPECT_GT(without, 0);
  EXPECT_LT(without, 20);
}

TEST_F(RestLoadTest, JobsDoNotWaitForFrameFiles) {
  start_rest();
  const std::string name = ended_job();
  BlockedLog log(folder_of(name).frames());
  const Connections waiting = ask(path_of(name) + "/frames/0", 20);
  Json request = Json::parse(create_body(swing(3, 0.1, 10.0, 1e-2)));
  request["validate_only"] = true;
  const HttpAnswer valid = post_json("/v1/simJobs", request.dump());
  EXPECT_EQ(valid.status, 200U);
  EXPECT_GT(Json::parse(valid.body).at("prediction").at("as_it_is").at("wall_s"), 0.0) << valid.body;
  log.release();
  for (const auto& connection : waiting) expect_http_error(connection->read_answer(), 404, "FRAME_NOT_FOUND");
}

TEST_F(RestLoadTest, WhoGetsNoTurnForAFrameFileIsTold) {
  start_rest({"--http-timeout", "0.3"});
  const std::string name = ended_job();
  BlockedLog log(folder_of(name).frames());
  const std::string target = path_of(name) + "/frames/0";
  const Connections first = ask(target, 1);
  const HttpAnswer refused = call("GET", target);
  expect_http_error(refused, 503, "TOO_MANY_EXPORTS");
  EXPECT_EQ(refused.header("retry-after"), "1");
  EXPECT_NE(refused.body.find("--http-timeout"), std::string::npos) << refused.body;
  wait_for_metric("slipstitch_http_exports_waiting", 0);
  log.release();
  expect_http_error(first[0]->read_answer(), 404, "FRAME_NOT_FOUND");
}

constexpr std::size_t kMostExportBytes = 64U << 20;

TEST_F(RestLoadTest, MemoryOfUnreadFrameFilesIsBounded) {
  start_rest({"--stall-timeout", "3600", "--http-timeout", "3600"});
  const std::string name = ended_job(), target = path_of(name) + "/frames/5";
  write_large_log(folder_of(name).frames());
  const std::size_t size = call("GET", target).body.size();
  ASSERT_GT(size, 10'000'000U) << "more than the sockets take";
  const int fit = static_cast<int>((kMostExportBytes + size - 1) / size), clients = 6 * fit;
  const long before = resident_bytes(server_->pid());
  Connections unread = ask(target, clients);
  const auto made = [&] { return metric("slipstitch_http_export_bytes") / static_cast<long>(size); };
  while (made() + metric("slipstitch_http_exports_waiting") != clients && !HasFailure()) {
  }
  EXPECT_EQ(made(), fit);
  const long held = resident_bytes(server_->pid()) - before;
  RecordProperty("held_bytes", std::to_string(held));
  EXPECT_LT(held, static_cast<long>(3 * kMostExportBytes));
  unread.resize(static_cast<std::size_t>(fit) + 1);  // the others hang up
  for (const auto& connection : unread) {
    const HttpAnswer answer = connection->read_answer();
    EXPECT_TRUE(answer.status == 200U && answer.complete && answer.body.size() == size) << answer.status;
  }
  wait_for_metric("slipstitch_http_export_bytes", 0);
}

TEST_F(RestLoadTest, WhoDoesNotReadAFrameFileMakesRoomForOthers) {
  start_rest({"--stall-timeout", "0.3"});
  const std::string name = ended_job(), target = path_of(name) + "/frames/5";
  write_large_log(folder_of(name).frames());
  const int clients = static_cast<int>(2 * kMostExportBytes / call("GET", target).body.size());
  const Connections unread = ask(target, clients);
  wait_for_metric("slipstitch_http_connections", 1);  // that which asks
  EXPECT_EQ(metric("slipstitch_http_export_bytes"), 0);
  for (const auto& connection : unread) {
    const HttpAnswer answer = connection->read_answer();
    EXPECT_EQ(answer.status, 200U) << answer.body;
    EXPECT_FALSE(answer.complete);
  }
}

}  // namespace
}  // namespace slipstitch::test
