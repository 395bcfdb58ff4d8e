// SPDX-License-Identifier: MIT
#pragma once

#include <grpcpp/grpcpp.h>
#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "google/rpc/error_details.pb.h"
#include "google/rpc/status.pb.h"
#include "run_dir/run_dir.h"
#include "server_process.h"
#include "slipstitch/v1/frames.grpc.pb.h"
#include "slipstitch/v1/job.grpc.pb.h"
#include "support/sample_run.h"

namespace slipstitch::test {

/// A yarn of `points` points that hangs from its first one and swings; runs for `duration_s` with `frames_per_s`.
v1::Scene swing(int points, double duration_s, double frames_per_s, double time_step_s);
/// About a second a frame in simulated time, a million frames: nobody waits for its end.
v1::Scene endless_swing();

/// What google.rpc.Status carries.
struct Details {
  google::rpc::Status status;
  std::vector<google::rpc::ErrorInfo> infos;
  std::vector<google::rpc::BadRequest> bad_requests;
  std::vector<google::rpc::RetryInfo> retries;
};
Details details_of(const google::rpc::Status& status);
Details details_of(const grpc::Status& status);

/// That an error has this code, exactly one ErrorInfo with this reason, and its own code and message once more inside.
void expect_error(const grpc::Status& status, grpc::StatusCode code, const std::string& reason);

struct ReceivedFrame {
  double t = 0.0;
  std::vector<double> q;
  bool operator==(const ReceivedFrame&) const = default;
};

/// One StreamFrames call, put together and checked for order and gaps within frames.
struct Received {
  std::optional<v1::FrameHeader> header;
  std::map<std::uint32_t, ReceivedFrame> frames;  // complete ones
  std::optional<v1::StreamEnd> end;
  std::size_t largest_message = 0;  // [byte]
  grpc::Status status;
};

class ServiceTest : public ::testing::Test {
 protected:
  void TearDown() override;

  /// On a free port, with the test's data directory.
  void start_server(const std::vector<std::string>& more = {});
  void kill_server();

  grpc::Status create(const v1::Scene& scene, const std::string& request_id, v1::SimJob& job);
  v1::SimJob must_create(const v1::Scene& scene, const std::string& request_id = "");
  grpc::Status create_study(const v1::Scene& scene, double budget_s, v1::SimJob& job);  // a quick one
  v1::SimJob must_create_study(const v1::Scene& scene, double budget_s = 0.0);
  v1::SimJob get(const std::string& name);
  std::vector<std::string> list_names();
  grpc::Status cancel(const std::string& name);
  grpc::Status remove(const std::string& name);
  /// Watches to the end of the stream and returns every snapshot.
  std::vector<v1::SimJob> watch(const std::string& name, grpc::Status* status = nullptr);
  v1::SimJob wait_for_end(const std::string& name) { return watch(name).back(); }
  /// By watching: returns once the job runs and has written `frames` frames.
  v1::SimJob wait_for_frames(const std::string& name, std::uint32_t frames);
  /// Likewise, a study that has kept `runs` runs.
  v1::SimJob wait_for_runs(const std::string& name, std::size_t runs);
  Received stream(const v1::StreamFramesRequest& request);
  Received stream_all(const std::string& name);

  RunDir folder_of(const std::string& name) const;
  /// Content of every run that a study has kept, by file.
  std::map<std::string, std::string> runs_of(const std::string& name) const;
  std::vector<std::string> artefacts_of(const std::string& name);
  std::string read_artefact(const std::string& name, const std::string& file);
  WorkerInfo worker_of(const std::string& name) const;

  TemporaryFolder folder_;
  std::unique_ptr<ServerProcess> server_;
  std::shared_ptr<grpc::Channel> channel_;
  std::unique_ptr<v1::SimJobs::Stub> jobs_;
  std::unique_ptr<v1::Frames::Stub> frames_;
};

v1::StreamFramesRequest frames_request(const std::string& name, std::uint32_t first = 0, std::uint32_t stride = 1);

}  // namespace slipstitch::test
