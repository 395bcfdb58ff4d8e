// SPDX-License-Identifier: MIT
#include "cli/remote_command.h"

#include "cli/exit_code.h"
#include "cli/options.h"
#include "cli/remote/address.h"
#include "cli/screen/text.h"

namespace slipstitch {
namespace {

constexpr char kJobs[] = "simJobs/";

int report_no_server(const RemoteError& error, const Connection& connection) {
  if (error.reason.empty()) {
    complain("cannot reach a server at " + connection.address() + ": " + plain_text(error));
    note("Start one with 'slipstitch serve', or name another with --server or SLIPSTITCH_SERVER.");
  } else {
    complain("the server at " + connection.address() + " is going away: " + error.message);
    note("Jobs go on meanwhile; try again when it is back.");
  }
  return kExitNoServer;
}

// The message of an error with violations repeats the first of them.
void report_refusal(const RemoteError& error) {
  const auto left_out = error.metadata.find("violations_left_out");
  if (error.violations.size() <= 1 && left_out == error.metadata.end()) return complain(error.message);
  complain("the server refused this:");
  for (const auto& [field, description] : error.violations) {
    note(field.empty() ? description : field + ": " + description);
  }
  if (left_out != error.metadata.end()) note("... and " + left_out->second + " more");
}

int exit_code_of(const RemoteError& error) {
  switch (error.code) {
    case grpc::StatusCode::INVALID_ARGUMENT:
    case grpc::StatusCode::NOT_FOUND:
    case grpc::StatusCode::ALREADY_EXISTS:
      return kExitBadInput;
    case grpc::StatusCode::RESOURCE_EXHAUSTED:
      return error.reason == "QUEUE_FULL" ? kExitFailed : kExitBadInput;
    default:
      return kExitFailed;
  }
}

}  // namespace

std::optional<Connection> connect(const std::string& server_option) {
  const std::string address = server_address(server_option);
  if (valid_address(address)) return Connection(address);
  complain("'" + address + "' is no address of a server; expected HOST:PORT, e.g. " + kDefaultServer);
  return std::nullopt;
}

std::optional<std::string> job_name(const std::string& argument) {
  const std::string id = argument.starts_with(kJobs) ? argument.substr(sizeof(kJobs) - 1) : argument;
  if (!id.empty() && id.find_first_of("/ ") == std::string::npos) return kJobs + id;
  complain("'" + argument + "' is no name of a job; expected simJobs/ID or ID");
  return std::nullopt;
}

int report_error(const RemoteError& error, const Connection& connection) {
  if (error.code == grpc::StatusCode::UNAVAILABLE) return report_no_server(error, connection);
  if (error.code == grpc::StatusCode::DEADLINE_EXCEEDED) {
    complain("the server at " + connection.address() + " does not answer");
    return kExitNoServer;
  }
  if (error.code == grpc::StatusCode::UNIMPLEMENTED) {
    complain("what listens at " + connection.address() + " is no slipstitchd, or an older one");
    return kExitNoServer;
  }
  report_refusal(error);
  if (error.retry_after_s) note("Try again in " + duration_text(*error.retry_after_s) + ".");
  return exit_code_of(error);
}

std::string command_for(const std::string& word, const std::string& name, const Connection& connection) {
  const bool found_anyway = server_address({}) == connection.address();
  return "slipstitch " + word + " " + name + (found_anyway ? "" : " --server " + shell_word(connection.address()));
}

}  // namespace slipstitch
