// SPDX-License-Identifier: MIT
#include <iostream>
#include <memory>

#include "cli/command.h"
#include "cli/exit_code.h"
#include "cli/job_output.h"
#include "cli/options.h"
#include "cli/remote_command.h"
#include "cli/screen/text.h"

namespace slipstitch {
namespace {

struct ListOptions {
  std::string server;
  bool json = false;
};

Reply<std::vector<v1::SimJob>> all_jobs(const Connection& connection) {
  std::vector<v1::SimJob> jobs;
  v1::ListSimJobsRequest request;
  do {
    const auto page = unary<v1::ListSimJobsResponse>(connection.jobs(), &v1::SimJobs::Stub::ListSimJobs, request);
    if (!page) return {std::nullopt, page.error};
    jobs.insert(jobs.end(), page->jobs().begin(), page->jobs().end());
    request.set_page_token(page->next_page_token());
  } while (!request.page_token().empty());
  return {std::move(jobs), {}};
}

void print_json(const std::vector<v1::SimJob>& jobs) {
  nlohmann::ordered_json list{{"jobs", nlohmann::ordered_json::array()}};
  for (const v1::SimJob& job : jobs) list["jobs"].push_back(job_json(job));
  std::cout << list.dump(2) << std::endl;
}

void print_table(const std::vector<v1::SimJob>& jobs) {
  std::vector<std::vector<std::string>> rows{{"JOB", "STATE", "DONE", "WORK", "CREATED", "SCENE"}};
  for (const v1::SimJob& job : jobs) {
    rows.push_back({job.name(), v1::SimJob::State_Name(job.state()), progress_text(job),
                    job.has_study() ? "study" : "simulate", create_time_text(job), job.scene_name()});
  }
  std::cout << table(rows) << std::flush;
}

int list_jobs(const ListOptions& options) {
  const std::optional<Connection> connection = connect(options.server);
  if (!connection) return kExitBadInput;
  const Reply<std::vector<v1::SimJob>> jobs = all_jobs(*connection);
  if (!jobs) return report_error(jobs.error, *connection);
  if (options.json) {
    print_json(*jobs);
  } else if (jobs->empty()) {
    note("No jobs at " + connection->address() + ".");
  } else {
    print_table(*jobs);
  }
  return kExitDone;
}

}  // namespace

Command add_list(CLI::App& root) {
  auto options = std::make_shared<ListOptions>();
  CLI::App* app = root.add_subcommand("list", "Show all jobs of a server, newest first");
  add_server_option(*app, options->server);
  add_json_flag(*app, options->json);
  return {app, [options] { return list_jobs(*options); }};
}

}  // namespace slipstitch
