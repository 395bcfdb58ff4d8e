// SPDX-License-Identifier: MIT
#pragma once

#include "jobs/job_store.h"
#include "slipstitch/v1/job.pb.h"

namespace slipstitch {

/// A page of large summaries is cut short, so that no answer is above 1 MiB.
jobs::Outcome<v1::ListSimJobsResponse> list_jobs(const jobs::JobStore& store, const v1::ListSimJobsRequest& request);

}  // namespace slipstitch
