// SPDX-License-Identifier: MIT
#pragma once

#include <grpcpp/client_context.h>
#include <grpcpp/completion_queue.h>
#include <grpcpp/support/async_stream.h>

#include <chrono>
#include <functional>
#include <memory>

namespace slipstitch {

using StopTest = std::function<bool()>;

inline constexpr std::chrono::milliseconds kStopTestInterval{50};

/// Reads a server's stream to its end on the calling thread, which asks `should_stop` meanwhile; gRPC's blocking
/// streams would hold it. `on_message` returns false to hang up.
/// `open(context, queue)` starts the stream, e.g. stub.AsyncWatchSimJob(&context, request, &queue, nullptr).
template <class Message, class Open>
grpc::Status read_stream(const Open& open, const StopTest& should_stop,
                         const std::function<bool(const Message&)>& on_message) {
  grpc::ClientContext context;
  grpc::CompletionQueue queue;
  bool hung_up = false;
  const auto succeeded = [&] {  // waits for the one operation that is under way
    for (;;) {
      void* tag = nullptr;
      bool ok = false;
      const auto deadline = std::chrono::system_clock::now() + kStopTestInterval;
      if (queue.AsyncNext(&tag, &ok, deadline) == grpc::CompletionQueue::GOT_EVENT) return ok;
      if (!hung_up && should_stop()) {
        hung_up = true;
        context.TryCancel();
      }
    }
  };
  const std::unique_ptr<grpc::ClientAsyncReader<Message>> reader = open(context, queue);
  Message message;
  if (succeeded()) {
    for (reader->Read(&message, nullptr); succeeded(); reader->Read(&message, nullptr)) {
      if (hung_up || (!should_stop() && on_message(message))) continue;
      hung_up = true;
      context.TryCancel();
    }
  }
  grpc::Status status;
  reader->Finish(&status, nullptr);
  succeeded();
  queue.Shutdown();
  bool ignored = false;
  for (void* tag = nullptr; queue.Next(&tag, &ignored);) continue;
  return status;
}

}  // namespace slipstitch
