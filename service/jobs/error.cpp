// SPDX-License-Identifier: MIT
#include "jobs/error.h"

#include <algorithm>

#include "scene_io/issue_text.h"

namespace slipstitch::jobs {

Error error_from_issues(Issues issues) {
  const bool only_limits = std::all_of(issues.begin(), issues.end(), [](const Issue& issue) { return issue.too_big; });
  Error error;
  error.code = only_limits ? ErrorCode::resource_exhausted : ErrorCode::invalid_argument;
  error.reason = only_limits ? "SCENE_TOO_BIG" : "INVALID_SCENE";
  error.message = issues.empty() ? "invalid scene" : issue_line(issues.front());
  if (issues.size() > 1) error.message += " (and " + std::to_string(issues.size() - 1) + " more)";
  if (only_limits && !issues.empty()) error.metadata["limit"] = std::to_string(issues.front().limit);
  error.violations = std::move(issues);
  return error;
}

Error invalid_field(const std::string& field, const std::string& value, const std::string& expected) {
  Error error = error_from_issues({{field, value, expected, false}});
  error.reason = "INVALID_FIELD";
  return error;
}

Error job_not_found(const std::string& id) {
  const std::string name = "simJobs/" + id.substr(0, 200);
  return {ErrorCode::not_found, "JOB_NOT_FOUND", "there is no job " + name, {{"job", name}}, {}, {}};
}

Error wrong_state(const std::string& id, const std::string& reason, const std::string& message) {
  return {ErrorCode::failed_precondition, reason, "simJobs/" + id + " " + message, {{"job", "simJobs/" + id}}, {}, {}};
}

Error no_frames(const std::string& id) {
  return wrong_state(id, "NO_FRAMES", "is a study, which has no frames; its report is among its artefacts");
}

Error server_stopping() {
  return {
      ErrorCode::unavailable, "SERVER_STOPPING", "the server is stopping; jobs that run go on without it", {}, {}, {}};
}

Error storage_failed(const std::string& message) {
  return {ErrorCode::internal, "STORAGE_FAILED", message, {}, {}, {}};
}

}  // namespace slipstitch::jobs
