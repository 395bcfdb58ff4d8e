// SPDX-License-Identifier: MIT
#include "server/options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <sstream>

#include "jobs/data_dir.h"
#include "jobs/worker_environment.h"
#include "platform/version.h"

namespace slipstitch {
namespace {

constexpr int kMaxSceneMib = 1024;
constexpr int kMaxSlots = 1024;
constexpr int kMaxQueue = 1'000'000;
constexpr int kMaxConnections = 100'000;
constexpr char kNone[] = "none";
constexpr double kLongest_s = 86'400.0;

std::filesystem::path folder_of_executable() {
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  return error ? std::filesystem::path() : self.parent_path();
}

std::filesystem::path default_viewer() {
  const std::filesystem::path parent = folder_of_executable().parent_path();
  std::error_code error;
  const std::filesystem::path built = parent / "viewer";
  return std::filesystem::is_directory(built, error) ? built : parent / "share/slipstitch/viewer";
}

// HOST:PORT, HOST also as [IPv6].
std::string check_address(const std::string& address) {
  const std::size_t colon = address.rfind(':');
  const std::string port = colon == std::string::npos ? "" : address.substr(colon + 1);
  const bool number = !port.empty() && port.size() <= 5 && port.find_first_not_of("0123456789") == std::string::npos;
  if (colon == 0 || !number || std::stoi(port) > 65535) return "'" + address + "' is not HOST:PORT";
  return {};
}

// The server computes nothing itself.
std::string version_text() {
  const std::string core = jobs::blas_core_for_jobs();
  return "slipstitchd " + version_string() + " (BLAS core of new jobs: " + (core.empty() ? "unknown" : core) + ")";
}

std::string check_http_address(const std::string& address) {
  return address == kNone ? std::string() : check_address(address);
}

// Without CLI11's own wording of the range, which the descriptions give.
CLI::Validator in_range(int first, int last) { return CLI::Range(first, last).description(""); }

CLI::Validator seconds_from(double least) {
  const auto check = [least](const std::string& text) -> std::string {
    double seconds = 0.0;
    const char* end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data(), end, seconds);
    if (parsed.ec == std::errc() && parsed.ptr == end && seconds >= least && seconds <= kLongest_s) return {};
    return "'" + text + "' is no number of seconds in that range";
  };
  return {check, ""};
}

// What is text here and something else in ServerOptions.
struct Texts {
  std::string http, viewer, data_dir, worker;
};

void declare_http(CLI::App& app, ServerOptions& options, Texts& texts) {
  app.add_option("--http", texts.http,
                 "Serve REST and the viewer here; port 0 takes any free one, 'none' leaves it out")
      ->capture_default_str()
      ->check(CLI::Validator(check_http_address, ""));
  app.add_option("--prediction-timeout", options.prediction_timeout_s,
                 "Seconds a request waits to be told what its run would take, 0.1 to 86400")
      ->capture_default_str()
      ->check(seconds_from(0.1));
  app.add_option("--viewer", texts.viewer, "Folder of the viewer's files")->capture_default_str();
  app.add_option("--http-timeout", options.http_timeout_s,
                 "Seconds an HTTP client gets to send a request, or the next one, 0.1 to 86400")
      ->capture_default_str()
      ->check(seconds_from(0.1));
  app.add_option("--http-connections", options.http_connections, "HTTP connections at the same time, 1 to 100000")
      ->capture_default_str()
      ->check(in_range(1, kMaxConnections));
}

void declare(CLI::App& app, ServerOptions& options, Texts& texts) {
  app.add_option("--grpc", options.grpc_address, "Listen here; port 0 takes any free one")
      ->capture_default_str()
      ->check(check_address);
  declare_http(app, options, texts);
  app.add_option("--data-dir", texts.data_dir, "Where jobs are kept; one server at a time")->capture_default_str();
  app.add_option("--slots", options.slots, "Jobs that run at the same time, 1 to 1024")
      ->capture_default_str()
      ->check(in_range(1, kMaxSlots));
  app.add_option("--queue", options.queue, "Jobs that wait beyond those, 0 to 1000000; more are refused")
      ->capture_default_str()
      ->check(in_range(0, kMaxQueue));
  app.add_option("--max-scene-mib", options.max_scene_mib, "Largest scene taken, 1 to 1024 MiB")
      ->capture_default_str()
      ->check(in_range(1, kMaxSceneMib));
  app.add_option("--stall-timeout", options.stall_timeout_s,
                 "Seconds after which a stream whose client does not read is ended, 0.1 to 86400")
      ->capture_default_str()
      ->check(seconds_from(0.1));
  app.add_option("--stop-grace", options.stop_grace_s,
                 "Seconds that calls and streams get to end when the server stops, 0 to 86400")
      ->capture_default_str()
      ->check(seconds_from(0.0));
  app.add_option("--worker", texts.worker, "The program that runs a job")->capture_default_str();
  app.add_flag("--stop-jobs", options.stop_jobs, "On SIGTERM or SIGINT end running jobs too; without it they run on");
}

}  // namespace

ParsedOptions parse_server_options(std::vector<std::string> arguments, const std::string& program) {
  ServerOptions options;
  Texts texts{*options.http_address, default_viewer().string(), jobs::default_data_dir().string(),
              (folder_of_executable() / "slipstitch-worker").string()};
  CLI::App app("Runs knit simulations as jobs and streams their frames over gRPC and REST.", program);
  declare(app, options, texts);
  app.set_version_flag("--version", version_text());
  std::reverse(arguments.begin(), arguments.end());  // CLI11 takes them from the back
  try {
    app.parse(arguments);
  } catch (const CLI::ParseError& error) {
    std::ostringstream text;
    const bool good = app.exit(error, text, text) == 0;
    return {{}, text.str(), good ? 0 : 2};
  }
  if (texts.data_dir.empty()) return {{}, program + ": neither XDG_STATE_HOME nor HOME is set; give --data-dir\n", 2};
  options.http_address = texts.http;
  if (texts.http == kNone) options.http_address.reset();
  options.viewer = std::filesystem::absolute(texts.viewer);
  options.data_dir = std::filesystem::absolute(texts.data_dir);
  options.worker = std::filesystem::absolute(texts.worker);
  return {options, {}, 0};
}

}  // namespace slipstitch
