// SPDX-License-Identifier: MIT
#pragma once

#include <google/protobuf/message.h>

#include <string>
#include <string_view>

#include "jobs/error.h"
#include "slipstitch/v1/job.pb.h"

namespace slipstitch::rest {

/// Protobuf's JSON mapping in one line, with the field names of the schema; numbers, texts and lists that are zero or
/// empty are written out, absent messages left out.
std::string api_json(const google::protobuf::Message& message);

struct ReadRequest {
  v1::CreateSimJobRequest request;
  Issues issues;           // of the text; what else is wrong is told by create_job()
  bool malformed = false;  // no JSON object: nothing could be read
};

/// A body of POST /v1/simJobs, strictly: names as in the schema, every key once, nested at most kMaxJsonDepth deep.
ReadRequest read_create_request(std::string_view body);

}  // namespace slipstitch::rest
