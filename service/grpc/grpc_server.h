// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "api/predictor.h"
#include "grpc/stream_reactor.h"
#include "jobs/job_store.h"

namespace slipstitch {

struct GrpcOptions {
  std::string address = "127.0.0.1:50651";  // port 0: any free one
  int max_scene_mib = 16;
  StreamOptions streams;
};

/// SimJobs, Frames, health and reflection on one port.
class GrpcServer {
 public:
  /// Listens, not serving yet. Error: the address cannot be had.
  static jobs::Outcome<std::unique_ptr<GrpcServer>> start(jobs::JobStore& store, Predictor& predictor,
                                                          const GrpcOptions& options);
  ~GrpcServer();

  const std::string& address() const;  // with the port in use

  /// First not serving by the health service, then no new jobs and every stream ended with SERVER_STOPPING (stops the
  /// store). Until those streams are gone calls are answered, at most for `grace_s`; what is not done then is cut off.
  void stop(double grace_s);

 private:
  struct State;
  explicit GrpcServer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace slipstitch
