// SPDX-License-Identifier: MIT
#include "rest/rest_server.h"

#include <array>
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/post.hpp>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "rest/openapi.h"
#include "rest/session.h"

namespace slipstitch::rest {
namespace asio = boost::asio;
using asio::ip::tcp;
using ErrorCode = boost::system::error_code;

namespace {

constexpr int kMostRefused = 64;                        // connections over the limit whose requests are read at a time
constexpr std::chrono::milliseconds kAcceptAgain{100};  // after the system could not give one
constexpr std::chrono::milliseconds kLookForLast{5};

jobs::Error cannot_listen(const std::string& address, const std::string& why) {
  return {
      jobs::ErrorCode::unavailable, "CANNOT_LISTEN", "cannot listen on " + address + " (--http): " + why, {}, {}, {}};
}

std::string host_part(const std::string& address) { return address.substr(0, address.rfind(':')); }

// Without the brackets of an IPv6 address.
std::string bare_host(const std::string& address) {
  const std::string host = host_part(address);
  return host.starts_with('[') && host.ends_with(']') ? host.substr(1, host.size() - 2) : host;
}

ErrorCode listen(const std::string& address, tcp::acceptor& acceptor) {
  ErrorCode error;
  tcp::resolver resolver(acceptor.get_executor());
  const std::string port = address.substr(address.rfind(':') + 1);
  const auto found = resolver.resolve(bare_host(address), port, tcp::resolver::passive, error);
  if (error) return error;
  const tcp::endpoint endpoint = found.begin()->endpoint();
  acceptor.open(endpoint.protocol(), error);
  if (!error) acceptor.set_option(tcp::acceptor::reuse_address(true), error);
  if (!error) acceptor.bind(endpoint, error);
  if (!error) acceptor.listen(tcp::acceptor::max_listen_connections, error);
  return error;
}

}  // namespace

Shared::Shared(jobs::JobStore& store, Predictor& what_predicts, const RestOptions& rest_options)
    : options(rest_options),
      predictor(what_predicts),
      service{store, rest_options.max_scene_mib, StaticFiles(rest_options.viewer), openapi_document(), {}},
      bound_host(bare_host(rest_options.address)) {}

struct RestServer::State {
  State(jobs::JobStore& store, Predictor& predictor, const RestOptions& options)
      : shared(std::make_shared<Shared>(store, predictor, options)), acceptor(shared->io), retry(shared->io) {}

  void accept() {
    acceptor.async_accept([this](const ErrorCode& error, tcp::socket socket) {
      if (!acceptor.is_open()) return;
      if (error) {  // out of descriptors, say
        retry.expires_after(kAcceptAgain);
        return retry.async_wait([this](const ErrorCode& cancelled) {
          if (!cancelled) accept();
        });
      }
      greet(std::move(socket));
      accept();
    });
  }

  void greet(tcp::socket socket) {
    const bool full =
        shared->sessions.size() >= static_cast<std::size_t>(shared->options.max_connections + shared->refused);
    if (full && shared->refused == kMostRefused) return turn_away(std::move(socket));
    const auto session = std::make_shared<Session>(std::move(socket), shared);
    shared->sessions.insert(session);
    full ? session->refuse() : session->start();
  }

  // Costs no waiting and nothing that stays. What the client sends from now on, the system answers with a reset.
  void turn_away(tcp::socket socket) {
    const Response response = error_response(too_many_connections(shared->options.max_connections));
    const std::string text = head_text(response, response.body.size(), false, false) + response.body;
    std::array<char, kMaxHeaderBytes> unread;
    ErrorCode ignored;
    socket.non_blocking(true, ignored);
    socket.write_some(asio::buffer(text), ignored);
    socket.shutdown(tcp::socket::shutdown_send, ignored);
    socket.read_some(asio::buffer(unread), ignored);  // else closing resets, and the answer may be lost
    shared->service.metrics.count_response("none", response.status);
  }

  std::shared_ptr<Shared> shared;
  tcp::acceptor acceptor;
  asio::steady_timer retry;
  std::string address;
  std::thread thread;
};

RestServer::RestServer(std::unique_ptr<State> state) : state_(std::move(state)) {}

jobs::Outcome<std::unique_ptr<RestServer>> RestServer::start(jobs::JobStore& store, Predictor& predictor,
                                                             const RestOptions& options) {
  auto state = std::make_unique<State>(store, predictor, options);
  if (const ErrorCode error = listen(options.address, state->acceptor)) {
    return cannot_listen(options.address, error.message());
  }
  ErrorCode ignored;
  state->address = host_part(options.address) + ":" + std::to_string(state->acceptor.local_endpoint(ignored).port());
  state->accept();
  state->thread = std::thread([&io = state->shared->io] {
    const auto work = asio::make_work_guard(io);
    io.run();
  });
  return std::unique_ptr<RestServer>(new RestServer(std::move(state)));
}

RestServer::~RestServer() { stop(0.0); }

const std::string& RestServer::address() const { return state_->address; }

void RestServer::stop(double grace_s) {
  if (!state_->thread.joinable()) return;
  State& state = *state_;
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::duration<double>(grace_s);
  asio::post(state.shared->io, [&state] {
    ErrorCode ignored;
    state.acceptor.close(ignored);
    state.retry.cancel();
    state.shared->stopping = true;
    const auto sessions = state.shared->sessions;
    for (const auto& session : sessions) session->stop();
  });
  std::mutex mutex;
  std::condition_variable looked;
  for (bool last = false; !last;) {
    bool done = false, empty = false;
    asio::post(state.shared->io, [&] {
      const std::lock_guard lock(mutex);
      empty = state.shared->sessions.empty();
      done = true;
      looked.notify_one();
    });
    std::unique_lock lock(mutex);
    looked.wait(lock, [&] { return done; });
    last = empty || std::chrono::steady_clock::now() > deadline;
    if (!last) std::this_thread::sleep_for(kLookForLast);
  }
  asio::post(state.shared->io, [&state] {
    state.shared->waiting.clear();
    const auto sessions = state.shared->sessions;
    for (const auto& session : sessions) session->close();
    asio::post(state.shared->io, [&state] { state.shared->io.stop(); });
  });
  state.thread.join();
  state.shared->work.join();
  state.shared->lookups.join();
  state.shared->feeds.join();
  state.shared->exports.join();
  state.shared->io.restart();  // what the pools had still to say finds its connection closed
  state.shared->io.poll();
}

}  // namespace slipstitch::rest
