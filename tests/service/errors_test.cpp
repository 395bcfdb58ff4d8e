// SPDX-License-Identifier: MIT
#include <cmath>
#include <functional>
#include <limits>

#include "scene_io/load_scene.h"
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
  const auto list = [&](int size, const std::string& token) {
    v1::ListSimJobsRequest request;
    request.set_page_size(size);
    request.set_page_token(token);
    grpc::ClientContext context;
    v1::ListSimJobsResponse response;
    return jobs_->ListSimJobs(&context, request, &response);
  };
  expect_error(list(-1, ""), grpc::StatusCode::INVALID_ARGUMENT, "INVALID_FIELD");
  expect_error(list(1, "nonsense"), grpc::StatusCode::INVALID_ARGUMENT, "INVALID_PAGE_TOKEN");
  EXPECT_TRUE(list(1000, "").ok()) << "too large is 100";
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

// The same mistake as a message and as a scene file.
struct BadScene {
  std::string what, field;
  std::function<void(v1::Scene&)> spoil;
  std::string json;
  grpc::StatusCode code = grpc::StatusCode::INVALID_ARGUMENT;
};

std::string file_with(const std::string& members) {
  return "{\"yarns\": [{\"points_m\": [0, 0, 0, 0.1, 0, 0]}], \"effects\": {\"stretch\": {}}, " + members + "}";
}

std::string chart_file(const std::string& rows) {
  return "{\"knit\": {\"chart\": {\"rows\": " + rows +
         "}, \"gauge\": {\"course_spacing_m\": 0.0029, \"wale_spacing_m\": 0.00203}}, \"effects\": {\"stretch\": {}}}";
}

void set_chart(v1::Scene& scene, const std::vector<std::string>& rows) {
  v1::Knit& knit = *scene.mutable_knit();
  for (const std::string& row : rows) knit.mutable_chart()->add_rows(row);
  knit.mutable_gauge()->set_course_spacing_m(0.0029);
  knit.mutable_gauge()->set_wale_spacing_m(0.00203);
}

std::vector<BadScene> bad_scenes() {
  return {
      {"negative radius", "yarn.radius_m", [](v1::Scene& scene) { scene.mutable_yarn()->set_radius_m(-1.0); },
       file_with("\"yarn\": {\"radius_m\": -1}")},
      {"not a number", "yarn.radius_m", [](v1::Scene& scene) { scene.mutable_yarn()->set_radius_m(std::nan("")); },
       file_with("\"yarn\": {\"radius_m\": \"NaN\"}")},
      {"infinite duration", "duration_s",
       [](v1::Scene& scene) { scene.set_duration_s(std::numeric_limits<double>::infinity()); },
       file_with("\"duration_s\": \"Infinity\"")},
      {"row of another length", "knit.chart.rows[1]",
       [](v1::Scene& scene) {
         set_chart(scene, {"KKK", "KK", "KKK"});
       },
       chart_file("[\"KKK\", \"KK\", \"KKK\"]")},
      {"unknown stitch", "knit.chart.rows[0]",
       [](v1::Scene& scene) {
         set_chart(scene, {"KXK", "KKK"});
       },
       chart_file("[\"KXK\", \"KKK\"]")},
      {"too many frames", "frames_per_s",
       [](v1::Scene& scene) {
         scene.set_duration_s(1e6);
         scene.set_frames_per_s(1e3);
       },
       file_with("\"duration_s\": 1e6, \"frames_per_s\": 1e3"), grpc::StatusCode::RESOURCE_EXHAUSTED},
      {"accuracy, not supported yet", "accuracy",
       [](v1::Scene& scene) { scene.mutable_accuracy()->set_tolerance_m(1e-6); },
       file_with("\"accuracy\": {\"tolerance_m\": 1e-6}")},
  };
}

bool contains(const std::vector<std::string>& fields, const std::string& field) {
  return std::find(fields.begin(), fields.end(), field) != fields.end();
}

TEST_F(ErrorsTest, BadScenesAreRefusedAlikeFromFilesAndOverTheWire) {
  start_server();
  for (const BadScene& bad : bad_scenes()) {
    SCOPED_TRACE(bad.what);
    v1::Scene scene = swing(3, 0.1, 10.0, 1e-2);
    bad.spoil(scene);
    v1::SimJob job;
    const grpc::Status refused = create(scene, "", job);
    const bool too_big = bad.code == grpc::StatusCode::RESOURCE_EXHAUSTED;
    expect_error(refused, bad.code, too_big ? "SCENE_TOO_BIG" : "INVALID_SCENE");
    EXPECT_TRUE(contains(violated_fields(refused), bad.field)) << refused.error_message();

    const LoadResult loaded = load_scene_json(bad.json);
    ASSERT_TRUE(std::holds_alternative<Issues>(loaded));
    std::vector<std::string> fields;
    for (const Issue& issue : std::get<Issues>(loaded)) fields.push_back(issue.path);
    EXPECT_TRUE(contains(fields, bad.field)) << fields.front();
  }
  EXPECT_TRUE(list_names().empty());
  EXPECT_TRUE(std::filesystem::is_empty(folder_ / "data/jobs"));
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
  for (const char* field : {"spec", "spec.work", "spec.threads", "request_id", "name", "duration_s", "yarn.radius_m"}) {
    EXPECT_TRUE(contains(fields, field)) << field;
  }
  EXPECT_TRUE(contains(violated_fields(create_spec({})), "spec"));
}

TEST_F(ErrorsTest, AFieldOfANewerSchemaIsRefused) {
  start_server();
  v1::Scene scene = swing(3, 0.1, 10.0, 1e-2);
  scene.GetReflection()->MutableUnknownFields(&scene)->AddVarint(4711, 1);
  v1::SimJob job;
  expect_error(create(scene, "", job), grpc::StatusCode::INVALID_ARGUMENT, "INVALID_SCENE");
}

}  // namespace
}  // namespace slipstitch::test
