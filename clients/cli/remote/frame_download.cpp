// SPDX-License-Identifier: MIT
#include "cli/remote/frame_download.h"

#include "cli/remote/frame_assembler.h"
#include "cli/remote/retry.h"

namespace slipstitch {
namespace {

v1::StreamFramesRequest request_from(const FrameQuery& query, std::uint32_t first) {
  v1::StreamFramesRequest request;
  request.set_name(query.name);
  request.set_first_index(first);
  request.set_stride(query.stride);
  request.set_follow(query.follow);
  if (query.end) request.set_end_index(std::max(*query.end, first));
  return request;
}

RemoteError broken_stream(const std::string& message) { return {grpc::StatusCode::DATA_LOSS, "", message, {}, {}, {}}; }

// One stream from `first`; what it got to is in the assembler.
class Attempt {
 public:
  Attempt(const FrameQuery& query, std::uint32_t first, bool header_known, const FrameSink& sink)
      : request_(request_from(query, first)),
        sink_(sink),
        header_known_(header_known),
        assembler_(first, query.stride) {}

  grpc::Status run(const Connection& connection, const StopTest& should_stop) {
    return read_stream<v1::StreamFramesResponse>(
        [&](grpc::ClientContext& context, grpc::CompletionQueue& queue) {
          return connection.frames().AsyncStreamFrames(&context, request_, &queue, nullptr);
        },
        should_stop, [this](const v1::StreamFramesResponse& message) { return take(message); });
  }

  const FrameAssembler& assembler() const { return assembler_; }
  bool header_known() const { return header_known_; }
  const std::string& flaw() const { return flaw_; }  // of the stream
  const std::string& sink_error() const { return sink_error_; }

 private:
  bool take(const v1::StreamFramesResponse& message) {
    flaw_ = assembler_.add(message);
    if (!flaw_.empty()) return false;
    if (!header_known_ && assembler_.header()) {
      header_known_ = true;
      sink_error_ = sink_.header(*assembler_.header());
    }
    if (sink_error_.empty() && assembler_.frame()) sink_error_ = sink_.frame(*assembler_.frame());
    return sink_error_.empty();
  }

  const v1::StreamFramesRequest request_;
  const FrameSink& sink_;
  bool header_known_;
  FrameAssembler assembler_;
  std::string flaw_, sink_error_;
};

}  // namespace

FrameDownload download_frames(const Connection& connection, const FrameQuery& query, const StopTest& should_stop,
                              const FrameSink& sink) {
  RetryPause pause;
  std::uint32_t next = query.first;
  for (bool header_known = false;;) {
    Attempt attempt(query, next, header_known, sink);
    const grpc::Status status = attempt.run(connection, should_stop);
    if (!attempt.sink_error().empty()) return {{}, {}, attempt.sink_error()};
    if (!attempt.flaw().empty()) return {{}, broken_stream(attempt.flaw()), {}};
    if (status.ok() && attempt.assembler().end()) return {attempt.assembler().end(), {}, {}};
    if (should_stop()) return {};
    const bool progressed = attempt.assembler().next_index() != next || attempt.header_known() != header_known;
    header_known = attempt.header_known();
    next = attempt.assembler().next_index();
    if (progressed) pause.progress();
    RemoteError error =
        status.ok() ? broken_stream("the stream broke off without its end marker") : remote_error(status);
    const bool connected = header_known || !error.reason.empty();
    const bool retry = connected && (status.ok() || worth_a_retry(error));
    if (!retry) return {{}, error, {}};
    sink.broken(error);
    if (!pause.wait(should_stop)) return should_stop() ? FrameDownload() : FrameDownload{{}, error, {}};
  }
}

}  // namespace slipstitch
