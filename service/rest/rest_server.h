// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>

#include "api/predictor.h"
#include "jobs/job_store.h"

namespace slipstitch::rest {

struct RestOptions {
  std::string address = "127.0.0.1:8651";  // port 0: any free one
  int max_scene_mib = 16;
  std::chrono::milliseconds stall_timeout{30'000};    // a client that takes nothing for so long is cut off
  std::chrono::milliseconds request_timeout{30'000};  // for a request to be complete, and between requests
  std::chrono::milliseconds keep_alive{15'000};       // a stream that says nothing for so long says that it is there
  int max_connections = 512;
  std::size_t max_export_bytes = std::size_t{64} << 20;  // of frames' files being sent; above it no more are made
  std::filesystem::path viewer;                          // folder of the viewer's files
};

/// REST, events, streams and the viewer on one port. One thread does all input and output and never waits; what checks
/// new jobs, what looks up, what feeds streams and what makes frames' files each have one more, so that none holds up
/// the others.
class RestServer {
 public:
  /// Listens and serves. Error: the address cannot be had.
  static jobs::Outcome<std::unique_ptr<RestServer>> start(jobs::JobStore& store, Predictor& predictor,
                                                          const RestOptions& options);
  ~RestServer();

  const std::string& address() const;  // with the port in use

  /// Takes no new connections, ends idle ones, gives requests on their way `grace_s` and cuts off what is left. Streams
  /// end by themselves when the store stops.
  void stop(double grace_s);

 private:
  struct State;
  explicit RestServer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace slipstitch::rest
