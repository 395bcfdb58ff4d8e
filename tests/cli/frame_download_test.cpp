// SPDX-License-Identifier: MIT
#include "cli/remote/frame_download.h"

#include <grpcpp/server.h>
#include <grpcpp/server_builder.h>
#include <gtest/gtest.h>

#include <mutex>

#include "cli/frame_messages.h"
#include "google/rpc/error_details.pb.h"
#include "google/rpc/status.pb.h"

namespace slipstitch::test {
namespace {

// Each call sends frames [first_index, stop of the call) and ends with the call's status; the last one sends the end.
struct Call {
  std::uint32_t stop = 0;
  grpc::Status status;
  bool end = false;
};

class FrameServer final : public v1::Frames::Service {
 public:
  explicit FrameServer(std::vector<Call> calls) : calls_(std::move(calls)) {
    grpc::ServerBuilder builder;
    builder.AddListeningPort("127.0.0.1:0", grpc::InsecureServerCredentials(), &port_);
    builder.RegisterService(this);
    server_ = builder.BuildAndStart();
  }
  ~FrameServer() override { server_->Shutdown(); }

  std::string address() const { return "127.0.0.1:" + std::to_string(port_); }
  std::vector<std::uint32_t> first_indices() const { return first_indices_; }

  grpc::Status StreamFrames(grpc::ServerContext*, const v1::StreamFramesRequest* request,
                            grpc::ServerWriter<v1::StreamFramesResponse>* writer) override {
    const std::lock_guard lock(mutex_);
    const Call call = calls_[std::min(first_indices_.size(), calls_.size() - 1)];
    first_indices_.push_back(request->first_index());
    const FrameHeader header = sample_header();
    for (const auto& message : header_messages(header)) writer->Write(message);
    std::uint32_t sent = 0;
    for (std::uint32_t index = request->first_index(); index < call.stop; index += request->stride(), ++sent) {
      for (const auto& message : frame_messages(sample_frame(header, static_cast<int>(index)))) writer->Write(message);
    }
    if (call.end) writer->Write(end_message(sent));
    return call.status;
  }

 private:
  std::mutex mutex_;
  const std::vector<Call> calls_;
  std::vector<std::uint32_t> first_indices_;
  int port_ = 0;
  std::unique_ptr<grpc::Server> server_;
};

struct Fetched {
  FrameDownload result;
  std::vector<int> indices;
  int headers = 0, breaks = 0;
};

Fetched fetch(
    const FrameServer& server, std::uint32_t first, std::uint32_t stride,
    const StopTest& should_stop = [] { return false; }) {
  Fetched fetched;
  FrameSink sink;
  sink.header = [&](const FrameHeader&) {
    ++fetched.headers;
    return std::string();
  };
  sink.frame = [&](const Frame& frame) {
    EXPECT_EQ(frame.q, sample_frame(sample_header(), frame.index).q);
    fetched.indices.push_back(frame.index);
    return std::string();
  };
  sink.broken = [&](const RemoteError&) { ++fetched.breaks; };
  const Connection connection(server.address());
  fetched.result = download_frames(connection, {"simJobs/x", first, stride, {}, true}, should_stop, sink);
  return fetched;
}

const grpc::Status kGone(grpc::StatusCode::UNAVAILABLE, "gone");

TEST(FrameDownload, GoesOnWhereTheStreamBroke) {
  const FrameServer server(
      {{3, kGone, false}, {3, kGone, false}, {8, grpc::Status::OK, false}, {10, grpc::Status::OK, true}});
  const Fetched fetched = fetch(server, 1, 2);
  ASSERT_TRUE(fetched.result.end.has_value());
  EXPECT_EQ(fetched.indices, (std::vector<int>{1, 3, 5, 7, 9}));
  EXPECT_EQ(fetched.headers, 1);
  EXPECT_EQ(fetched.breaks, 3);
  EXPECT_EQ(server.first_indices(), (std::vector<std::uint32_t>{1, 3, 3, 9}));
}

TEST(FrameDownload, GoesOnAfterAStallButNotAfterAnyOtherAbort) {
  google::rpc::ErrorInfo info;
  info.set_reason("STREAM_STALLED");
  google::rpc::Status details;
  details.add_details()->PackFrom(info);
  const grpc::Status stalled(grpc::StatusCode::ABORTED, "stalled", details.SerializeAsString());
  const FrameServer server({{3, stalled, false}, {6, grpc::Status::OK, true}});
  const Fetched fetched = fetch(server, 0, 1);
  EXPECT_TRUE(fetched.result.end.has_value());
  EXPECT_EQ(fetched.indices, (std::vector<int>{0, 1, 2, 3, 4, 5}));
  const FrameServer other({{3, {grpc::StatusCode::ABORTED, "aborted"}, false}, {6, grpc::Status::OK, true}});
  EXPECT_TRUE(fetch(other, 0, 1).result.error.has_value());
}

TEST(FrameDownload, AStreamThatNeverShowsItsEndIsAnError) {
  const FrameServer server({{3, grpc::Status::OK, false}});
  const Fetched fetched = fetch(server, 0, 1);
  EXPECT_FALSE(fetched.result.end.has_value());
  ASSERT_TRUE(fetched.result.error.has_value());
  EXPECT_NE(fetched.result.error->message.find("end marker"), std::string::npos);
  EXPECT_EQ(fetched.indices, (std::vector<int>{0, 1, 2}));
}

TEST(FrameDownload, ErrorsThatStayAreNotTriedAgain) {
  const FrameServer server({{3, {grpc::StatusCode::DATA_LOSS, "damaged"}, false}});
  const Fetched fetched = fetch(server, 0, 1);
  ASSERT_TRUE(fetched.result.error.has_value());
  EXPECT_EQ(fetched.result.error->code, grpc::StatusCode::DATA_LOSS);
  EXPECT_EQ(fetched.breaks, 0);
  EXPECT_EQ(server.first_indices().size(), 1U);
}

TEST(FrameDownload, CanBeStopped) {
  const FrameServer server({{3, kGone, false}});
  const Fetched fetched = fetch(server, 0, 1, [] { return true; });
  EXPECT_FALSE(fetched.result.end || fetched.result.error || !fetched.result.sink_error.empty());
}

}  // namespace
}  // namespace slipstitch::test
