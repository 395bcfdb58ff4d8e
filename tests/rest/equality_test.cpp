// SPDX-License-Identifier: MIT
#include <google/protobuf/util/json_util.h>

#include "rest_fixture.h"

namespace slipstitch::test {
namespace {

class RestEqualityTest : public RestTest {
 protected:
  // What gRPC says in its trailer and what REST has as its body.
  void expect_equal_errors(const grpc::Status& rpc, const HttpAnswer& http_answer) {
    google::rpc::Status from_rpc, from_http;
    ASSERT_TRUE(from_rpc.ParseFromString(rpc.error_details()));
    ASSERT_TRUE(google::protobuf::util::JsonStringToMessage(http_answer.body, &from_http).ok()) << http_answer.body;
    EXPECT_EQ(from_http.DebugString(), from_rpc.DebugString());
    EXPECT_NE(from_rpc.code(), 0);
  }

  grpc::Status rpc_create(const std::string& body) {
    v1::CreateSimJobRequest request;
    EXPECT_TRUE(google::protobuf::util::JsonStringToMessage(body, &request).ok());
    grpc::ClientContext context;
    v1::SimJob job;
    return jobs_->CreateSimJob(&context, request, &job);
  }

  grpc::Status rpc_get(const std::string& name) {
    v1::GetSimJobRequest request;
    request.set_name(name);
    grpc::ClientContext context;
    v1::SimJob job;
    return jobs_->GetSimJob(&context, request, &job);
  }
};

TEST_F(RestEqualityTest, JobsAreEqual) {
  start_rest();
  const HttpAnswer created = post_json("/v1/simJobs", create_body(swing(3, 0.1, 10.0, 1e-2), "r1"));
  ASSERT_EQ(created.status, 200U) << created.body;
  const std::string name = Json::parse(created.body)["name"];
  wait_for_end(name);
  const std::string text = call("GET", path_of(name)).body;
  EXPECT_NE(text.find("\"cancel_requested\":false"), std::string::npos) << "zeros are written: " << text;
  EXPECT_EQ(text.find("\"error\""), std::string::npos) << "absent messages are not: " << text;
  v1::SimJob job;
  ASSERT_TRUE(google::protobuf::util::JsonStringToMessage(text, &job).ok());
  EXPECT_EQ(job.DebugString(), get(name).DebugString());
  EXPECT_EQ(must_create(swing(3, 0.1, 10.0, 1e-2), "r1").name(), name);
}

TEST_F(RestEqualityTest, FramesAreEqualBitForBit) {
  start_rest();
  const std::string name = must_create(swing(30, 0.5, 20.0, 1e-2)).name();
  wait_for_end(name);
  const Received received = stream_all(name);
  std::string bytes = call("GET", path_of(name) + "/frames:stream").body;
  const std::vector<StreamedRecord> records = take_records(bytes);
  EXPECT_EQ(bytes, "");
  ASSERT_EQ(records.size(), received.frames.size() + 2);
  v1::FrameHeader header;
  EXPECT_EQ(records.front().kind, 1U);
  ASSERT_TRUE(google::protobuf::util::JsonStringToMessage(records.front().payload, &header).ok());
  EXPECT_EQ(header.SerializeAsString(), received.header->SerializeAsString());
  for (const auto& [index, frame] : received.frames) {
    const StreamedRecord& record = records[index + 1];
    EXPECT_EQ(record.kind, 2U);
    EXPECT_EQ(record.index, index);
    EXPECT_EQ((ReceivedFrame{record.t, doubles_of(record.payload)}), frame) << index;
  }
  v1::StreamEnd end;
  EXPECT_EQ(records.back().kind, 3U);
  ASSERT_TRUE(google::protobuf::util::JsonStringToMessage(records.back().payload, &end).ok());
  EXPECT_EQ(end.DebugString(), received.end->DebugString());
}

TEST_F(RestEqualityTest, ErrorsAreEqual) {
  start_rest({"--queue", "0", "--slots", "1"});
  const std::string running = must_create(endless_swing(), "taken").name();
  wait_for_frames(running, 1);
  v1::Scene bad = swing(3, -1.0, 10.0, 1e-2);
  bad.mutable_yarn()->set_radius_m(-1.0);
  bad.set_name("a\nb");
  v1::Scene big = swing(3, 1e200, 1e200, 1e-2);
  const std::vector<std::string> bodies{"{}",
                                        R"({"spec":{"threads":5000},"request_id":"a b"})",
                                        create_body(bad),
                                        create_body(big),
                                        create_body(swing(3, 0.1, 10.0, 1e-2), "taken"),
                                        create_body(swing(3, 0.1, 10.0, 1e-2))};
  const std::vector<std::pair<unsigned, std::string>> expected{{400, "INVALID_SCENE"},     {400, "INVALID_SCENE"},
                                                               {400, "INVALID_SCENE"},     {413, "SCENE_TOO_BIG"},
                                                               {409, "REQUEST_ID_REUSED"}, {429, "QUEUE_FULL"}};
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    SCOPED_TRACE(bodies[i].substr(0, 200));
    const HttpAnswer answer = post_json("/v1/simJobs", bodies[i]);
    expect_http_error(answer, expected[i].first, expected[i].second);
    expect_equal_errors(rpc_create(bodies[i]), answer);
    EXPECT_EQ(answer.header("retry-after"), expected[i].first == 429 ? "5" : "");
  }
  const HttpAnswer unknown = call("GET", "/v1/simJobs/0123456789abcdef");
  expect_http_error(unknown, 404, "JOB_NOT_FOUND");
  expect_equal_errors(rpc_get("simJobs/0123456789abcdef"), unknown);
  const HttpAnswer not_ended = call("DELETE", path_of(running));
  expect_http_error(not_ended, 409, "JOB_NOT_ENDED");
  expect_equal_errors(remove(running), not_ended);
  v1::StreamFramesRequest backwards = frames_request(running, 5);
  backwards.set_end_index(4);
  const HttpAnswer refused = call("GET", path_of(running) + "/frames:stream?first_index=5&end_index=4");
  expect_http_error(refused, 400, "INVALID_FIELD");
  expect_equal_errors(stream(backwards).status, refused);
  const HttpAnswer page = call("GET", "/v1/simJobs?page_size=-1");
  expect_http_error(page, 400, "INVALID_FIELD");
  EXPECT_EQ(call("POST", path_of(running) + ":cancel").status, 200U);
  EXPECT_EQ(wait_for_end(running).state(), v1::SimJob::CANCELLED);
}

TEST_F(RestEqualityTest, AllViolationsOfATextComeAtOnce) {
  start_rest();
  const HttpAnswer answer = post_json("/v1/simJobs", R"({"spec": {"scene": {"yarns": [{"points_m": [0,0,0, 0.1,0,0]}],
      "effects": {"stretch": {}}, "yarn": {"radiu_m": 1, "radius_m": -1}, "name": "a", "name": "b"}, "simulte": {}},
      "request_id": "a b"})");
  expect_http_error(answer, 400, "INVALID_SCENE");
  for (const char* field : {"spec.scene.yarn.radiu_m", "spec.scene.yarn.radius_m", "spec.scene.name", "spec.simulte",
                            "request_id", R"(did you mean \"radius_m\"?)"}) {
    EXPECT_NE(answer.body.find(field), std::string::npos) << field << " in " << answer.body;
  }
}

}  // namespace
}  // namespace slipstitch::test
