// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace slipstitch::rest {

enum class Operation {
  create_job,
  list_jobs,
  get_job,
  delete_job,
  cancel_job,
  watch_job,
  get_frame,
  stream_frames,
  list_artefacts,
  get_artefact,
  health,
  readiness,
  metrics,
  version,
  openapi,
  viewer_file,  // any other path; not in the table
};

enum class ParameterType { text, int32, uint32, flag, job_state, frame_format };

struct Parameter {
  std::string_view name;
  ParameterType type;
  std::string_view description;  // default and range
};

/// One row of the one table of operations: requests are routed by it and /openapi.json is made of it.
struct OperationInfo {
  Operation operation;
  std::string_view method;  // HEAD goes where GET goes
  std::string_view path;    // "{id}" stands for one segment, or for what precedes the rest of its segment
  std::string_view id;      // operationId
  std::string_view summary;
  std::vector<Parameter> query;
  std::string_view request;                      // message of the body; empty: none
  std::vector<std::string_view> response_types;  // Content-Types of 200
  std::string_view response;                     // its message; empty: see the summary
  std::vector<std::string_view> reasons;         // of errors, besides those that reasons_of() adds
};

std::span<const OperationInfo> operations();

/// Reasons of all errors that an operation may answer with: its own, those of every request, those of every POST.
std::vector<std::string_view> reasons_of(const OperationInfo& info);

}  // namespace slipstitch::rest
