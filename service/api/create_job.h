// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "jobs/job_store.h"
#include "slipstitch/v1/job.pb.h"

namespace slipstitch {

/// Checks the spec, all problems at once, then stores the job or, with validate_only, answers with one without a name.
/// `found`: problems of the text that the request was read from; what they may have caused is not told again.
jobs::Outcome<jobs::Job> create_job(jobs::JobStore& store, const v1::CreateSimJobRequest& request, Issues found = {});

/// Of a request of `bytes` that is above the limit. Empty: nobody knows by how much.
jobs::Error request_too_big(std::optional<std::uint64_t> bytes, int max_scene_mib);

}  // namespace slipstitch
