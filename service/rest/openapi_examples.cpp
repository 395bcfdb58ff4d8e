// SPDX-License-Identifier: MIT
#include "rest/openapi_examples.h"

#include <stdexcept>

#include "api/create_job.h"
#include "api/job_message.h"
#include "api/rpc_status.h"
#include "formats/formats.h"
#include "platform/version.h"
#include "rest/api_json.h"
#include "rest/http_error.h"

namespace slipstitch::rest {
namespace {

using Json = nlohmann::ordered_json;

constexpr char kCreate[] = R"({
  "spec": {
    "scene": {
      "name": "swatch",
      "knit": {
        "preset": {"name": "stockinette", "courses": 4, "wales": 4},
        "gauge": {"yarn_per_stitch_m": 0.011},
        "relax_repeat": false
      },
      "effects": {"inertia": {}, "gravity": {}, "stretch": {}, "bending": {}},
      "handles": [{"where": {"edge": "TOP"}}],
      "duration_s": 0.1,
      "frames_per_s": 30
    },
    "simulate": {}
  },
  "request_id": "swatch-1"
})";

jobs::Job example_job() {
  jobs::Job job;
  job.id = kExampleId;
  job.info = {std::string("simJobs/") + kExampleId, "swatch-1", std::string(64, 'a'), 1, "Haswell",
              "2026-11-23T08:00:00.000000Z",        "swatch"};
  job.state = jobs::JobState::running;
  job.revision = 1795422037779777;
  job.start_time = "2026-11-23T08:00:00.100000Z";
  job.progress.emplace();
  *job.progress = progress_info({0.05, 0.1, 2, 4, 50, 150, 1e-3, 1e-9, {}, 0.4});
  return job;
}

Json json_of(const google::protobuf::Message& message) { return Json::parse(api_json(message)); }

Json list_example() {
  v1::ListSimJobsResponse list;
  *list.add_jobs() = message_from_job(example_job());
  return json_of(list);
}

CurveFrame example_frame() {
  CurveFrame frame;
  frame.radius_m = 0.5e-3;
  frame.first = {0, 2};
  frame.points = {Vec3::Zero(), Vec3(0.01, 0.0, 0.0)};
  frame.arc_length_m = {0.0, 0.01};
  frame.slid_m = {0.0, 0.0};
  frame.tension_n = {0.0, 0.0};
  return frame;
}

Json artefacts_example() {
  v1::ListArtefactsResponse list;
  v1::Artefact& history = *list.add_artefacts();
  history.set_name(artefact_name(kExampleId, "history.csv"));
  history.set_size_bytes(420);
  return json_of(list);
}

Json artefact_example(std::string_view type) {
  if (type == "application/json") return {{"name", "swatch"}};
  if (type.starts_with("text/csv")) return "frame,t_s,steps\n0,0,0\n";
  return nullptr;
}

jobs::Error invalid_scene() {
  return jobs::error_from_issues({{"spec.scene.yarn.radius_m", "-1", "a finite number > 0"}});
}

jobs::Error invalid_page_token() {
  jobs::Error error = jobs::invalid_field("page_token", "x", "next_page_token of the same list");
  error.reason = "INVALID_PAGE_TOKEN";
  return error;
}

jobs::Error refused(jobs::ErrorCode code, std::string reason, std::string message) {
  return {code, std::move(reason), std::move(message), {}, {}, {}};
}

// Of those that jobs are refused for.
std::vector<jobs::Error> job_errors() {
  using enum jobs::ErrorCode;
  jobs::Error queue_full =
      refused(resource_exhausted, "QUEUE_FULL", "the queue is full (--queue 100); try again when a job has ended");
  queue_full.metadata = {{"limit", "100"}, {"flag", "--queue"}};
  queue_full.retry_after_s = 5.0;
  const std::string job = std::string("simJobs/") + kExampleId;
  return {invalid_scene(),
          jobs::invalid_field("page_size", "-1", "0 or more"),
          invalid_page_token(),
          request_too_big(20'000'000, 16),
          queue_full,
          refused(already_exists, "REQUEST_ID_REUSED", "request_id a was used for " + job + " with another spec"),
          jobs::job_not_found(kExampleId),
          jobs::no_frames(kExampleId),
          refused(not_found, "FRAME_NOT_FOUND", "job " + job + " has no frame 7; it has 3 so far"),
          refused(not_found, "ARTEFACT_NOT_FOUND", "job " + job + " has no artefact 'a.csv'"),
          jobs::wrong_state(kExampleId, "JOB_ENDED", "has ended already"),
          jobs::wrong_state(kExampleId, "JOB_NOT_ENDED", "has not ended; cancel it first"),
          jobs::server_stopping(),
          jobs::storage_failed("frames.log: record at offset 4096 has a wrong checksum")};
}

std::vector<HttpError> all_errors() {
  std::vector<HttpError> errors{malformed_request("GET has no body"),
                                wrong_origin("http://example.com"),
                                method_not_allowed("PATCH", "GET, HEAD"),
                                request_timeout(30.0),
                                unsupported_media_type("text/plain"),
                                wrong_host("example.com"),
                                headers_too_big(16 * 1024),
                                too_many_connections(512),
                                too_many_uploads(8),
                                too_many_exports(std::size_t{64} << 20, 30.0)};
  for (jobs::Error& error : job_errors()) errors.push_back(http_error(std::move(error)));
  return errors;
}

}  // namespace

Json request_example(Operation operation) {
  return operation == Operation::create_job ? Json::parse(kCreate) : Json(nullptr);
}

Json response_example(Operation operation, std::string_view type) {
  if (type == "application/octet-stream") return nullptr;
  switch (operation) {
    case Operation::create_job:
    case Operation::get_job:
    case Operation::cancel_job:
      return json_of(message_from_job(example_job()));
    case Operation::list_jobs:
      return list_example();
    case Operation::delete_job:
      return Json::object();
    case Operation::watch_job:
      return "event: job\nid: 1795422037779777\ndata: " + api_json(message_from_job(example_job())) + "\n\n";
    case Operation::get_frame:
      return type == "model/obj" ? Json(write_obj(example_frame())) : Json::parse(write_json(example_frame()));
    case Operation::list_artefacts:
      return artefacts_example();
    case Operation::get_artefact:
      return artefact_example(type);
    case Operation::health:
      return "ok\n";
    case Operation::readiness:
      return "ready\n";
    case Operation::metrics:
      return "# TYPE slipstitch_jobs gauge\nslipstitch_jobs{state=\"queued\"} 0\n";
    case Operation::version:
      return {{"version", version_string()}, {"api", "v1"}, {"blas_core", "Haswell"}, {"max_scene_mib", 16}};
    default:
      return nullptr;
  }
}

ErrorExample error_example(std::string_view reason) {
  for (const HttpError& error : all_errors()) {
    if (error.error.reason == reason) return {error.status, json_of(rpc_status(error.error))};
  }
  throw std::invalid_argument("no error has the reason " + std::string(reason));
}

}  // namespace slipstitch::rest
