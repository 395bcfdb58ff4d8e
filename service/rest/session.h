// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/thread_pool.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>  // before asio, which needs it and does not include it

#include "api/predictor.h"
#include "rest/handlers.h"
#include "rest/http_parser.h"
#include "rest/rest_server.h"

namespace slipstitch::rest {

class Session;

/// What all connections share. Everything but the pools is touched by the I/O thread only.
struct Shared {
  Shared(jobs::JobStore& store, Predictor& predictor, const RestOptions& rest_options);

  const RestOptions options;
  Predictor& predictor;
  Service service;
  std::string bound_host;
  std::set<std::shared_ptr<Session>> sessions;
  int refused = 0;                               // connections over the limit that are being told so
  int uploads = 0;                               // large requests that are being read or handled
  std::deque<std::shared_ptr<Session>> waiting;  // for their turn to have a frame's file made
  bool exporting = false;                        // one is being made
  std::size_t export_bytes = 0;                  // of those being sent
  bool stopping = false;
  boost::asio::io_context io{1};
  boost::asio::thread_pool lookups{1}, work{1}, feeds{1}, exports{1};
};

/// One connection: reads a request, answers, reads the next. Lives until close().
class Session : public std::enable_shared_from_this<Session> {
 public:
  Session(boost::asio::ip::tcp::socket socket, std::shared_ptr<Shared> shared);

  void start();
  /// Answers one over the limit with 503, whatever it asks.
  void refuse();
  /// Closes now if no request is on its way, else after it.
  void stop();
  void close();

 private:
  using Handler = std::function<void()>;
  using ErrorCode = boost::system::error_code;

  void read_head();
  void take_head_bytes();
  void read_head_bytes();
  void on_head();
  void take(Route route);
  void read_body();
  void on_read_error(const ErrorCode& error);
  void run();
  void respond(Response response);
  void respond_later(Response response);  // from any thread
  bool predict(Response response);
  void watch_for_end();
  void respond_and_close(const HttpError& error);
  void finish_response();
  void linger();
  void drain();

  void await_export();
  void make_export();
  void take_export(Response response);
  void leave_exports();
  static void begin_next_export(Shared& shared);

  void start_stream();
  void watch_job();
  void watch_client();
  void on_piece(Piece piece);
  void after_piece();
  void feed();
  void wake();
  void keep_alive();
  void end_stream();

  void write(std::string text, Handler then);
  void write_more(Handler then);
  void arm(std::chrono::milliseconds delay, Handler expired);
  void disarm();
  bool reserve_upload();
  void release_upload();
  void count(unsigned status);

  std::shared_ptr<Shared> shared_;
  boost::asio::ip::tcp::socket socket_;
  boost::asio::steady_timer timer_;
  long arming_ = 0;  // which one is in force
  boost::beast::flat_buffer buffer_;
  std::optional<Parser> parser_;
  std::optional<Route> route_;
  std::string out_;                // on its way
  std::size_t sent_ = 0;           // of it [byte]
  std::array<char, 4096> sink_{};  // what nobody wants to know
  int requests_ = 0;
  bool reading_head_ = false, timed_out_ = false, keep_alive_ = false, http_1_0_ = false, uploading_ = false;
  bool refused_ = false, closed_ = false, predicting_ = false;

  std::atomic<bool> gone_ = false;  // the client, while a prediction is made for it

  // Of a frame's file.
  bool waiting_ = false;
  std::size_t export_bytes_ = 0;  // while it is sent

  // Of a body that comes in pieces.
  Response response_;
  jobs::JobStore::WatchId watch_ = 0;
  Piece::Then then_ = Piece::Then::end;
  bool streaming_ = false, busy_ = false, woken_ = false;
};

}  // namespace slipstitch::rest
