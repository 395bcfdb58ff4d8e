// SPDX-License-Identifier: MIT
// A frame's file may have hundreds of MB and is held whole until it is sent. So one is made at a time, and none while
// those that are being sent hold max_export_bytes: no more is ever held than that, and one file.
#include <boost/asio/post.hpp>

#include "rest/session.h"

namespace slipstitch::rest {
namespace asio = boost::asio;

void Session::await_export() {
  shared_->waiting.push_back(shared_from_this());
  waiting_ = true;
  arm(shared_->options.request_timeout, [this] {
    leave_exports();
    const auto seconds = std::chrono::duration<double>(shared_->options.request_timeout).count();
    respond(error_response(too_many_exports(shared_->options.max_export_bytes, seconds)));
  });
  begin_next_export(*shared_);
}

void Session::begin_next_export(Shared& shared) {
  if (!shared.exporting && !shared.waiting.empty() && shared.export_bytes < shared.options.max_export_bytes) {
    const std::shared_ptr<Session> next = std::move(shared.waiting.front());
    shared.waiting.pop_front();
    shared.exporting = true;
    next->make_export();
  }
  shared.service.metrics.set_exports(shared.waiting.size(), shared.export_bytes);
}

void Session::make_export() {
  waiting_ = false;
  disarm();
  asio::post(shared_->exports, [self = shared_from_this()] {
    Response response = handle(*self->route_, {}, self->shared_->service);
    asio::post(self->shared_->io,
               [self, response = std::move(response)]() mutable { self->take_export(std::move(response)); });
  });
}

void Session::take_export(Response response) {
  shared_->exporting = false;
  if (!closed_) {
    export_bytes_ = response.body.size();
    shared_->export_bytes += export_bytes_;
    respond(std::move(response));
  }
  begin_next_export(*shared_);
}

void Session::leave_exports() {
  if (!waiting_ && export_bytes_ == 0) return;
  if (std::exchange(waiting_, false)) std::erase(shared_->waiting, shared_from_this());
  shared_->export_bytes -= std::exchange(export_bytes_, 0);
  begin_next_export(*shared_);
}

}  // namespace slipstitch::rest
