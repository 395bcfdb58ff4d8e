// SPDX-License-Identifier: MIT
#include "service_fixture.h"

namespace slipstitch::test {
namespace {

class ErrorsTest : public ServiceTest {
 protected:
  grpc::Status create_spec(const v1::CreateSimJobRequest& request) {
    grpc::ClientContext context;
    v1::SimJob job;
    return jobs_->CreateSimJob(&context, request, &job);
  }
};

std::vector<std::string> violated_fields(const grpc::Status& status) {
  std::vector<std::string> fields;
  for (const google::rpc::BadRequest& request : details_of(status).bad_requests) {
    for (const auto& violation : request.field_violations()) {
      fields.push_back(violation.field());
      EXPECT_NE(violation.description().find("expected"), std::string::npos) << violation.description();
    }
  }
  return fields;
}

TEST_F(ErrorsTest, UnknownJobs) {
  start_server();
  for (const char* name : {"simJobs/0123456789abcdef", "simJobs/../../etc", "nonsense", ""}) {
    v1::GetSimJobRequest request;
    request.set_name(name);
    grpc::ClientContext context;
    v1::SimJob job;
    expect_error(jobs_->GetSimJob(&context, request, &job), grpc::StatusCode::NOT_FOUND, "JOB_NOT_FOUND");
    expect_error(cancel(name), grpc::StatusCode::NOT_FOUND, "JOB_NOT_FOUND");
    expect_error(remove(name), grpc::StatusCode::NOT_FOUND, "JOB_NOT_FOUND");
    expect_error(stream(frames_request(name)).status, grpc::StatusCode::NOT_FOUND, "JOB_NOT_FOUND");
    grpc::Status watched;
    EXPECT_TRUE(watch(name, &watched).empty());
    expect_error(watched, grpc::StatusCode::NOT_FOUND, "JOB_NOT_FOUND");
    v1::ListArtefactsRequest artefacts;
    artefacts.set_name(name);
    grpc::ClientContext artefacts_context;
    v1::ListArtefactsResponse response;
    expect_error(jobs_->ListArtefacts(&artefacts_context, artefacts, &response), grpc::StatusCode::NOT_FOUND,
                 "JOB_NOT_FOUND");
    v1::GetArtefactRequest artefact;
    artefact.set_name(std::string(name) + "/artefacts/scene.json");
    grpc::ClientContext artefact_context;
    expect_error(jobs_->GetArtefact(&artefact_context, artefact)->Finish(), grpc::StatusCode::NOT_FOUND,
                 "JOB_NOT_FOUND");
  }
}

TEST_F(ErrorsTest, WrongStates) {
  start_server();
  const std::string name = must_create(endless_swing()).name();
  wait_for_frames(name, 1);
  expect_error(remove(name), grpc::StatusCode::FAILED_PRECONDITION, "JOB_NOT_ENDED");
  cancel(name);
  wait_for_end(name);
  const std::string done = must_create(swing(3, 0.1, 10.0, 1e-2)).name();
  wait_for_end(done);
  expect_error(cancel(done), grpc::StatusCode::FAILED_PRECONDITION, "JOB_ENDED");
  v1::GetArtefactRequest request;
  request.set_name(done + "/artefacts/../job.json");
  grpc::ClientContext context;
  const auto reader = jobs_->GetArtefact(&context, request);
  v1::ArtefactChunk chunk;
  EXPECT_FALSE(reader->Read(&chunk));
  expect_error(reader->Finish(), grpc::StatusCode::NOT_FOUND, "ARTEFACT_NOT_FOUND");
  v1::StreamFramesRequest backwards = frames_request(done, 5);
  backwards.set_end_index(4);
  const grpc::Status refused = stream(backwards).status;
  expect_error(refused, grpc::StatusCode::INVALID_ARGUMENT, "INVALID_FIELD");
  EXPECT_EQ(violated_fields(refused), std::vector<std::string>{"end_index"});
}

TEST_F(ErrorsTest, RequestIds) {
  start_server();
  const v1::SimJob first = must_create(swing(3, 0.1, 10.0, 1e-2), "r1");
  EXPECT_EQ(must_create(swing(3, 0.1, 10.0, 1e-2), "r1").name(), first.name());
  v1::SimJob job;
  expect_error(create(swing(4, 0.1, 10.0, 1e-2), "r1", job), grpc::StatusCode::ALREADY_EXISTS, "REQUEST_ID_REUSED");
  const grpc::Status refused = create(swing(3, 0.1, 10.0, 1e-2), "no spaces", job);
  expect_error(refused, grpc::StatusCode::INVALID_ARGUMENT, "INVALID_FIELD");
  EXPECT_EQ(violated_fields(refused), std::vector<std::string>{"request_id"});
  EXPECT_EQ(list_names().size(), 1U);
}

TEST_F(ErrorsTest, Pages) {
  start_server();
  v1::ListSimJobsResponse response;
  const auto list = [&](int size, const std::string& token, v1::SimJob::State state = v1::SimJob::STATE_UNSPECIFIED) {
    v1::ListSimJobsRequest request;
    request.set_page_size(size);
    request.set_page_token(token);
    request.set_state(state);
    grpc::ClientContext context;
    return jobs_->ListSimJobs(&context, request, &response);
  };
  for (int i = 0; i < 2; ++i) must_create(swing(3, 0.1, 10.0, 1e-2));
  expect_error(list(-1, ""), grpc::StatusCode::INVALID_ARGUMENT, "INVALID_FIELD");
  expect_error(list(1, "nonsense"), grpc::StatusCode::INVALID_ARGUMENT, "INVALID_PAGE_TOKEN");
  EXPECT_TRUE(list(1000, "").ok()) << "too large is 100";
  ASSERT_TRUE(list(1, "").ok());
  const std::string token = response.next_page_token();
  expect_error(list(1, token, v1::SimJob::QUEUED), grpc::StatusCode::INVALID_ARGUMENT, "INVALID_PAGE_TOKEN");
  EXPECT_TRUE(list(1, token).ok());
}

TEST_F(ErrorsTest, AFullQueueSaysWhenToComeBack) {
  start_server({"--slots", "1", "--queue", "1"});
  const std::string name = must_create(endless_swing()).name();
  wait_for_frames(name, 1);
  must_create(endless_swing());
  v1::SimJob job;
  const grpc::Status refused = create(endless_swing(), "", job);
  expect_error(refused, grpc::StatusCode::RESOURCE_EXHAUSTED, "QUEUE_FULL");
  const Details details = details_of(refused);
  EXPECT_EQ(details.infos[0].metadata().at("flag"), "--queue");
  ASSERT_EQ(details.retries.size(), 1U);
  EXPECT_GT(details.retries[0].retry_delay().seconds(), 0);
  EXPECT_EQ(list_names().size(), 2U);
}

TEST_F(ErrorsTest, ASceneAboveTheLimitNamesTheFlag) {
  start_server({"--max-scene-mib", "1"});
  v1::SimJob job;
  for (const int points : {50'000, 1'000'000}) {  // 1.2 MB and 24 MB
    const grpc::Status refused = create(swing(points, 0.1, 10.0, 1e-2), "", job);
    expect_error(refused, grpc::StatusCode::RESOURCE_EXHAUSTED, "SCENE_TOO_BIG");
    EXPECT_EQ(details_of(refused).infos[0].metadata().at("flag"), "--max-scene-mib");
    EXPECT_EQ(details_of(refused).infos[0].metadata().at("limit"), "1");
  }
  EXPECT_TRUE(list_names().empty());
  EXPECT_EQ(wait_for_end(must_create(swing(3, 0.1, 10.0, 1e-2)).name()).state(), v1::SimJob::SUCCEEDED);
}

bool contains(const std::vector<std::string>& fields, const std::string& field) {
  return std::find(fields.begin(), fields.end(), field) != fields.end();
}

TEST_F(ErrorsTest, AllViolationsComeAtOnce) {
  start_server();
  v1::CreateSimJobRequest request;
  v1::Scene& scene = *request.mutable_spec()->mutable_scene();
  scene = swing(3, -1.0, 10.0, 1e-2);
  scene.mutable_yarn()->set_radius_m(-1.0);
  scene.set_name(std::string(5'000'000, 'N'));
  request.set_request_id("a b");
  request.mutable_spec()->set_threads(5000);
  request.mutable_spec()->GetReflection()->MutableUnknownFields(request.mutable_spec())->AddVarint(4711, 1);
  const grpc::Status refused = create_spec(request);
  expect_error(refused, grpc::StatusCode::INVALID_ARGUMENT, "INVALID_SCENE");
  const std::vector<std::string> fields = violated_fields(refused);
  for (const char* field : {"spec", "spec.work", "spec.threads", "request_id", "spec.scene.name",
                            "spec.scene.duration_s", "spec.scene.yarn.radius_m"}) {
    EXPECT_TRUE(contains(fields, field)) << field;
  }
  EXPECT_TRUE(contains(violated_fields(create_spec({})), "spec"));
}

}  // namespace
}  // namespace slipstitch::test
