// SPDX-License-Identifier: MIT
#include "cli/remote/watch_job.h"

#include "cli/remote/retry.h"

namespace slipstitch {

Reply<v1::SimJob> watch_job(const Connection& connection, const std::string& name, const StopTest& should_stop,
                            const std::function<void(const v1::SimJob&)>& on_job,
                            const std::function<void(const RemoteError&)>& on_break) {
  v1::WatchSimJobRequest request;
  request.set_name(name);
  std::optional<v1::SimJob> last;
  RetryPause pause;
  for (;;) {
    const grpc::Status status = read_stream<v1::SimJob>(
        [&](grpc::ClientContext& context, grpc::CompletionQueue& queue) {
          return connection.jobs().AsyncWatchSimJob(&context, request, &queue, nullptr);
        },
        should_stop,
        [&](const v1::SimJob& job) {
          pause.progress();
          last = job;
          on_job(job);
          return true;
        });
    if (last && has_ended(last->state())) return {std::move(last), {}};
    if (should_stop()) return {};
    RemoteError error = remote_error(status);
    if (status.ok()) error = {grpc::StatusCode::UNAVAILABLE, "", "the stream ended before the job", {}, {}, {}};
    if (!last || !worth_a_retry(error)) return {std::nullopt, error};
    on_break(error);
    if (!pause.wait(should_stop)) return should_stop() ? Reply<v1::SimJob>() : Reply<v1::SimJob>{std::nullopt, error};
  }
}

}  // namespace slipstitch
