// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace slipstitch {

struct ServerOptions {
  std::string grpc_address = "127.0.0.1:50651";
  std::optional<std::string> http_address = "127.0.0.1:8651";  // empty: no REST
  std::filesystem::path viewer;                                // folder of the viewer's files
  double http_timeout_s = 30.0;
  double prediction_timeout_s = 20.0;
  int http_connections = 512;
  std::filesystem::path data_dir;
  std::filesystem::path worker;
  int slots = 1;
  int queue = 100;
  int max_scene_mib = 16;
  double stall_timeout_s = 30.0;
  double stop_grace_s = 2.0;
  bool stop_jobs = false;
};

/// Either options, or what to print and exit with (--help, --version, bad usage).
struct ParsedOptions {
  std::optional<ServerOptions> options;
  std::string output;  // to stdout when exit_code is 0, else to stderr
  int exit_code = 0;
};

/// Arguments without the program's name, which is `program` in the help. The worker's default is slipstitch-worker
/// beside the running executable, the viewer's ../viewer from there, or ../share/slipstitch/viewer.
ParsedOptions parse_server_options(std::vector<std::string> arguments, const std::string& program);

}  // namespace slipstitch
