// SPDX-License-Identifier: MIT
#include <grpcpp/grpcpp.h>

#include "grpc/grpc_server.h"
#include "run_dir/frame_log.h"
#include "slipstitch/v1/frames.grpc.pb.h"
#include "store_helpers.h"

namespace slipstitch {
namespace {

// A job that ended with 64 frames of 1 MiB: more than gRPC buffers for a client that does not read.
void store_large_job(const std::filesystem::path& path, const std::string& id) {
  const auto data = jobs::DataDir::open(path);
  ASSERT_TRUE(data) << data.error().message;
  ASSERT_EQ(data->create_job(id, {"simJobs/" + id, "", "", 1, "", utc_now(), "large"}, "{}"), "");
  FrameHeader header;
  header.topology.num_nodes = 1 << 17;
  header.num_frames = 64;
  header.topology.num_nodes /= 3;
  header.topology.yarn_first = {0};
  auto log = FrameLogWriter::create(data->job(id).frames());
  ASSERT_TRUE(log) << log.error;
  ASSERT_EQ(log->append_header(header), "");
  for (int i = 0; i < header.num_frames; ++i) {
    ASSERT_EQ(log->append_frame({i, 0.1 * i, VecX::Constant(header.topology.num_coords(), i)}), "");
  }
  RunSummary summary;
  summary.status = RunStatus::succeeded;
  ASSERT_EQ(write_summary(data->job(id), summary), "");
}

TEST(Stall, EndsTheStreamOfAClientThatStopsReading) {
  const std::string id = "01abcdefgh000000";
  const test::TemporaryFolder folder;
  store_large_job(folder.path(), id);
  jobs::HeldWork work;
  auto store = jobs::open_store(folder.path(), work);
  auto server = GrpcServer::start(*store, {"127.0.0.1:0", 16, {std::chrono::milliseconds(100)}});
  ASSERT_TRUE(server) << server.error().message;

  grpc::ChannelArguments arguments;
  arguments.SetInt(GRPC_ARG_HTTP2_BDP_PROBE, 0);  // small windows
  arguments.SetInt(GRPC_ARG_ENABLE_HTTP_PROXY, 0);
  const auto channel = grpc::CreateCustomChannel((*server)->address(), grpc::InsecureChannelCredentials(), arguments);
  const auto stub = v1::Frames::NewStub(channel);
  v1::StreamFramesRequest request;
  request.set_name("simJobs/" + id);
  grpc::ClientContext context;
  const auto reader = stub->StreamFrames(&context, request);
  v1::StreamFramesResponse message;
  ASSERT_TRUE(reader->Read(&message));
  std::this_thread::sleep_for(std::chrono::seconds(1));
  bool ended = false;
  while (reader->Read(&message)) ended = ended || message.has_end();
  EXPECT_FALSE(ended);
  const grpc::Status status = reader->Finish();
  EXPECT_EQ(status.error_code(), grpc::StatusCode::ABORTED) << status.error_message();
}

}  // namespace
}  // namespace slipstitch
