// SPDX-License-Identifier: MIT
#include <iostream>
#include <memory>

#include "cli/command.h"
#include "cli/exit_code.h"
#include "cli/follow_job.h"
#include "cli/job_output.h"
#include "cli/options.h"
#include "cli/remote_command.h"

namespace slipstitch {
namespace {

struct SubmitOptions {
  SceneOptions scene;
  std::string server, request_id;
  int threads = 0;
  double budget_s = 0.0;
  bool study = false, quick = false, wait = false, json = false;
};

v1::CreateSimJobRequest request_from(const LoadedScene& scene, const SubmitOptions& options) {
  v1::CreateSimJobRequest request;
  *request.mutable_spec()->mutable_scene() = scene.message;
  request.mutable_spec()->set_threads(static_cast<std::uint32_t>(options.threads));
  if (options.study) {
    request.mutable_spec()->mutable_study()->set_quick(options.quick);
    request.mutable_spec()->mutable_study()->set_budget_s(options.budget_s);
  } else {
    request.mutable_spec()->mutable_simulate();
  }
  request.set_request_id(options.request_id);
  return request;
}

int submit(const SubmitOptions& options) {
  const std::optional<LoadedScene> scene = load(options.scene);
  if (!scene) return kExitBadInput;
  std::optional<Interrupt> interrupt;  // without --wait Ctrl-C just ends
  if (options.wait) interrupt.emplace(std::function<void()>());
  const std::optional<Connection> connection = connect(options.server);
  if (!connection) return kExitBadInput;
  const Reply<v1::SimJob> job =
      unary<v1::SimJob>(connection->jobs(), &v1::SimJobs::Stub::CreateSimJob, request_from(*scene, options));
  if (!job) return report_error(job.error, *connection);
  if (!options.json) std::cout << job->name() << std::endl;
  if (!options.wait) {
    if (options.json) std::cout << job_json(*job).dump(2) << std::endl;
    return kExitDone;
  }
  return follow_job(*connection, job->name(), *interrupt, options.json);
}

}  // namespace

Command add_submit(CLI::App& root) {
  auto options = std::make_shared<SubmitOptions>();
  CLI::App* app = root.add_subcommand("submit", "Send a scene to a server; prints the name of the job");
  add_scene_options(*app, options->scene);
  add_threads_option(*app, options->threads);
  CLI::Option* study = app->add_flag("--study", options->study, "Study what accuracy costs, in place of a simulation");
  app->add_flag("--quick", options->quick, "A study of fewer ways, and a coarser reference")->needs(study);
  app->add_option("--budget", options->budget_s, "Wall time for a study; what does not fit is not run")
      ->type_name("SECONDS")
      ->check(CLI::PositiveNumber.description(""))
      ->needs(study);
  app->add_option("--request-id", options->request_id, "The same ID and scene give the same job, once")
      ->type_name("ID");
  app->add_flag("--wait", options->wait, "Show progress until the job ends, and end like it");
  add_server_option(*app, options->server);
  add_json_flag(*app, options->json);
  return {app, [options] { return submit(*options); }};
}

}  // namespace slipstitch
