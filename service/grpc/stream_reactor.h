// SPDX-License-Identifier: MIT
#pragma once

#include <grpcpp/alarm.h>
#include <grpcpp/support/server_callback.h>

#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <variant>

#include "grpc/status.h"
#include "jobs/job_store.h"

namespace slipstitch {

struct StreamOptions {
  std::chrono::milliseconds stall_timeout{30'000};  // a client that takes no message for so long loses its stream
};

/// Nothing to send now; the job's next change wakes the stream.
struct NothingYet {};

/// What to do next: send, end, or wait.
template <class Message>
using Step = std::variant<Message, jobs::Outcome<jobs::Done>, NothingYet>;

/// Sends what `next()` makes of a job, one message at a time: the next one is made when the client has taken the last,
/// so a slow client costs one message. Ends with UNAVAILABLE when the server stops. Owns itself until gRPC is done.
template <class Message>
class StreamReactor : public grpc::ServerWriteReactor<Message>,
                      public std::enable_shared_from_this<StreamReactor<Message>> {
 public:
  StreamReactor(jobs::JobStore& store, std::string job, StreamOptions options)
      : store_(store), job_(std::move(job)), options_(options) {}

  void start() {
    self_ = this->shared_from_this();
    watch_ = store_.watch(job_, [weak = this->weak_from_this()] {
      if (const auto stream = weak.lock()) stream->wake();
    });
    {
      const std::lock_guard lock(mutex_);
      set_stall_alarm();
    }
    wake();
  }

 protected:
  /// Called by one thread at a time.
  virtual Step<Message> next() = 0;

  jobs::JobStore& store() { return store_; }
  const std::string& job() const { return job_; }

 private:
  using Clock = std::chrono::steady_clock;

  void wake() {
    {
      const std::lock_guard lock(mutex_);
      look_again_ = true;
      if (busy_) return;
      busy_ = true;
    }
    advance();
  }

  // Whoever set busy_ runs this; it stays set while a message is on its way and for ever after the end.
  void advance() {
    for (;;) {
      {
        const std::lock_guard lock(mutex_);
        look_again_ = false;
        if (ended_) return;
      }
      if (store_.stopping()) return end(grpc_status(jobs::server_stopping()));
      Step<Message> step = next();
      if (auto* message = std::get_if<Message>(&step)) return send(std::move(*message));
      if (auto* outcome = std::get_if<jobs::Outcome<jobs::Done>>(&step)) {
        return end(*outcome ? grpc::Status::OK : grpc_status(outcome->error()));
      }
      const std::lock_guard lock(mutex_);
      if (look_again_) continue;
      busy_ = false;
      return;
    }
  }

  // StartWrite and Finish under the lock, so that no write follows the end; gRPC answers on another stack. The
  // reference keeps the lock alive should OnDone come meanwhile.
  void send(Message message) {
    const auto keep = this->shared_from_this();
    const std::lock_guard lock(mutex_);
    if (ended_) return;
    message_ = std::move(message);
    sent_at_ = Clock::now();
    this->StartWrite(&message_);
  }

  void end(const grpc::Status& status) {
    const auto keep = this->shared_from_this();
    const std::lock_guard lock(mutex_);
    if (std::exchange(ended_, true)) return;
    busy_ = true;
    this->Finish(status);
  }

  void OnWriteDone(bool ok) override {
    {
      const std::lock_guard lock(mutex_);
      sent_at_.reset();
    }
    if (!ok) return end(grpc::Status::CANCELLED);
    advance();
  }

  void OnCancel() override { end(grpc::Status::CANCELLED); }

  void OnDone() override {
    store_.unwatch(watch_);
    const auto keep = std::move(self_);
    const std::lock_guard lock(mutex_);
    alarm_.Cancel();
  }

  void set_stall_alarm() {
    const auto when = std::chrono::system_clock::now() + options_.stall_timeout / 2;
    alarm_.Set(when, [weak = this->weak_from_this()](bool due) {
      if (const auto stream = weak.lock(); stream && due) stream->check_stall();
    });
  }

  void check_stall() {
    {
      const std::lock_guard lock(mutex_);
      if (ended_) return;
      if (!sent_at_ || Clock::now() - *sent_at_ < options_.stall_timeout) return set_stall_alarm();
    }
    // Reaches the client, in order, should it ever read on.
    end(grpc_status({jobs::ErrorCode::aborted,
                     "STREAM_STALLED",
                     "the client took no message for too long; open the stream again where it ended",
                     {},
                     {},
                     {}}));
  }

  jobs::JobStore& store_;
  const std::string job_;
  const StreamOptions options_;
  Message message_;  // on its way
  jobs::JobStore::WatchId watch_ = 0;
  grpc::Alarm alarm_;
  std::shared_ptr<StreamReactor> self_;

  std::mutex mutex_;  // guards all below
  bool busy_ = false, ended_ = false, look_again_ = false;
  std::optional<Clock::time_point> sent_at_;  // of the message on its way
};

}  // namespace slipstitch
