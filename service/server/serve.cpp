// SPDX-License-Identifier: MIT
#include "server/serve.h"

#include <signal.h>

#include <chrono>
#include <iostream>
#include <memory>

#include "api/predictor.h"
#include "grpc/grpc_server.h"
#include "jobs/local_executor.h"
#include "jobs/worker_environment.h"
#include "rest/rest_server.h"
#include "server/options.h"

namespace slipstitch {
namespace {

constexpr double kJobGrace_s = 10.0;  // for a worker to finish its Newton iteration

sigset_t stop_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  return signals;
}

jobs::Outcome<std::unique_ptr<jobs::JobStore>> open_store(const ServerOptions& options) {
  jobs::Outcome<std::unique_ptr<jobs::Executor>> executor = jobs::make_local_executor(options.worker);
  if (!executor) return executor.error();
  jobs::Outcome<jobs::DataDir> data = jobs::DataDir::open(options.data_dir);
  if (!data) return data.error();
  const jobs::StoreOptions store{options.slots, options.queue, jobs::kDefaultThreads, jobs::blas_core_for_jobs()};
  std::vector<std::string> warnings;
  auto opened = std::make_unique<jobs::JobStore>(std::move(*data), store, std::move(*executor), warnings);
  for (const std::string& warning : warnings) std::cerr << "slipstitchd: " << warning << "\n";
  return opened;
}

int report(const std::string& program, const jobs::Error& error) {
  std::cerr << program << ": " << error.message << "\n";
  return 1;
}

void wait_for_stop_signal() {
  const sigset_t signals = stop_signals();
  int signal = 0;
  while (sigwait(&signals, &signal) != 0) {
  }
}

std::chrono::milliseconds milliseconds_of(double seconds) {
  return std::chrono::ceil<std::chrono::milliseconds>(std::chrono::duration<double>(seconds));
}

// Null: not asked for.
jobs::Outcome<std::unique_ptr<rest::RestServer>> start_http(jobs::JobStore& store, Predictor& predictor,
                                                            const ServerOptions& options) {
  if (!options.http_address) return std::unique_ptr<rest::RestServer>();
  rest::RestOptions rest;
  rest.address = *options.http_address;
  rest.max_scene_mib = options.max_scene_mib;
  rest.stall_timeout = milliseconds_of(options.stall_timeout_s);
  rest.request_timeout = milliseconds_of(options.http_timeout_s);
  rest.max_connections = options.http_connections;
  rest.viewer = options.viewer;
  return rest::RestServer::start(store, predictor, rest);
}

int run_server(const ServerOptions& options, const std::string& program) {
  auto store = open_store(options);
  if (!store) return report(program, store.error());
  Predictor predictor(options.worker, milliseconds_of(options.prediction_timeout_s));
  auto server = GrpcServer::start(
      **store, predictor, {options.grpc_address, options.max_scene_mib, {milliseconds_of(options.stall_timeout_s)}});
  if (!server) return report(program, server.error());
  auto http = start_http(**store, predictor, options);
  if (!http) return report(program, http.error());
  std::cout << "slipstitchd ready grpc=" << (*server)->address() << " http=" << (*http ? (*http)->address() : "none")
            << std::endl;
  wait_for_stop_signal();
  std::cerr << program << ": stopping" << (options.stop_jobs ? ", and the jobs with it" : "; workers run on") << "\n";
  predictor.stop();
  (*server)->stop(options.stop_grace_s);
  if (*http) (*http)->stop(options.stop_grace_s);
  if (options.stop_jobs) (*store)->stop_jobs(kJobGrace_s);
  return 0;
}

}  // namespace

int serve(const std::vector<std::string>& arguments, const std::string& program) {
  const ParsedOptions parsed = parse_server_options(arguments, program);
  if (!parsed.options) {
    (parsed.exit_code == 0 ? std::cout : std::cerr) << parsed.output;
    return parsed.exit_code;
  }
  const sigset_t signals = stop_signals();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);  // inherited by every thread; waited for by this one
  return run_server(*parsed.options, program);
}

}  // namespace slipstitch
