// SPDX-License-Identifier: MIT
#include "rest/operations.h"

namespace slipstitch::rest {
namespace {

constexpr std::string_view kJson = "application/json", kText = "text/plain; charset=utf-8";

std::vector<OperationInfo> make_operations() {
  using enum Operation;
  using enum ParameterType;
  return {
      {create_job,
       "POST",
       "/v1/simJobs",
       "createSimJob",
       "Checks the spec, stores the job and answers with it, QUEUED. The same request_id with the same spec answers "
       "with "
       "the job that exists. validate_only checks, stores nothing, and predicts what the run takes.",
       {},
       "slipstitch.v1.CreateSimJobRequest",
       {kJson},
       "slipstitch.v1.SimJob",
       {"INVALID_SCENE", "REQUEST_ID_REUSED", "QUEUE_FULL", "STORAGE_FAILED", "SERVER_STOPPING"}},
      {list_jobs,
       "GET",
       "/v1/simJobs",
       "listSimJobs",
       "Jobs, newest first, in pages.",
       {{"page_size", int32, "jobs a page, >= 0; 0 (default) means 50, above 100 means 100"},
        {"page_token", text, "next_page_token of the page before; default empty: the first page"},
        {"state", job_state, "only jobs in this state; default: all"}},
       "",
       {kJson},
       "slipstitch.v1.ListSimJobsResponse",
       {"INVALID_PAGE_TOKEN"}},
      {get_job,
       "GET",
       "/v1/simJobs/{id}",
       "getSimJob",
       "The job now.",
       {},
       "",
       {kJson},
       "slipstitch.v1.SimJob",
       {"JOB_NOT_FOUND"}},
      {delete_job,
       "DELETE",
       "/v1/simJobs/{id}",
       "deleteSimJob",
       "Removes an ended job and all its data; answers {}.",
       {},
       "",
       {kJson},
       "google.protobuf.Empty",
       {"JOB_NOT_FOUND", "JOB_NOT_ENDED", "STORAGE_FAILED"}},
      {cancel_job,
       "POST",
       "/v1/simJobs/{id}:cancel",
       "cancelSimJob",
       "Asks a queued or running job to stop and answers at once. No body, or {}.",
       {},
       "",
       {kJson},
       "slipstitch.v1.SimJob",
       {"JOB_NOT_FOUND", "JOB_ENDED", "STORAGE_FAILED"}},
      {watch_job,
       "GET",
       "/v1/simJobs/{id}/events",
       "watchSimJob",
       "Server-sent events. `event: job` has the revision as `id:` and the SimJob as `data:`, in one line; the first "
       "is "
       "the newest snapshot unless the header Last-Event-ID names it, more follow as the job changes. After the "
       "snapshot "
       "of an ended job one `event: end`, and the stream ends. A comment line every 15 s keeps it alive.",
       {},
       "",
       {"text/event-stream"},
       "",
       {"JOB_NOT_FOUND", "SERVER_STOPPING"}},
      {get_frame,
       "GET",
       "/v1/simJobs/{id}/frames/{index}",
       "getFrame",
       "One frame as a file. One is made at a time, none while 64 MiB of them are being sent: others wait their turn, "
       "then get TOO_MANY_EXPORTS.",
       {{"format", frame_format, "of the file; default json"}},
       "",
       {kJson, "model/obj", "application/octet-stream"},
       "",
       {"JOB_NOT_FOUND", "NO_FRAMES", "FRAME_NOT_FOUND", "STORAGE_FAILED", "TOO_MANY_EXPORTS"}},
      {stream_frames,
       "GET",
       "/v1/simJobs/{id}/frames:stream",
       "streamFrames",
       "Frames as one stream of little-endian records: uint32 kind, uint32 index, uint64 payload_bytes, float64 t_s, "
       "then "
       "the payload, padded with zeros to a multiple of 8 bytes that payload_bytes does not count. Kind 1, the header, "
       "first: a FrameHeader as JSON. Kind 2, a frame: float64 q[] as in FrameChunk. Kind 3, the end, last: a "
       "StreamEnd as "
       "JSON. Kind 0: nothing, keeps the stream alive. Skip unknown kinds. A stream without its end is broken: open it "
       "again with first_index = last complete index + stride.",
       {{"first_index", uint32, "frame to begin with, default 0"},
        {"stride", uint32, "every stride-th frame; 0 (default) means 1"},
        {"end_index", uint32, "first frame not wanted, >= first_index; default: no end"},
        {"follow", flag, "wait for frames still to come; default false"}},
       "",
       {"application/octet-stream"},
       "",
       {"JOB_NOT_FOUND", "NO_FRAMES", "STORAGE_FAILED", "SERVER_STOPPING"}},
      {list_artefacts,
       "GET",
       "/v1/simJobs/{id}/artefacts",
       "listArtefacts",
       "Files a job has so far.",
       {},
       "",
       {kJson},
       "slipstitch.v1.ListArtefactsResponse",
       {"JOB_NOT_FOUND"}},
      {get_artefact,
       "GET",
       "/v1/simJobs/{id}/artefacts/{file}",
       "getArtefact",
       "One file. history.csv has a row for every frame so far; its last line may be incomplete while the job runs. A "
       "browser saves it, or with inline shows it, as a page apart from this server's others that runs no scripts.",
       {{"inline", flag, "to be shown, not saved; default false"}},
       "",
       {kJson, "text/csv; charset=utf-8", "text/html; charset=utf-8", "text/markdown; charset=utf-8", "image/svg+xml",
        "application/octet-stream"},
       "",
       {"JOB_NOT_FOUND", "ARTEFACT_NOT_FOUND"}},
      {health, "GET", "/healthz", "getHealth", "The server answers.", {}, "", {kText}, "", {}},
      {readiness,
       "GET",
       "/readyz",
       "getReadiness",
       "The server takes jobs; 503 while it stops.",
       {},
       "",
       {kText},
       "",
       {"SERVER_STOPPING"}},
      {metrics,
       "GET",
       "/metrics",
       "getMetrics",
       "Prometheus text format.",
       {},
       "",
       {"text/plain; version=0.0.4; charset=utf-8"},
       "",
       {}},
      {version, "GET", "/version", "getVersion", "What runs here.", {}, "", {kJson}, "", {}},
      {openapi, "GET", "/openapi.json", "getOpenApi", "This document.", {}, "", {kJson}, "", {}},
  };
}

}  // namespace

std::span<const OperationInfo> operations() {
  static const std::vector<OperationInfo> table = make_operations();
  return table;
}

std::vector<std::string_view> reasons_of(const OperationInfo& info) {
  std::vector<std::string_view> reasons{"MALFORMED_REQUEST",  "INVALID_FIELD",       "WRONG_ORIGIN",
                                        "METHOD_NOT_ALLOWED", "REQUEST_TIMEOUT",     "WRONG_HOST",
                                        "HEADERS_TOO_BIG",    "TOO_MANY_CONNECTIONS"};
  if (info.method == "POST") {
    reasons.insert(reasons.end(), {"SCENE_TOO_BIG", "UNSUPPORTED_MEDIA_TYPE", "TOO_MANY_UPLOADS"});
  }
  reasons.insert(reasons.end(), info.reasons.begin(), info.reasons.end());
  return reasons;
}

}  // namespace slipstitch::rest
