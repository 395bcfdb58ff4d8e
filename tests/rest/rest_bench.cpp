// SPDX-License-Identifier: MIT
// How long a GET takes while 200 clients watch a job, one that does not change and one that runs: rest_bench
// [REQUESTS].
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <iomanip>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "server_process.h"
#include "support/http_client.h"
#include "support/sample_run.h"

namespace {

using namespace slipstitch::test;
using Clock = std::chrono::steady_clock;

constexpr int kWatching = 200;

// Never starts, because the one before it never ends.
constexpr char kEndless[] = R"({"spec":{"scene":{"yarns":[{"points_m":[0,0,0,0.1,0,0]}],
  "effects":{"inertia":{},"gravity":{},"stretch":{}},"handles":[{"where":{"yarn_point":{}}}],
  "duration_s":900000,"frames_per_s":1,"fixed":{"time_step_s":0.001}},"simulate":{}}})";

std::string submit(const std::string& address) {
  const HttpAnswer answer = http_call(address, "POST", "/v1/simJobs", {{"Content-Type", "application/json"}}, kEndless);
  return "/v1/" + nlohmann::json::parse(answer.body).at("name").get<std::string>();
}

// Sorted [ms].
std::vector<double> latencies(const std::string& address, const std::string& path, int requests) {
  HttpConnection connection(address);
  std::vector<double> result;
  for (int i = 0; i < requests; ++i) {
    const Clock::time_point start = Clock::now();
    connection.send_request("GET", path);
    if (connection.read_answer().status != 200) throw std::runtime_error("GET " + path + " was refused");
    result.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
  }
  std::sort(result.begin(), result.end());
  return result;
}

void print(const std::string& what, const std::vector<double>& sorted) {
  const auto at = [&](double share) {
    return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
  };
  std::cout << std::left << std::setw(34) << what << std::fixed << std::setprecision(3) << "median " << at(0.5)
            << "  p90 " << at(0.9) << "  p99 " << at(0.99) << "  max " << sorted.back() << " ms\n";
}

}  // namespace

int main(int argc, char** argv) {
  const int requests = argc > 1 ? std::stoi(argv[1]) : 2000;
  const TemporaryFolder folder;
  ServerProcess server(
      {"--grpc", "127.0.0.1:0", "--http", "127.0.0.1:0", "--data-dir", folder / "data", "--slots", "1", "--stop-jobs"});
  const std::string address = server.http_address();
  const std::string running = submit(address), waiting = submit(address);
  print("GET alone", latencies(address, waiting, requests));
  std::vector<std::unique_ptr<HttpConnection>> watching;
  const auto watch = [&](const std::string& job) {
    watching.clear();
    for (int i = 0; i < kWatching; ++i) {
      watching.push_back(std::make_unique<HttpConnection>(address));
      watching.back()->send_request("GET", job + "/events");
      watching.back()->read_answer(true);
    }
  };
  watch(waiting);
  print("GET beside 200 idle SSE clients", latencies(address, waiting, requests));
  watch(running);
  print("GET beside 200 busy SSE clients", latencies(address, waiting, requests));
  server.signal(SIGTERM);
  return server.wait();
}
