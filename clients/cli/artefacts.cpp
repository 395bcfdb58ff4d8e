// SPDX-License-Identifier: MIT
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/command.h"
#include "cli/exit_code.h"
#include "cli/interrupt.h"
#include "cli/options.h"
#include "cli/remote/read_stream.h"
#include "cli/remote_command.h"
#include "cli/screen/text.h"
#include "run_dir/atomic_file.h"
#include "run_dir/run_dir.h"

namespace slipstitch {
namespace {

struct ArtefactsOptions {
  std::string job, server, out;
  bool force = false, json = false;
};

std::string file_of(const v1::Artefact& artefact) { return artefact.name().substr(artefact.name().rfind('/') + 1); }

Reply<std::string> read_artefact(const Connection& connection, const std::string& name, Interrupt& interrupt) {
  v1::GetArtefactRequest request;
  request.set_name(name);
  std::string bytes;
  const grpc::Status status = read_stream<v1::ArtefactChunk>(
      [&](grpc::ClientContext& context, grpc::CompletionQueue& queue) {
        return connection.jobs().AsyncGetArtefact(&context, request, &queue, nullptr);
      },
      [&] { return interrupt.requested(); },
      [&](const v1::ArtefactChunk& chunk) {
        bytes += chunk.data();
        return true;
      });
  if (!status.ok()) return {std::nullopt, remote_error(status)};
  return {std::move(bytes), {}};
}

void print_artefacts(const v1::ListArtefactsResponse& list, const ArtefactsOptions& options) {
  nlohmann::ordered_json json{{"artefacts", nlohmann::ordered_json::array()}};
  std::vector<std::vector<std::string>> rows{{"FILE", "SIZE"}};
  for (const v1::Artefact& artefact : list.artefacts()) {
    json["artefacts"].push_back({{"file", file_of(artefact)}, {"size_bytes", artefact.size_bytes()}});
    rows.push_back({file_of(artefact), bytes_text(static_cast<double>(artefact.size_bytes()))});
  }
  json["out"] = options.out.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(options.out);
  std::cout << (options.json ? json.dump(2) + "\n" : table(rows)) << std::flush;
}

/// An exit code, once there is one.
std::optional<int> save_artefact(const Connection& connection, const v1::Artefact& artefact,
                                 const ArtefactsOptions& options, Interrupt& interrupt) {
  const std::string file = file_of(artefact);
  if (!valid_artefact_name(file)) {
    complain("the server has a file of a strange name, which is left out");
    return std::nullopt;
  }
  const Reply<std::string> bytes = read_artefact(connection, artefact.name(), interrupt);
  if (interrupt.requested()) return kExitInterrupted;
  if (!bytes) return report_error(bytes.error, connection);
  const IoError error = write_file_atomic(std::filesystem::path(options.out) / file, *bytes);
  if (error.empty()) return std::nullopt;
  complain(error);
  return kExitFailed;
}

int fetch_artefacts(const ArtefactsOptions& options) {
  const std::optional<std::string> name = job_name(options.job);
  Interrupt interrupt({});
  const std::optional<Connection> connection = connect(options.server);
  if (!name || !connection) return kExitBadInput;
  if (!options.out.empty() && refuse_occupied(options.out, options.force)) return kExitBadInput;
  v1::ListArtefactsRequest request;
  request.set_name(*name);
  const auto list = unary<v1::ListArtefactsResponse>(connection->jobs(), &v1::SimJobs::Stub::ListArtefacts, request);
  if (!list) return report_error(list.error, *connection);
  if (!options.out.empty()) {
    std::error_code failed;
    std::filesystem::create_directories(options.out, failed);
    for (const v1::Artefact& artefact : list->artefacts())
      if (const auto code = save_artefact(*connection, artefact, options, interrupt)) return *code;
  }
  print_artefacts(*list, options);
  return kExitDone;
}

}  // namespace

Command add_artefacts(CLI::App& root) {
  auto options = std::make_shared<ArtefactsOptions>();
  CLI::App* app = root.add_subcommand("artefacts", "List a job's files, such as a study's report, or fetch them");
  add_job_argument(*app, options->job);
  app->add_option("--out", options->out, "New or empty folder to write them into")
      ->type_name("DIR");
  app->add_flag("--force", options->force, "Write into a folder that is not empty");
  add_server_option(*app, options->server);
  add_json_flag(*app, options->json);
  return {app, [options] { return fetch_artefacts(*options); }};
}

}  // namespace slipstitch
