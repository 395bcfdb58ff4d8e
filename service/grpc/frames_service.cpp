// SPDX-License-Identifier: MIT
#include "grpc/frames_service.h"

#include "api/frame_source.h"
#include "api/job_message.h"

namespace slipstitch {
namespace {

class FramesReactor final : public StreamReactor<v1::StreamFramesResponse> {
 public:
  FramesReactor(jobs::JobStore& store, const v1::StreamFramesRequest& request, StreamOptions options)
      : StreamReactor(store, id_from_name(request.name()), options), request_(request) {}

 private:
  using End = jobs::Outcome<jobs::Done>;

  Step<v1::StreamFramesResponse> next() override {
    if (!source_) {
      if (End opened = open(); !opened) return opened;
    }
    if (source_->finished()) return End(jobs::Done{});
    const jobs::Outcome<jobs::Job> now = store().get(job());
    if (!now) return End(now.error());
    if (auto message = source_->next(now->state)) return std::move(*message);
    if (source_->damage().empty()) return NothingYet{};
    return End(jobs::Error{jobs::ErrorCode::data_loss, "STORAGE_FAILED", source_->damage(), {}, {}, {}});
  }

  End open() {
    if (auto wrong = check_range(request_)) return std::move(*wrong);
    const jobs::Outcome<jobs::Job> now = store().get(job());
    if (!now) return now.error();
    if (auto none = check_has_frames(*now)) return std::move(*none);
    const jobs::Outcome<RunDir> dir = store().folder(job());
    if (!dir) return dir.error();
    source_.emplace(*dir, request_);
    return jobs::Done{};
  }

  const v1::StreamFramesRequest request_;
  std::optional<FrameSource> source_;
};

}  // namespace

grpc::ServerWriteReactor<v1::StreamFramesResponse>* FramesService::StreamFrames(
    grpc::CallbackServerContext*, const v1::StreamFramesRequest* request) {
  const auto reactor = std::make_shared<FramesReactor>(store_, *request, streams_);
  reactor->start();
  return reactor.get();
}

}  // namespace slipstitch
