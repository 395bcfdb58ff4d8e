// SPDX-License-Identifier: MIT
#include "grpc/sim_jobs_service.h"

#include <grpcpp/support/proto_buffer_reader.h>

#include "api/artefacts.h"
#include "api/create_job.h"
#include "api/job_message.h"
#include "api/list_jobs.h"
#include "grpc/artefacts.h"
#include "grpc/message_values.h"
#include "model/check_values.h"
#include "scene_io/json_parse.h"

namespace slipstitch {
namespace {

grpc::ServerUnaryReactor* answer(grpc::CallbackServerContext* context, const grpc::Status& status) {
  grpc::ServerUnaryReactor* reactor = context->DefaultReactor();
  reactor->Finish(status);
  return reactor;
}

template <class T>
grpc::Status status_of(const jobs::Outcome<T>& outcome) {
  return outcome ? grpc::Status::OK : grpc_status(outcome.error());
}

grpc::ServerUnaryReactor* answer_job(grpc::CallbackServerContext* context, const jobs::Outcome<jobs::Job>& job,
                                     v1::SimJob* response) {
  if (job) *response = message_from_job(*job);
  return answer(context, status_of(job));
}

bool holds_few_values(const grpc::ByteBuffer& request) {
  grpc::ByteBuffer bytes(request);
  grpc::ProtoBufferReader reader(&bytes);
  return holds_at_most(kMaxJsonValues, *v1::CreateSimJobRequest::descriptor(), reader);
}

jobs::Error request_of_too_many_values() {
  return jobs::error_from_issues({too_many("request", "too many", static_cast<int>(kMaxJsonValues), "values")});
}

class WatchReactor final : public StreamReactor<v1::SimJob> {
 public:
  using StreamReactor::StreamReactor;

 private:
  Step<v1::SimJob> next() override {
    const jobs::Outcome<jobs::Job> now = store().get(job());
    if (terminal_sent_) return jobs::Outcome<jobs::Done>(jobs::Done{});
    if (!now) return jobs::Outcome<jobs::Done>(now.error());
    if (now->revision <= revision_) return NothingYet{};
    revision_ = now->revision;
    terminal_sent_ = jobs::is_terminal(now->state);
    return message_from_job(*now);
  }

  std::uint64_t revision_ = 0;
  bool terminal_sent_ = false;
};

}  // namespace

grpc::ServerUnaryReactor* SimJobsService::CreateSimJob(Context* context, const grpc::ByteBuffer* request,
                                                       grpc::ByteBuffer* response) {
  if (request->Length() > static_cast<std::size_t>(max_scene_mib_) << 20) {
    return answer(context, grpc_status(request_too_big(request->Length(), max_scene_mib_)));
  }
  if (!holds_few_values(*request)) return answer(context, grpc_status(request_of_too_many_values()));
  grpc::ByteBuffer bytes(*request);  // shares the slices; reading consumes the copy
  v1::CreateSimJobRequest message;
  if (!grpc::SerializationTraits<v1::CreateSimJobRequest>::Deserialize(&bytes, &message).ok()) {
    return answer(context, grpc_status(jobs::invalid_field("request", "other bytes", "a CreateSimJobRequest")));
  }
  const jobs::Outcome<jobs::Job> job = create_job(store_, message);
  if (!job) return answer(context, grpc_status(job.error()));
  grpc::ServerUnaryReactor* reactor = context->DefaultReactor();
  const auto finish = [reactor, response, answered = message_from_job(*job)](const v1::Prediction* prediction) {
    v1::SimJob whole = answered;
    if (prediction != nullptr) *whole.mutable_prediction() = *prediction;
    bool own_buffer = false;
    reactor->Finish(grpc::SerializationTraits<v1::SimJob>::Serialize(whole, response, &own_buffer));
  };
  const bool posted =
      wants_prediction(message) && predictor_.post(
                                       message.spec().scene(), [context] { return !context->IsCancelled(); }, finish);
  if (!posted) finish(nullptr);
  return reactor;
}

grpc::ServerUnaryReactor* SimJobsService::GetSimJob(Context* context, const v1::GetSimJobRequest* request,
                                                    v1::SimJob* response) {
  return answer_job(context, store_.get(id_from_name(request->name())), response);
}

grpc::ServerUnaryReactor* SimJobsService::ListSimJobs(Context* context, const v1::ListSimJobsRequest* request,
                                                      v1::ListSimJobsResponse* response) {
  const jobs::Outcome<v1::ListSimJobsResponse> page = list_jobs(store_, *request);
  if (page) *response = *page;
  return answer(context, status_of(page));
}

grpc::ServerUnaryReactor* SimJobsService::CancelSimJob(Context* context, const v1::CancelSimJobRequest* request,
                                                       v1::SimJob* response) {
  return answer_job(context, store_.cancel(id_from_name(request->name())), response);
}

grpc::ServerUnaryReactor* SimJobsService::DeleteSimJob(Context* context, const v1::DeleteSimJobRequest* request,
                                                       google::protobuf::Empty*) {
  return answer(context, status_of(store_.remove(id_from_name(request->name()))));
}

grpc::ServerUnaryReactor* SimJobsService::ListArtefacts(Context* context, const v1::ListArtefactsRequest* request,
                                                        v1::ListArtefactsResponse* response) {
  const std::string id = id_from_name(request->name());
  const jobs::Outcome<RunDir> dir = store_.folder(id);
  if (dir) *response = artefacts_of(id, *dir);
  return answer(context, status_of(dir));
}

grpc::ServerWriteReactor<v1::SimJob>* SimJobsService::WatchSimJob(Context*, const v1::WatchSimJobRequest* request) {
  const auto reactor = std::make_shared<WatchReactor>(store_, id_from_name(request->name()), streams_);
  reactor->start();
  return reactor.get();
}

grpc::ServerWriteReactor<v1::ArtefactChunk>* SimJobsService::GetArtefact(Context*,
                                                                         const v1::GetArtefactRequest* request) {
  return stream_artefact(store_, parse_artefact_name(request->name()), streams_);
}

}  // namespace slipstitch
