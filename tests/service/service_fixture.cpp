// SPDX-License-Identifier: MIT
#include "service_fixture.h"

#include <signal.h>

#include <algorithm>
#include <thread>

namespace slipstitch::test {
namespace {

template <class Message>
void unpack(const google::protobuf::Any& any, std::vector<Message>& into) {
  Message message;
  if (any.UnpackTo(&message)) into.push_back(std::move(message));
}

// Adds a chunk; true when `data` is complete.
bool append_header(const v1::HeaderChunk& chunk, std::string& data) {
  EXPECT_EQ(chunk.offset(), data.size());
  data += chunk.data();
  return data.size() == chunk.total_bytes();
}

bool append_frame(const v1::FrameChunk& chunk, ReceivedFrame& frame) {
  EXPECT_EQ(chunk.offset(), frame.q.size());
  frame.t = chunk.t();
  frame.q.insert(frame.q.end(), chunk.q().begin(), chunk.q().end());
  return frame.q.size() == chunk.total();
}

void kill_worker(const RunDir& dir) {
  const Result<WorkerInfo> worker = read_worker(dir);
  if (!worker || !worker_alive(*worker)) return;
  ::kill(static_cast<pid_t>(worker->pid), SIGKILL);
  while (worker_alive(*worker)) std::this_thread::sleep_for(std::chrono::milliseconds(2));
}

}  // namespace

v1::Scene swing(int points, double duration_s, double frames_per_s, double time_step_s) {
  v1::Scene scene;
  scene.set_name("swing");
  v1::BareYarn& yarn = *scene.add_yarns();
  for (int i = 0; i < points; ++i) {
    for (const double x : {0.1 * i / (points - 1), 0.0, 0.0}) yarn.add_points_m(x);
  }
  scene.mutable_effects()->mutable_inertia();
  scene.mutable_effects()->mutable_gravity();
  scene.mutable_effects()->mutable_stretch();
  scene.add_handles()->mutable_where()->mutable_yarn_point();
  scene.set_duration_s(duration_s);
  scene.set_frames_per_s(frames_per_s);
  scene.mutable_fixed()->set_time_step_s(time_step_s);
  return scene;
}

v1::Scene endless_swing() { return swing(5, 900'000.0, 1.0, 1e-3); }

Details details_of(const google::rpc::Status& status) {
  Details details;
  details.status = status;
  for (const google::protobuf::Any& any : status.details()) {
    unpack(any, details.infos);
    unpack(any, details.bad_requests);
    unpack(any, details.retries);
  }
  return details;
}

Details details_of(const grpc::Status& status) {
  google::rpc::Status decoded;
  EXPECT_TRUE(decoded.ParseFromString(status.error_details()));
  return details_of(decoded);
}

void expect_error(const grpc::Status& status, grpc::StatusCode code, const std::string& reason) {
  EXPECT_EQ(status.error_code(), code) << status.error_message();
  const Details details = details_of(status);
  EXPECT_EQ(details.status.code(), code);
  EXPECT_EQ(details.status.message(), status.error_message());
  ASSERT_EQ(details.infos.size(), 1U);
  EXPECT_EQ(details.infos[0].reason(), reason);
  EXPECT_EQ(details.infos[0].domain(), "slipstitch");
}

void ServiceTest::start_server(const std::vector<std::string>& more) {
  std::vector<std::string> arguments{"--grpc", "127.0.0.1:0", "--data-dir", (folder_ / "data").string()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const bool http = std::find(more.begin(), more.end(), "--http") != more.end();
  if (!http) arguments.insert(arguments.end(), {"--http", "none"});
  server_ = std::make_unique<ServerProcess>(arguments);
  ASSERT_TRUE(server_->ready_line().starts_with("slipstitchd ready grpc=127.0.0.1:")) << server_->ready_line();
  ASSERT_EQ(server_->ready_line().ends_with(" http=none"), !http) << server_->ready_line();
  grpc::ChannelArguments channel_arguments;
  channel_arguments.SetInt(GRPC_ARG_ENABLE_HTTP_PROXY, 0);
  channel_arguments.SetInt(GRPC_ARG_USE_LOCAL_SUBCHANNEL_POOL, 1);
  channel_arguments.SetInt(GRPC_ARG_HTTP2_BDP_PROBE, 0);  // windows stay small: what is not read is soon held back
  channel_ = grpc::CreateCustomChannel(server_->address(), grpc::InsecureChannelCredentials(), channel_arguments);
  jobs_ = v1::SimJobs::NewStub(channel_);
  frames_ = v1::Frames::NewStub(channel_);
}

void ServiceTest::kill_server() {
  server_->signal(SIGKILL);
  server_->wait();
  server_.reset();
}

void ServiceTest::TearDown() {
  server_.reset();
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "data/jobs", error)) {
    kill_worker({entry.path()});
  }
}

grpc::Status ServiceTest::create(const v1::Scene& scene, const std::string& request_id, v1::SimJob& job) {
  v1::CreateSimJobRequest request;
  *request.mutable_spec()->mutable_scene() = scene;
  request.mutable_spec()->mutable_simulate();
  request.set_request_id(request_id);
  grpc::ClientContext context;
  return jobs_->CreateSimJob(&context, request, &job);
}

v1::SimJob ServiceTest::must_create(const v1::Scene& scene, const std::string& request_id) {
  v1::SimJob job;
  const grpc::Status status = create(scene, request_id, job);
  EXPECT_TRUE(status.ok()) << status.error_message();
  return job;
}

grpc::Status ServiceTest::create_study(const v1::Scene& scene, double budget_s, v1::SimJob& job) {
  v1::CreateSimJobRequest request;
  *request.mutable_spec()->mutable_scene() = scene;
  request.mutable_spec()->mutable_study()->set_quick(true);
  request.mutable_spec()->mutable_study()->set_budget_s(budget_s);
  grpc::ClientContext context;
  return jobs_->CreateSimJob(&context, request, &job);
}

v1::SimJob ServiceTest::must_create_study(const v1::Scene& scene, double budget_s) {
  v1::SimJob job;
  const grpc::Status status = create_study(scene, budget_s, job);
  EXPECT_TRUE(status.ok()) << status.error_message();
  return job;
}

v1::SimJob ServiceTest::get(const std::string& name) {
  v1::GetSimJobRequest request;
  request.set_name(name);
  grpc::ClientContext context;
  v1::SimJob job;
  const grpc::Status status = jobs_->GetSimJob(&context, request, &job);
  EXPECT_TRUE(status.ok()) << status.error_message();
  return job;
}

std::vector<std::string> ServiceTest::list_names() {
  grpc::ClientContext context;
  v1::ListSimJobsResponse response;
  EXPECT_TRUE(jobs_->ListSimJobs(&context, {}, &response).ok());
  std::vector<std::string> names;
  for (const v1::SimJob& job : response.jobs()) names.push_back(job.name());
  return names;
}

grpc::Status ServiceTest::cancel(const std::string& name) {
  v1::CancelSimJobRequest request;
  request.set_name(name);
  grpc::ClientContext context;
  v1::SimJob job;
  return jobs_->CancelSimJob(&context, request, &job);
}

grpc::Status ServiceTest::remove(const std::string& name) {
  v1::DeleteSimJobRequest request;
  request.set_name(name);
  grpc::ClientContext context;
  google::protobuf::Empty nothing;
  return jobs_->DeleteSimJob(&context, request, &nothing);
}

std::vector<v1::SimJob> ServiceTest::watch(const std::string& name, grpc::Status* status) {
  v1::WatchSimJobRequest request;
  request.set_name(name);
  grpc::ClientContext context;
  const auto reader = jobs_->WatchSimJob(&context, request);
  std::vector<v1::SimJob> snapshots;
  for (v1::SimJob job; reader->Read(&job);) snapshots.push_back(job);
  const grpc::Status finished = reader->Finish();
  if (status != nullptr) {
    *status = finished;
  } else {
    EXPECT_TRUE(finished.ok()) << finished.error_message();
    EXPECT_FALSE(snapshots.empty());
  }
  return snapshots;
}

v1::SimJob ServiceTest::wait_for_frames(const std::string& name, std::uint32_t frames) {
  v1::WatchSimJobRequest request;
  request.set_name(name);
  grpc::ClientContext context;
  const auto reader = jobs_->WatchSimJob(&context, request);
  v1::SimJob job;
  while (reader->Read(&job) && (job.state() == v1::SimJob::QUEUED || job.progress().frames() < frames)) {
    if (job.state() != v1::SimJob::QUEUED && job.state() != v1::SimJob::RUNNING) break;
  }
  context.TryCancel();
  EXPECT_GE(job.progress().frames(), frames) << job.DebugString();
  EXPECT_EQ(job.progress().has_eta_s(), job.progress().t() > 0.0) << job.DebugString();
  return job;
}

v1::SimJob ServiceTest::wait_for_runs(const std::string& name, std::size_t runs) {
  v1::SimJob job = get(name);
  while (job.state() < v1::SimJob::SUCCEEDED && runs_of(name).size() < runs) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    job = get(name);
  }
  EXPECT_GE(runs_of(name).size(), runs) << job.DebugString();
  return job;
}

Received ServiceTest::stream(const v1::StreamFramesRequest& request) {
  grpc::ClientContext context;
  const auto reader = frames_->StreamFrames(&context, request);
  Received received;
  std::string header;
  ReceivedFrame frame;
  for (v1::StreamFramesResponse message; reader->Read(&message);) {
    received.largest_message = std::max(received.largest_message, message.ByteSizeLong());
    EXPECT_FALSE(received.end) << "nothing follows the end";
    if (message.has_end()) received.end = message.end();
    if (message.has_header() && append_header(message.header(), header)) {
      EXPECT_TRUE(received.frames.empty());
      EXPECT_TRUE(received.header.emplace().ParseFromString(header));
    }
    if (message.has_frame() && append_frame(message.frame(), frame)) {
      EXPECT_TRUE(received.header) << "the header comes first";
      EXPECT_TRUE(received.frames.emplace(message.frame().index(), std::move(frame)).second);
      frame = {};
    }
  }
  EXPECT_TRUE(frame.q.empty() || !received.end) << "an end after a partial frame";
  received.status = reader->Finish();
  return received;
}

Received ServiceTest::stream_all(const std::string& name) {
  Received received = stream(frames_request(name));
  EXPECT_TRUE(received.status.ok()) << received.status.error_message();
  EXPECT_TRUE(received.end);
  return received;
}

std::map<std::string, std::string> ServiceTest::runs_of(const std::string& name) const {
  std::map<std::string, std::string> runs;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder_of(name).study() / "runs", none))
    if (entry.path().extension() == ".json") runs[entry.path().filename()] = read_bytes(entry.path());
  return runs;
}

std::vector<std::string> ServiceTest::artefacts_of(const std::string& name) {
  v1::ListArtefactsRequest request;
  request.set_name(name);
  grpc::ClientContext context;
  v1::ListArtefactsResponse response;
  EXPECT_TRUE(jobs_->ListArtefacts(&context, request, &response).ok());
  std::vector<std::string> files;
  for (const v1::Artefact& artefact : response.artefacts()) {
    EXPECT_TRUE(artefact.name().starts_with(name + "/artefacts/")) << artefact.name();
    files.push_back(artefact.name().substr(artefact.name().rfind('/') + 1));
  }
  return files;
}

std::string ServiceTest::read_artefact(const std::string& name, const std::string& file) {
  v1::GetArtefactRequest request;
  request.set_name(name + "/artefacts/" + file);
  grpc::ClientContext context;
  const auto reader = jobs_->GetArtefact(&context, request);
  std::string data;
  for (v1::ArtefactChunk chunk; reader->Read(&chunk);) data += chunk.data();
  EXPECT_TRUE(reader->Finish().ok()) << file;
  return data;
}

RunDir ServiceTest::folder_of(const std::string& name) const {
  return {folder_ / "data" / "jobs" / name.substr(name.find('/') + 1)};
}

WorkerInfo ServiceTest::worker_of(const std::string& name) const {
  const Result<WorkerInfo> worker = read_worker(folder_of(name));
  EXPECT_TRUE(worker) << worker.error;
  return worker ? *worker : WorkerInfo{};
}

v1::StreamFramesRequest frames_request(const std::string& name, std::uint32_t first, std::uint32_t stride) {
  v1::StreamFramesRequest request;
  request.set_name(name);
  request.set_first_index(first);
  request.set_stride(stride);
  return request;
}

}  // namespace slipstitch::test
