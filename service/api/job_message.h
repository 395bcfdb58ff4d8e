// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "jobs/job.h"
#include "slipstitch/v1/job.pb.h"

namespace slipstitch {

v1::SimJob message_from_job(const jobs::Job& job);
v1::SimJob::State message_from_state(jobs::JobState state);

/// Empty for UNSPECIFIED and for states no job has.
std::optional<jobs::JobState> state_from_message(v1::SimJob::State state);

/// ID of "simJobs/ID"; the whole name if it has another form, which is the id of no job.
std::string id_from_name(const std::string& name);

/// "simJobs/ID/artefacts/FILE".
struct ArtefactName {
  std::string id, file;
};
ArtefactName parse_artefact_name(const std::string& name);
std::string artefact_name(const std::string& id, const std::string& file);

}  // namespace slipstitch
