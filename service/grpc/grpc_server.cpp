// SPDX-License-Identifier: MIT
#include "grpc/grpc_server.h"

#include <grpc/support/log.h>
#include <grpcpp/ext/proto_server_reflection_plugin.h>
#include <grpcpp/health_check_service_interface.h>
#include <grpcpp/server.h>
#include <grpcpp/server_builder.h>

#include "grpc/frames_service.h"
#include "grpc/sim_jobs_service.h"

namespace slipstitch {
namespace {

// gRPC itself refuses what is above its receive limit, in words we cannot choose. So it lets this much more in, and
// CreateSimJob refuses it unparsed, naming the flag.
constexpr int kReceiveSlackMib = 256;
constexpr int kMinPingInterval_ms = 10'000;

void say_nothing(gpr_log_func_args*) {}

// gRPC logs lines of its own when an address cannot be had; the caller says so in ours.
std::unique_ptr<grpc::Server> build_quietly(grpc::ServerBuilder& builder) {
  gpr_set_log_function(say_nothing);
  std::unique_ptr<grpc::Server> server = builder.BuildAndStart();
  gpr_set_log_function(nullptr);
  return server;
}

void configure(grpc::ServerBuilder& builder, const GrpcOptions& options) {
  builder.AddChannelArgument(GRPC_ARG_ALLOW_REUSEPORT, 0);  // else two servers share a port unnoticed
  builder.AddChannelArgument(GRPC_ARG_HTTP2_MIN_RECV_PING_INTERVAL_WITHOUT_DATA_MS, kMinPingInterval_ms);
  builder.SetMaxReceiveMessageSize((options.max_scene_mib + kReceiveSlackMib) << 20);
}

}  // namespace

struct GrpcServer::State {
  State(jobs::JobStore& job_store, Predictor& predictor, const GrpcOptions& options)
      : store(job_store),
        jobs(job_store, predictor, options.max_scene_mib, options.streams),
        frames(job_store, options.streams) {}

  jobs::JobStore& store;
  SimJobsService jobs;
  FramesService frames;
  std::string address;
  std::unique_ptr<grpc::Server> server;
};

GrpcServer::GrpcServer(std::unique_ptr<State> state) : state_(std::move(state)) {}

GrpcServer::~GrpcServer() { stop(0.0); }

jobs::Outcome<std::unique_ptr<GrpcServer>> GrpcServer::start(jobs::JobStore& store, Predictor& predictor,
                                                             const GrpcOptions& options) {
  auto state = std::make_unique<State>(store, predictor, options);
  grpc::EnableDefaultHealthCheckService(true);
  grpc::reflection::InitProtoReflectionServerBuilderPlugin();
  grpc::ServerBuilder builder;
  configure(builder, options);
  int port = 0;
  builder.AddListeningPort(options.address, grpc::InsecureServerCredentials(), &port);
  builder.RegisterService(&state->jobs);
  builder.RegisterService(&state->frames);
  state->server = build_quietly(builder);
  if (!state->server || port == 0) {
    return jobs::Error{jobs::ErrorCode::unavailable,
                       "CANNOT_LISTEN",
                       "cannot listen on " + options.address + ": it is in use, or not of this machine",
                       {},
                       {},
                       {}};
  }
  state->address = options.address.substr(0, options.address.rfind(':') + 1) + std::to_string(port);
  for (const char* service : {v1::SimJobs::service_full_name(), v1::Frames::service_full_name()}) {
    state->server->GetHealthCheckService()->SetServingStatus(service, true);
  }
  return std::unique_ptr<GrpcServer>(new GrpcServer(std::move(state)));
}

const std::string& GrpcServer::address() const { return state_->address; }

void GrpcServer::stop(double grace_s) {
  if (!state_->server) return;
  state_->server->GetHealthCheckService()->SetServingStatus(false);
  const auto grace =
      std::chrono::duration_cast<std::chrono::system_clock::duration>(std::chrono::duration<double>(grace_s));
  const auto deadline = std::chrono::system_clock::now() + grace;
  state_->store.stop();
  state_->store.wait_unwatched(grace_s);  // who calls meanwhile is still told why not; from Shutdown on nobody is
  state_->server->Shutdown(deadline);
  state_->server->Wait();
  state_->server.reset();
}

}  // namespace slipstitch
