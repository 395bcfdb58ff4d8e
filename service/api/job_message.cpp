// SPDX-License-Identifier: MIT
#include "api/job_message.h"

#include <google/protobuf/util/time_util.h>

#include <string_view>

#include "api/rpc_status.h"

namespace slipstitch {
namespace {

constexpr std::string_view kJobs = "simJobs/", kArtefacts = "/artefacts/";

void set_time(const std::string& text, google::protobuf::Timestamp* time) {
  google::protobuf::util::TimeUtil::FromString(text, time);
}

void set_progress(const ProgressInfo& info, v1::JobProgress& message) {
  const Progress& progress = info.progress;
  message.set_t(progress.t);
  message.set_duration_s(progress.duration_s);
  message.set_frames(static_cast<std::uint32_t>(progress.frames));
  message.set_num_frames(static_cast<std::uint32_t>(progress.num_frames));
  message.set_steps(static_cast<std::uint64_t>(progress.steps));
  message.set_newton_iterations(static_cast<std::uint64_t>(progress.newton_iterations));
  message.set_current_step_s(progress.step_s);
  message.set_residual(progress.residual);
  message.set_wall_s(progress.wall_s);
  if (info.eta_s) message.set_eta_s(*info.eta_s);
  if (progress.error_estimate_m) message.set_error_estimate_m(*progress.error_estimate_m);
  message.set_share_done(info.share_done);
  if (progress.budget_s) message.set_budget_s(*progress.budget_s);
  message.mutable_wall_by_phase_s()->insert(progress.wall_by_phase_s.begin(), progress.wall_by_phase_s.end());
}

void set_work(const JobInfo& info, v1::SimJob& message) {
  if (!info.study) {
    message.mutable_simulate();
    return;
  }
  message.mutable_study()->set_quick(info.study->quick);
  message.mutable_study()->set_budget_s(info.study->budget_s);
}

}  // namespace

v1::SimJob message_from_job(const jobs::Job& job) {
  v1::SimJob message;
  message.set_name(job.info.name);
  message.set_state(message_from_state(job.state));
  message.set_revision(job.revision);
  message.set_request_id(job.info.request_id);
  message.set_scene_name(job.info.scene_name);
  message.set_threads(static_cast<std::uint32_t>(job.info.threads));
  message.set_spec_hash(job.info.spec_hash);
  if (!job.info.create_time.empty()) set_time(job.info.create_time, message.mutable_create_time());
  if (!job.start_time.empty()) set_time(job.start_time, message.mutable_start_time());
  if (!job.end_time.empty()) set_time(job.end_time, message.mutable_end_time());
  if (job.progress) set_progress(*job.progress, *message.mutable_progress());
  if (job.progress && !jobs::is_terminal(job.state)) message.mutable_progress()->set_doing(job.progress->doing);
  if (job.failure) *message.mutable_error() = rpc_status(*job.failure);
  message.set_summary_json(job.summary_json);
  message.set_cancel_requested(job.cancel_requested);
  set_work(job.info, message);
  return message;
}

v1::SimJob::State message_from_state(jobs::JobState state) {
  switch (state) {
    case jobs::JobState::queued:
      return v1::SimJob::QUEUED;
    case jobs::JobState::running:
      return v1::SimJob::RUNNING;
    case jobs::JobState::succeeded:
      return v1::SimJob::SUCCEEDED;
    case jobs::JobState::failed:
      return v1::SimJob::FAILED;
    case jobs::JobState::cancelled:
      return v1::SimJob::CANCELLED;
  }
  return v1::SimJob::STATE_UNSPECIFIED;
}

std::optional<jobs::JobState> state_from_message(v1::SimJob::State state) {
  for (const jobs::JobState known : jobs::kJobStates) {
    if (message_from_state(known) == state) return known;
  }
  return std::nullopt;
}

std::string id_from_name(const std::string& name) { return name.starts_with(kJobs) ? name.substr(kJobs.size()) : name; }

ArtefactName parse_artefact_name(const std::string& name) {
  const std::size_t split = name.find(kArtefacts);
  if (split == std::string::npos) return {id_from_name(name), {}};
  return {id_from_name(name.substr(0, split)), name.substr(split + kArtefacts.size())};
}

std::string artefact_name(const std::string& id, const std::string& file) {
  return std::string(kJobs) + id + std::string(kArtefacts) + file;
}

}  // namespace slipstitch
