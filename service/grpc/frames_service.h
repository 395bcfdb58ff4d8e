// SPDX-License-Identifier: MIT
#pragma once

#include "grpc/stream_reactor.h"
#include "slipstitch/v1/frames.grpc.pb.h"

namespace slipstitch {

class FramesService final : public v1::Frames::CallbackService {
 public:
  FramesService(jobs::JobStore& store, StreamOptions streams) : store_(store), streams_(streams) {}

  grpc::ServerWriteReactor<v1::StreamFramesResponse>* StreamFrames(grpc::CallbackServerContext* context,
                                                                   const v1::StreamFramesRequest* request) override;

 private:
  jobs::JobStore& store_;
  const StreamOptions streams_;
};

}  // namespace slipstitch
