// SPDX-License-Identifier: MIT
#include "cli/job_output.h"

#include <google/protobuf/util/time_util.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "cli/exit_code.h"
#include "cli/remote/remote_error.h"
#include "cli/screen/summary_text.h"
#include "cli/screen/text.h"
#include "run_dir/run_json.h"

namespace slipstitch {
namespace {

using Json = nlohmann::ordered_json;
using google::protobuf::Timestamp;
using google::protobuf::util::TimeUtil;

Json time_json(bool present, const Timestamp& time) { return present ? Json(TimeUtil::ToString(time)) : Json(); }

std::string time_text(const Timestamp& time) {  // to the second
  std::string text = TimeUtil::ToString(time).substr(0, 19);
  if (text.size() > 10) text[10] = ' ';
  return text + " UTC";
}

Json progress_json(const v1::SimJob& job) {
  if (!job.has_progress()) return {};
  const v1::JobProgress& progress = job.progress();
  return to_json(ProgressInfo{progress_from(progress), eta_from(job), {}, progress.share_done(), progress.doing()});
}

Json work_json(const v1::SimJob& job) {
  if (job.has_study()) return {{"study", {{"quick", job.study().quick()}, {"budget_s", job.study().budget_s()}}}};
  return {{"simulate", Json::object()}};
}

Json error_json(const v1::SimJob& job) {
  if (!job.has_error()) return {};
  const RemoteError error = remote_error(job.error());
  return {{"reason", error.reason}, {"message", error.message}};
}

Json summary_of(const v1::SimJob& job) {
  if (job.summary_json().empty()) return {};
  Json summary = Json::parse(job.summary_json(), nullptr, false);
  return summary.is_object() ? summary : Json();
}

std::string lower_case(std::string word) {
  std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::tolower(c); });
  return word;
}

}  // namespace

Json job_json(const v1::SimJob& job) {
  Json json{{"name", job.name()},
            {"status", lower_case(v1::SimJob::State_Name(job.state()))},
            {"state", v1::SimJob::State_Name(job.state())},
            {"revision", job.revision()},
            {"request_id", job.request_id()},
            {"scene_name", job.scene_name()},
            {"work", work_json(job)},
            {"threads", job.threads()},
            {"spec_hash", job.spec_hash()},
            {"create_time", time_json(job.has_create_time(), job.create_time())},
            {"start_time", time_json(job.has_start_time(), job.start_time())},
            {"end_time", time_json(job.has_end_time(), job.end_time())},
            {"cancel_requested", job.cancel_requested()},
            {"progress", progress_json(job)},
            {"error", error_json(job)}};
  if (!json["progress"].is_null()) json["progress"].erase("update_time");
  const Json summary = summary_of(job);
  for (const auto& [key, value] : summary.items()) json[key] = value;
  return json;
}

std::string job_text(const v1::SimJob& job) {
  Rows rows{{"scene", job.scene_name().empty() ? "(no name)" : job.scene_name()},
            {"work", work_text(job)},
            {"state", state_text(job)}};
  if (job.has_error()) rows.emplace_back("error", remote_error(job.error()).message);
  if (job.has_progress() && job.state() == v1::SimJob::RUNNING) {
    const v1::JobProgress& progress = job.progress();
    const std::string frames = "frame " + thousands(progress.frames()) + " of " + thousands(progress.num_frames());
    const bool told = job.has_study() || !is_simulating(progress);
    rows.emplace_back("progress", progress_text(job) + ", " + (told ? progress.doing() : frames));
    if (const auto eta = eta_from(job)) rows.emplace_back("to go", duration_text(*eta));
  }
  rows.emplace_back("created", create_time_text(job));
  if (job.has_start_time()) rows.emplace_back("started", time_text(job.start_time()));
  if (job.has_end_time()) rows.emplace_back("ended", time_text(job.end_time()));
  rows.emplace_back("threads", std::to_string(job.threads()));
  if (!job.request_id().empty()) rows.emplace_back("request id", job.request_id());
  return job.name() + "\n" + two_columns(rows);
}

std::string job_summary_text(const v1::SimJob& job) {
  const Json summary = summary_of(job);
  return summary.is_object() ? summary_text(summary) : std::string();
}

std::string state_text(const v1::SimJob& job) {
  return v1::SimJob::State_Name(job.state()) +
         (job.cancel_requested() && job.state() < v1::SimJob::SUCCEEDED ? ", cancel requested" : "");
}

std::string progress_text(const v1::SimJob& job) {
  if (!job.has_progress()) return {};
  const double share = std::clamp(job.progress().share_done(), 0.0, 1.0);
  return std::to_string(static_cast<int>(std::floor(100.0 * share))) + " %";
}

std::string work_text(const v1::SimJob& job) {
  if (!job.has_study()) return "simulate";
  const double budget_s = job.study().budget_s();
  return (job.study().quick() ? "quick study" : "study") +
         (budget_s > 0.0 ? ", at most " + duration_text(budget_s) : "");
}

std::string create_time_text(const v1::SimJob& job) {
  return job.has_create_time() ? time_text(job.create_time()) : std::string();
}

bool is_simulating(const v1::JobProgress& progress) {
  return progress.doing().empty() || progress.doing() == "simulating";
}

Progress progress_from(const v1::JobProgress& message) {
  Progress progress;
  progress.t = message.t();
  progress.duration_s = message.duration_s();
  progress.frames = static_cast<int>(message.frames());
  progress.num_frames = static_cast<int>(message.num_frames());
  progress.steps = static_cast<long>(message.steps());
  progress.newton_iterations = static_cast<long>(message.newton_iterations());
  progress.step_s = message.current_step_s();
  progress.residual = message.residual();
  if (message.has_error_estimate_m()) progress.error_estimate_m = message.error_estimate_m();
  progress.wall_s = message.wall_s();
  if (message.has_budget_s()) progress.budget_s = message.budget_s();
  progress.wall_by_phase_s = {message.wall_by_phase_s().begin(), message.wall_by_phase_s().end()};
  return progress;
}

std::optional<double> eta_from(const v1::SimJob& job) {
  if (job.progress().has_eta_s()) return job.progress().eta_s();
  return job.has_study() ? std::nullopt : estimate_eta(progress_from(job.progress()));
}

int exit_code_of(v1::SimJob::State state) {
  switch (state) {
    case v1::SimJob::SUCCEEDED:
      return kExitDone;
    case v1::SimJob::CANCELLED:
      return kExitCancelled;
    default:
      return kExitFailed;
  }
}

}  // namespace slipstitch
