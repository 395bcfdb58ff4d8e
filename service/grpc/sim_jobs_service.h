// SPDX-License-Identifier: MIT
#pragma once

#include <grpcpp/support/byte_buffer.h>

#include "api/predictor.h"
#include "grpc/stream_reactor.h"
#include "slipstitch/v1/job.grpc.pb.h"

namespace slipstitch {

/// The SimJobs service over a store. CreateSimJob is taken as bytes: one that is too big is refused before it is
/// parsed, with a message that names the flag.
class SimJobsService final : public v1::SimJobs::WithRawCallbackMethod_CreateSimJob<v1::SimJobs::CallbackService> {
 public:
  SimJobsService(jobs::JobStore& store, Predictor& predictor, int max_scene_mib, StreamOptions streams)
      : store_(store), predictor_(predictor), max_scene_mib_(max_scene_mib), streams_(streams) {}

  using Context = grpc::CallbackServerContext;
  template <class Message>
  using Stream = grpc::ServerWriteReactor<Message>;

  grpc::ServerUnaryReactor* CreateSimJob(Context* context, const grpc::ByteBuffer* request,
                                         grpc::ByteBuffer* response) override;
  grpc::ServerUnaryReactor* GetSimJob(Context* context, const v1::GetSimJobRequest* request,
                                      v1::SimJob* response) override;
  grpc::ServerUnaryReactor* ListSimJobs(Context* context, const v1::ListSimJobsRequest* request,
                                        v1::ListSimJobsResponse* response) override;
  grpc::ServerUnaryReactor* CancelSimJob(Context* context, const v1::CancelSimJobRequest* request,
                                         v1::SimJob* response) override;
  grpc::ServerUnaryReactor* DeleteSimJob(Context* context, const v1::DeleteSimJobRequest* request,
                                         google::protobuf::Empty* response) override;
  grpc::ServerUnaryReactor* ListArtefacts(Context* context, const v1::ListArtefactsRequest* request,
                                          v1::ListArtefactsResponse* response) override;
  Stream<v1::SimJob>* WatchSimJob(Context* context, const v1::WatchSimJobRequest* request) override;
  Stream<v1::ArtefactChunk>* GetArtefact(Context* context, const v1::GetArtefactRequest* request) override;

 private:
  jobs::JobStore& store_;
  Predictor& predictor_;
  const int max_scene_mib_;
  const StreamOptions streams_;
};

}  // namespace slipstitch
