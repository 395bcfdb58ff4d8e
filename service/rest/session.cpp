// SPDX-License-Identifier: MIT
#include "rest/session.h"

#include <algorithm>
#include <boost/asio/post.hpp>
#include <boost/beast/http/read.hpp>

namespace slipstitch::rest {
namespace asio = boost::asio;
namespace http = boost::beast::http;
using std::chrono::milliseconds;

namespace {

constexpr std::size_t kBufferBytes = 64 * 1024;  // read ahead
constexpr std::uint64_t kSmallBody = 64 * 1024;  // any number of these at a time
constexpr int kMostUploads = 8;                  // of larger ones
constexpr milliseconds kLinger{2'000};           // for a client to see the answer before the connection goes

}  // namespace

Session::Session(asio::ip::tcp::socket socket, std::shared_ptr<Shared> shared)
    : shared_(std::move(shared)), socket_(std::move(socket)), timer_(shared_->io), buffer_(kBufferBytes) {}

void Session::start() {
  shared_->service.metrics.change_connections(1);
  ErrorCode ignored;
  socket_.set_option(asio::ip::tcp::no_delay(true), ignored);
  read_head();
}

void Session::refuse() {
  refused_ = true;
  ++shared_->refused;
  respond_and_close(too_many_connections(shared_->options.max_connections));
}

void Session::stop() {
  keep_alive_ = false;
  if (reading_head_ && buffer_.size() == 0 && !parser_->got_some()) close();
}

void Session::close() {
  if (std::exchange(closed_, true)) return;
  disarm();
  release_upload();
  leave_exports();
  if (std::exchange(streaming_, false)) shared_->service.metrics.change_streams(-1);
  if (refused_) {
    --shared_->refused;
  } else {
    shared_->service.metrics.change_connections(-1);
  }
  ErrorCode ignored;
  socket_.close(ignored);
  // Locks the store, for which this thread does not wait.
  asio::post(shared_->feeds, [self = shared_from_this()] {
    if (self->watch_ != 0) self->shared_->service.store.unwatch(std::exchange(self->watch_, 0));
  });
  shared_->sessions.erase(shared_from_this());
}

// --- A request ------------------------------------------------------------------------------------------------------

void Session::read_head() {
  if (closed_ || shared_->stopping) return close();
  route_.reset();
  parser_.emplace();
  limit(*parser_, static_cast<std::uint64_t>(shared_->options.max_scene_mib) << 20);
  reading_head_ = true;
  arm(shared_->options.request_timeout, [this] {
    timed_out_ = true;
    ErrorCode ignored;
    socket_.cancel(ignored);
  });
  take_head_bytes();
}

void Session::take_head_bytes() {
  if (buffer_.size() == 0) return read_head_bytes();
  ErrorCode error;
  buffer_.consume(put_head(*parser_, {static_cast<const char*>(buffer_.data().data()), buffer_.size()}, error));
  if (error == http::error::need_more) return read_head_bytes();
  reading_head_ = false;
  error ? on_read_error(error) : on_head();
}

void Session::read_head_bytes() {
  socket_.async_read_some(buffer_.prepare(std::min(kMaxHeaderBytes, buffer_.max_size() - buffer_.size())),
                          [self = shared_from_this()](const ErrorCode& error, std::size_t size) {
                            if (self->closed_) return;
                            if (!error) {
                              self->buffer_.commit(size);
                              return self->take_head_bytes();
                            }
                            self->reading_head_ = false;
                            self->on_read_error(error);
                          });
}

void Session::on_head() {
  disarm();
  http_1_0_ = parser_->get().version() < 11;
  keep_alive_ = parser_->keep_alive() && !shared_->stopping;
  ErrorCode ignored;
  const std::string local = socket_.local_endpoint(ignored).address().to_string();
  std::variant<Route, HttpError> routed = route(head_of(*parser_), {shared_->bound_host, local});
  if (const auto* refused = std::get_if<HttpError>(&routed)) {
    if (!parser_->is_done()) return respond_and_close(*refused);
    return respond(error_response(*refused));
  }
  take(std::get<Route>(std::move(routed)));
}

void Session::take(Route route) {
  route_ = std::move(route);
  if (parser_->is_done()) return run();
  if (!reserve_upload()) return respond_and_close(too_many_uploads(kMostUploads));
  const bool waits = parser_->get()[http::field::expect] == "100-continue";
  if (!waits) return read_body();
  write("HTTP/1.1 100 Continue\r\n\r\n", [self = shared_from_this()] { self->read_body(); });
}

void Session::read_body() {
  arm(shared_->options.request_timeout, [this] {
    timed_out_ = true;
    ErrorCode ignored;
    socket_.cancel(ignored);
  });
  http::async_read(socket_, buffer_, *parser_, [self = shared_from_this()](const ErrorCode& error, std::size_t) {
    if (self->closed_) return;
    if (error) return self->on_read_error(error);
    self->disarm();
    self->run();
  });
}

void Session::on_read_error(const ErrorCode& error) {
  disarm();
  const bool idle = requests_ > 0 && !parser_->got_some() && buffer_.size() == 0;
  if (timed_out_ && !idle) {
    const auto seconds = std::chrono::duration<double>(shared_->options.request_timeout).count();
    return respond_and_close(request_timeout(seconds));
  }
  const auto answer = timed_out_ ? std::nullopt : read_error(*parser_, error, shared_->options.max_scene_mib);
  return answer ? respond_and_close(*answer) : close();
}

void Session::run() {
  if (route_->operation == Operation::get_frame) return await_export();
  asio::thread_pool& lane = route_->operation == Operation::create_job ? shared_->work : shared_->lookups;
  asio::post(lane, [self = shared_from_this(), body = std::move(parser_->get().body())] {
    Response response = handle(*self->route_, body, self->shared_->service);
    if (!self->predict(response)) self->respond_later(std::move(response));
  });
}

// Whether it answers, later.
bool Session::predict(Response response) {
  if (!response.prediction) return false;
  const auto answer = [self = shared_from_this(), response](const v1::Prediction* prediction) mutable {
    if (prediction != nullptr) response.body = response.prediction->body(*prediction);
    self->respond_later(std::move(response));
  };
  const auto wanted = [self = shared_from_this()] { return !self->gone_; };
  gone_ = false;
  asio::post(shared_->io, [self = shared_from_this()] { self->watch_for_end(); });
  return shared_->predictor.post(response.prediction->scene, wanted, answer);
}

// Something to read that has no bytes is the end. A wait that outlasts the answer sees the next request.
void Session::watch_for_end() {
  if (closed_) return;
  predicting_ = true;
  socket_.async_wait(asio::ip::tcp::socket::wait_read, [self = shared_from_this()](const ErrorCode& error) {
    if (!self->predicting_) return;
    ErrorCode unknown;
    if (error || (self->socket_.available(unknown) == 0 && !self->closed_)) self->gone_ = true;
  });
}

void Session::respond_later(Response response) {
  asio::post(shared_->io, [self = shared_from_this(), response = std::move(response)]() mutable {
    if (!self->closed_) self->respond(std::move(response));
  });
}

// --- Its answer -----------------------------------------------------------------------------------------------------

void Session::respond(Response response) {
  predicting_ = false;
  release_upload();
  count(response.status);
  const bool head_only = parser_ && parser_->get().method() == http::verb::head;
  response_ = std::move(response);
  const bool in_pieces = response_.source != nullptr;
  if (in_pieces && !response_.length) keep_alive_ = false;
  const std::uint64_t size = response_.body.size();
  const auto length = in_pieces ? response_.length : std::optional<std::uint64_t>(size);
  std::string text = head_text(response_, length, http_1_0_, keep_alive_);
  if (!head_only) text += std::exchange(response_.body, {});
  const bool feeds = in_pieces && !head_only;
  write(std::move(text),
        [self = shared_from_this(), feeds] { feeds ? self->start_stream() : self->finish_response(); });
}

void Session::respond_and_close(const HttpError& error) {
  keep_alive_ = false;
  respond(error_response(error));
}

void Session::finish_response() {
  response_ = {};
  leave_exports();
  if (!keep_alive_) return linger();
  ++requests_;
  read_head();
}

// A connection that is closed with input unread is reset, and the client may never see the answer.
void Session::linger() {
  ErrorCode ignored;
  socket_.shutdown(asio::ip::tcp::socket::shutdown_send, ignored);
  arm(kLinger, [this] { close(); });
  drain();
}

void Session::drain() {
  socket_.async_read_some(asio::buffer(sink_), [self = shared_from_this()](const ErrorCode& error, std::size_t) {
    error || self->closed_ ? self->close() : self->drain();
  });
}

// --- A body in pieces -----------------------------------------------------------------------------------------------

void Session::start_stream() {
  streaming_ = true;
  shared_->service.metrics.change_streams(1);
  busy_ = true;
  then_ = response_.first.then;
  if (!response_.length) watch_client();
  if (response_.source->job().empty()) return on_piece(std::move(response_.first));
  watch_job();
}

// Whatever changed before the watch began is found by asking once more after the first piece.
void Session::watch_job() {
  asio::post(shared_->feeds, [self = shared_from_this()] {
    const auto changed = [weak = self->weak_from_this(), &io = self->shared_->io] {
      if (const auto session = weak.lock()) asio::post(io, [session] { session->wake(); });
    };
    self->watch_ = self->shared_->service.store.watch(self->response_.source->job(), changed);
    asio::post(self->shared_->io, [self] {
      if (self->response_.first.then == Piece::Then::wait) self->response_.first.then = Piece::Then::more;
      self->on_piece(std::move(self->response_.first));
    });
  });
}

// Nothing is expected of the client any more but that it goes.
void Session::watch_client() {
  socket_.async_read_some(asio::buffer(sink_), [self = shared_from_this()](const ErrorCode& error, std::size_t) {
    if (!self->streaming_) return;
    error ? self->close() : self->watch_client();
  });
}

void Session::feed() {
  busy_ = true;
  woken_ = false;
  asio::post(shared_->feeds, [self = shared_from_this()] {
    Piece piece = self->response_.source->next();
    asio::post(self->shared_->io, [self, piece = std::move(piece)]() mutable { self->on_piece(std::move(piece)); });
  });
}

void Session::on_piece(Piece piece) {
  if (closed_) return;
  if (piece.then == Piece::Then::broken) return close();
  then_ = piece.then;
  if (piece.bytes.empty()) return after_piece();
  const bool plain = response_.length.has_value() || http_1_0_;
  write(plain ? std::move(piece.bytes) : chunk_text(piece.bytes), [self = shared_from_this()] { self->after_piece(); });
}

void Session::after_piece() {
  if (closed_) return;
  busy_ = false;
  if (then_ == Piece::Then::end) return end_stream();
  if (then_ == Piece::Then::more || woken_) return feed();
  arm(shared_->options.keep_alive, [this] { keep_alive(); });
}

void Session::wake() {
  woken_ = true;
  if (!busy_ && streaming_ && !closed_) feed();
}

void Session::keep_alive() {
  busy_ = true;
  on_piece({response_.source->keep_alive(), Piece::Then::wait});
}

void Session::end_stream() {
  if (std::exchange(streaming_, false)) shared_->service.metrics.change_streams(-1);
  if (response_.length || http_1_0_) return finish_response();
  write(chunk_text({}), [self = shared_from_this()] { self->finish_response(); });
}

// --- Parts ----------------------------------------------------------------------------------------------------------

void Session::write(std::string text, Handler then) {
  out_ = std::move(text);
  sent_ = 0;
  write_more(std::move(then));
}

// A client that takes little is waited for, one that takes nothing is not.
void Session::write_more(Handler then) {
  if (sent_ == out_.size()) {
    disarm();
    std::string().swap(out_);  // an assignment would keep its memory
    sent_ = 0;
    return then();
  }
  arm(shared_->options.stall_timeout, [this] { close(); });
  socket_.async_write_some(
      asio::buffer(out_.data() + sent_, out_.size() - sent_),
      [self = shared_from_this(), then = std::move(then)](const ErrorCode& error, std::size_t size) mutable {
        if (self->closed_) return;
        if (error) return self->close();
        self->sent_ += size;
        self->write_more(std::move(then));
      });
}

void Session::arm(milliseconds delay, Handler expired) {
  timed_out_ = false;
  timer_.expires_after(delay);
  timer_.async_wait(
      [self = shared_from_this(), armed = ++arming_, expired = std::move(expired)](const ErrorCode& error) {
        if (!error && armed == self->arming_ && !self->closed_) expired();
      });
}

void Session::disarm() {
  ++arming_;
  timer_.cancel();
}

bool Session::reserve_upload() {
  const auto length = parser_->content_length();
  if (length && *length <= kSmallBody) return true;
  if (shared_->uploads == kMostUploads) return false;
  ++shared_->uploads;
  uploading_ = true;
  return true;
}

void Session::release_upload() {
  if (std::exchange(uploading_, false)) --shared_->uploads;
}

void Session::count(unsigned status) {
  std::string name = "none";
  if (route_) name = "viewer";
  for (const OperationInfo& info : operations()) {
    if (route_ && info.operation == route_->operation) name = info.id;
  }
  shared_->service.metrics.count_response(name, status);
}

}  // namespace slipstitch::rest
