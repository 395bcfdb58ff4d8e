// SPDX-License-Identifier: MIT
#include "api/create_job.h"

#include <google/protobuf/unknown_field_set.h>

#include <algorithm>
#include <limits>

#include "model/check_values.h"
#include "scene_io/load_scene.h"
#include "scene_io/message_json.h"
#include "scene_io/read_message.h"
#include "scene_io/spec_hash.h"

namespace slipstitch {
namespace {

void check_unknown(const google::protobuf::Message& message, const std::string& path, Issues& issues) {
  const auto& unknown = message.GetReflection()->GetUnknownFields(message);
  for (int i = 0; i < unknown.field_count() && !issues.full(); ++i) {
    issues.push_back({path, "unknown field number " + std::to_string(unknown.field(i).number()),
                      "the fields of " + message.GetTypeName()});
  }
}

// Paths of a scene start at the scene, those of a request at the request.
void add_scene_issues(const v1::Scene& scene_message, LoadResult& loaded, Issues& issues) {
  loaded = load_scene_message(scene_message);
  const Issues* found = std::get_if<Issues>(&loaded);
  if (found == nullptr) return;
  for (Issue issue : *found) {
    issue.path = issue.path.empty() ? "spec.scene" : "spec.scene." + issue.path;
    issues.push_back(std::move(issue));
  }
}

void check_work(const v1::SimJobSpec& spec, Issues& issues) {
  switch (spec.work_case()) {
    case v1::SimJobSpec::kSimulate:
      return check_unknown(spec.simulate(), "spec.simulate", issues);
    case v1::SimJobSpec::kStudy:
      check_unknown(spec.study(), "spec.study", issues);
      return Checker(issues).not_negative("spec.study.budget_s", spec.study().budget_s());
    case v1::SimJobSpec::WORK_NOT_SET:
      issues.push_back({"spec.work", "missing", "exactly one kind of work: simulate or study"});
  }
}

// Besides the scene.
void check_spec(const v1::CreateSimJobRequest& request, Issues& issues) {
  check_unknown(request, "", issues);
  check_unknown(request.spec(), "spec", issues);
  if (!request.has_spec()) {
    issues.push_back({"spec", "missing", "a SimJobSpec"});
    return;
  }
  if (!request.spec().has_scene()) issues.push_back({"spec.scene", "missing", "a Scene"});
  check_work(request.spec(), issues);
}

jobs::NewJob new_job(const v1::CreateSimJobRequest& request, v1::Scene scene) {
  jobs::NewJob job;
  job.request_id = request.request_id();
  job.scene_name = scene.name();
  job.scene_json = json_text(scene);
  job.threads = static_cast<int>(std::min<std::uint32_t>(request.spec().threads(), std::numeric_limits<int>::max()));
  if (request.spec().has_study())
    job.study = StudyWork{request.spec().study().quick(), request.spec().study().budget_s()};
  v1::SimJobSpec spec = request.spec();
  *spec.mutable_scene() = std::move(scene);
  job.spec_hash = [spec = std::move(spec)](int threads) mutable {
    spec.set_threads(static_cast<std::uint32_t>(threads));
    return message_hash(spec);
  };
  return job;
}

}  // namespace

jobs::Outcome<jobs::Job> create_job(jobs::JobStore& store, const v1::CreateSimJobRequest& request, Issues found) {
  Issues issues;
  check_spec(request, issues);
  LoadResult loaded = Issues();
  if (request.spec().has_scene()) add_scene_issues(request.spec().scene(), loaded, issues);
  if (!issues.empty() || !found.empty()) {  // else the store checks the other fields
    for (const Issue& field : jobs::check_fields(request.request_id(), request.spec().threads())) {
      issues.push_back(field);
    }
    return jobs::error_from_issues(with_independent(std::move(found), issues));
  }
  const jobs::NewJob job = new_job(request, std::move(std::get<LoadedScene>(loaded).message));
  return request.validate_only() ? store.validate(job) : store.create(job);
}

jobs::Error request_too_big(std::optional<std::uint64_t> bytes, int max_scene_mib) {
  const std::string size = bytes ? std::to_string(*bytes) + " bytes, " : std::string();
  return {jobs::ErrorCode::resource_exhausted,
          "SCENE_TOO_BIG",
          "the scene has " + size + "more than the " + std::to_string(max_scene_mib) +
              " MiB this server takes (--max-scene-mib)",
          {{"limit", std::to_string(max_scene_mib)}, {"flag", "--max-scene-mib"}},
          {},
          {}};
}

}  // namespace slipstitch
