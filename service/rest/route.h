// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "formats/formats.h"
#include "rest/host_check.h"
#include "rest/http_error.h"
#include "rest/operations.h"
#include "slipstitch/v1/frames.pb.h"
#include "slipstitch/v1/job.pb.h"

namespace slipstitch::rest {

/// What a request asks for, its parameters read and checked as far as that goes without the jobs.
struct Route {
  Operation operation = Operation::viewer_file;
  bool head_only = false;                      // HEAD
  std::string id;                              // of the job
  bool shown = false;                          // get_artefact: inline
  std::string file;                            // artefact, or path of a file of the viewer with its leading slash
  std::uint32_t frame_index = 0;               // get_frame
  const Format* format = nullptr;              // get_frame
  v1::ListSimJobsRequest list;                 // list_jobs
  v1::StreamFramesRequest frames;              // stream_frames, without the name
  std::optional<std::uint64_t> last_event_id;  // watch_job
  std::optional<std::string> if_none_match;    // viewer_file
};

/// Routes by the table of operations. Reads nothing but its arguments.
std::variant<Route, HttpError> route(const RequestHead& request, const ServedHosts& hosts);

}  // namespace slipstitch::rest
