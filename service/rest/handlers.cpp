// SPDX-License-Identifier: MIT
#include "rest/handlers.h"

#include <nlohmann/json.hpp>

#include "api/create_job.h"
#include "api/job_message.h"
#include "api/list_jobs.h"
#include "api/predictor.h"
#include "google/protobuf/empty.pb.h"
#include "jobs/worker_environment.h"
#include "platform/version.h"
#include "rest/api_json.h"
#include "rest/artefact_body.h"
#include "rest/content_type.h"
#include "rest/frame_file.h"
#include "rest/frame_records.h"
#include "rest/job_events.h"

namespace slipstitch::rest {
namespace {

Response message_response(const google::protobuf::Message& message) { return json_response(api_json(message) + "\n"); }

Response job_response(const jobs::Outcome<jobs::Job>& job) {
  return job ? message_response(message_from_job(*job)) : error_response(job.error());
}

Response create(const std::string& body, const Service& service) {
  ReadRequest read = read_create_request(body);
  if (read.malformed) {
    jobs::Error error = jobs::error_from_issues(std::move(read.issues));
    if (error.code == jobs::ErrorCode::invalid_argument) error.reason = "INVALID_FIELD";
    return error_response(error);
  }
  const jobs::Outcome<jobs::Job> job = create_job(service.store, read.request, std::move(read.issues));
  Response response = job_response(job);
  if (!job || !wants_prediction(read.request)) return response;
  const auto with = [answered = message_from_job(*job)](const v1::Prediction& prediction) {
    v1::SimJob message = answered;
    *message.mutable_prediction() = prediction;
    return api_json(message) + "\n";
  };
  response.prediction = ToPredict{std::move(*read.request.mutable_spec()->mutable_scene()), with};
  return response;
}

Response list(const Route& route, const Service& service) {
  const auto page = list_jobs(service.store, route.list);
  return page ? message_response(*page) : error_response(page.error());
}

bool is_empty_object(std::string text) {
  std::erase_if(text, [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; });
  return text == "{}";
}

Response cancel(const Route& route, const std::string& body, const Service& service) {
  if (!body.empty() && !is_empty_object(body)) {
    return error_response(jobs::invalid_field("request", "a body", "none, or {}"));
  }
  return job_response(service.store.cancel(route.id));
}

Response remove(const Route& route, const Service& service) {
  const auto removed = service.store.remove(route.id);
  return removed ? message_response(google::protobuf::Empty()) : error_response(removed.error());
}

Response events(const Route& route, const Service& service) {
  if (const auto job = service.store.get(route.id); !job) return error_response(job.error());
  if (service.store.stopping()) return error_response(jobs::server_stopping());
  Response response = text_response("text/event-stream", {});
  response.source = std::make_shared<JobEvents>(service.store, route.id, route.last_event_id);
  response.first = {"retry: 1000\n\n", Piece::Then::more};
  return response;
}

jobs::Outcome<RunDir> folder_of_frames(const Route& route, const Service& service) {
  const jobs::Outcome<jobs::Job> job = service.store.get(route.id);
  if (!job) return job.error();
  if (auto none = check_has_frames(*job)) return std::move(*none);
  return service.store.folder(route.id);
}

Response frames(const Route& route, const Service& service) {
  v1::StreamFramesRequest request = route.frames;
  request.set_name("simJobs/" + route.id);
  if (auto wrong = check_range(request)) return error_response(*wrong);
  const jobs::Outcome<RunDir> dir = folder_of_frames(route, service);
  if (!dir) return error_response(dir.error());
  if (service.store.stopping()) return error_response(jobs::server_stopping());
  Response response = text_response("application/octet-stream", {});
  const auto source = std::make_shared<FrameRecords>(service.store, route.id, *dir, request);
  response.first = source->next();
  if (!source->damage().empty()) {
    return error_response(jobs::Error{jobs::ErrorCode::data_loss, "STORAGE_FAILED", source->damage(), {}, {}, {}});
  }
  response.source = source;
  return response;
}

void name_file(const std::string& name, Response& response) {
  response.headers.emplace_back("Content-Disposition", "attachment; filename=\"" + name + "\"");
}

// What a job wrote may hold what its sender liked: shown, it has no origin, runs nothing and loads nothing.
void show_file(const std::string& name, Response& response) {
  response.headers.emplace_back("Content-Disposition", "inline; filename=\"" + name + "\"");
  response.headers.emplace_back(
      "Content-Security-Policy",
      "sandbox; default-src 'none'; style-src 'unsafe-inline'; img-src data:; base-uri 'none'; "
      "form-action 'none'; frame-ancestors 'none'");
  response.headers.emplace_back("Referrer-Policy", "no-referrer");
}

Response frame(const Route& route, const Service& service) {
  const jobs::Outcome<RunDir> dir = folder_of_frames(route, service);
  if (!dir) return error_response(dir.error());
  jobs::Outcome<std::string> file = frame_file(route.id, *dir, route.frame_index, *route.format);
  if (!file) return error_response(file.error());
  const std::string name = frame_file_name(*route.format, static_cast<int>(route.frame_index));
  Response response = text_response(content_type_of(name), std::move(*file));
  name_file(name, response);
  return response;
}

Response artefacts(const Route& route, const Service& service) {
  const jobs::Outcome<RunDir> dir = service.store.folder(route.id);
  return dir ? message_response(artefacts_of(route.id, *dir)) : error_response(dir.error());
}

Response artefact(const Route& route, const Service& service) {
  const jobs::Outcome<RunDir> dir = service.store.folder(route.id);
  if (!dir) return error_response(dir.error());
  jobs::Outcome<ArtefactReader> reader = ArtefactReader::open(*dir, {route.id, route.file});
  if (!reader) return error_response(reader.error());
  Response response = text_response(content_type_of(route.file), {});
  if (route.shown) {
    show_file(route.file, response);
  } else {
    name_file(route.file, response);
  }
  response.length = reader->total_bytes();
  response.source = std::make_shared<ArtefactBody>(std::move(*reader));
  response.first.then = Piece::Then::more;
  return response;
}

Response version(const Service& service) {
  const nlohmann::ordered_json document{{"version", version_string()},
                                        {"api", "v1"},
                                        {"blas_core", jobs::blas_core_for_jobs()},
                                        {"max_scene_mib", service.max_scene_mib}};
  return json_response(document.dump() + "\n");
}

Response readiness(const Service& service) {
  if (service.store.stopping()) return error_response(jobs::server_stopping());
  return text_response("text/plain; charset=utf-8", "ready\n");
}

}  // namespace

Response handle(const Route& route, const std::string& body, const Service& service) {
  switch (route.operation) {
    case Operation::create_job:
      return create(body, service);
    case Operation::list_jobs:
      return list(route, service);
    case Operation::get_job:
      return job_response(service.store.get(route.id));
    case Operation::delete_job:
      return remove(route, service);
    case Operation::cancel_job:
      return cancel(route, body, service);
    case Operation::watch_job:
      return events(route, service);
    case Operation::get_frame:
      return frame(route, service);
    case Operation::stream_frames:
      return frames(route, service);
    case Operation::list_artefacts:
      return artefacts(route, service);
    case Operation::get_artefact:
      return artefact(route, service);
    case Operation::health:
      return text_response("text/plain; charset=utf-8", "ok\n");
    case Operation::readiness:
      return readiness(service);
    case Operation::metrics:
      return text_response("text/plain; version=0.0.4; charset=utf-8", service.metrics.text(service.store));
    case Operation::version:
      return version(service);
    case Operation::openapi:
      return json_response(service.openapi);
    case Operation::viewer_file:
      break;
  }
  return service.files.answer(route);
}

}  // namespace slipstitch::rest
