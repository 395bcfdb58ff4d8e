// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "jobs/job_store.h"
#include "rest/metrics.h"
#include "rest/route.h"
#include "rest/static_files.h"

namespace slipstitch::rest {

/// What handlers work with.
struct Service {
  jobs::JobStore& store;
  int max_scene_mib = 16;
  StaticFiles files;
  std::string openapi;  // the document
  Metrics metrics;
};

/// Does what a route asks for. May take long (create_job, get_frame) or wait for the store; called from any thread.
Response handle(const Route& route, const std::string& body, const Service& service);

}  // namespace slipstitch::rest
