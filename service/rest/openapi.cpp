// SPDX-License-Identifier: MIT
#include "rest/openapi.h"

#include <nlohmann/json.hpp>

#include "formats/formats.h"
#include "platform/version.h"
#include "rest/ascii.h"
#include "rest/json_schema.h"
#include "rest/openapi_examples.h"
#include "rest/operations.h"
#include "slipstitch/v1/frames.pb.h"
#include "slipstitch/v1/job.pb.h"

namespace slipstitch::rest {
namespace {

using Json = nlohmann::ordered_json;

constexpr char kDescription[] =
    "Jobs that simulate knitted fabric. Bodies are protobuf's JSON mapping of proto/slipstitch/v1 with its own names: "
    "64-bit integers are texts, absent messages are left out. Requests are read strictly: unknown and repeated names "
    "are "
    "refused.\n\nEvery error is a google.rpc.Status with exactly one google.rpc.ErrorInfo. The reasons of each "
    "operation "
    "are the names of the examples of its responses; besides, what is at no path is NO_SUCH_PATH (404). Reasons of 429 "
    "and of TOO_MANY_CONNECTIONS, TOO_MANY_UPLOADS and TOO_MANY_EXPORTS (503) come with Retry-After, 405 comes with "
    "Allow: it is what any other method of the path gets. Codes become statuses so: INVALID_ARGUMENT 400, NOT_FOUND "
    "404, ALREADY_EXISTS and "
    "FAILED_PRECONDITION 409, RESOURCE_EXHAUSTED 429 with Retry-After for QUEUE_FULL and 413 for SCENE_TOO_BIG, "
    "UNAVAILABLE 503, all else 500.\n\nHEAD goes where GET goes.";

Json parameter_schema(ParameterType type) {
  switch (type) {
    case ParameterType::text:
      return {{"type", "string"}};
    case ParameterType::int32:
      return {{"type", "integer"}, {"format", "int32"}};
    case ParameterType::uint32:
      return {{"type", "integer"}, {"format", "uint32"}, {"minimum", 0}};
    case ParameterType::flag:
      return {{"type", "boolean"}};
    case ParameterType::job_state:
    case ParameterType::frame_format:
      break;
  }
  Json names = Json::array();
  if (type == ParameterType::frame_format) {
    for (const Format& format : formats()) names.push_back(format.name);
  } else {
    const auto& states = *v1::SimJob::State_descriptor();
    for (int i = 1; i < states.value_count(); ++i) names.push_back(states.value(i)->name());
  }
  return {{"type", "string"}, {"enum", std::move(names)}};
}

Json path_parameter(const std::string& name) {
  Json parameter{{"name", name}, {"in", "path"}, {"required", true}};
  if (name == "index") {
    parameter["schema"] = parameter_schema(ParameterType::uint32);
    parameter["example"] = 0;
  } else {
    parameter["schema"] = {{"type", "string"}};
    parameter["example"] = name == "id" ? kExampleId : "history.csv";
  }
  return parameter;
}

Json parameters_of(const OperationInfo& info) {
  Json parameters = Json::array();
  for (std::size_t open = info.path.find('{'); open != std::string_view::npos; open = info.path.find('{', open + 1)) {
    parameters.push_back(path_parameter(std::string(info.path.substr(open + 1, info.path.find('}', open) - open - 1))));
  }
  for (const Parameter& parameter : info.query) {
    parameters.push_back({{"name", parameter.name},
                          {"in", "query"},
                          {"description", parameter.description},
                          {"schema", parameter_schema(parameter.type)}});
  }
  if (info.operation == Operation::watch_job) {
    parameters.push_back({{"name", "Last-Event-ID"},
                          {"in", "header"},
                          {"description", "revision of the newest snapshot the client has"},
                          {"schema", {{"type", "string"}, {"format", "uint64"}}}});
  }
  return parameters;
}

Json content(std::string_view type, Json schema, const Json& example) {
  Json body{{"schema", std::move(schema)}};
  if (!example.is_null()) body["example"] = example;
  return {{std::string(type), std::move(body)}};
}

Json success(const OperationInfo& info, JsonSchemas& schemas) {
  Json contents = Json::object();
  for (const std::string_view type : info.response_types) {
    Json schema{{"type", "string"}};
    if (type == "application/octet-stream") schema["format"] = "binary";
    if (type == "application/json") schema = {{"type", "object"}};
    if (!info.response.empty()) schema = schemas.reference(message_named(info.response));
    contents.update(content(type, std::move(schema), response_example(info.operation, type)));
  }
  return {{"description", "Done"}, {"content", std::move(contents)}};
}

// Every reason is an example by its name.
Json responses_of(const OperationInfo& info, JsonSchemas& schemas) {
  Json responses{{"200", success(info, schemas)}};
  for (const std::string_view reason : reasons_of(info)) {
    const ErrorExample example = error_example(reason);
    Json& response = responses[std::to_string(example.status)];
    const std::string before = response.is_null() ? "" : response["description"].get<std::string>() + ", ";
    response["description"] = before + std::string(reason);
    Json& body = response["content"]["application/json"];
    body["schema"] = schemas.reference(message_named("google.rpc.Status"));
    body["examples"][std::string(reason)] = {{"value", example.body}};
  }
  return responses;
}

Json operation_object(const OperationInfo& info, JsonSchemas& schemas) {
  Json operation{{"operationId", info.id}, {"summary", info.summary}, {"parameters", parameters_of(info)}};
  if (!info.request.empty()) {
    const Json schema = schemas.reference(message_named(info.request));
    operation["requestBody"] = {{"required", true},
                                {"content", content("application/json", schema, request_example(info.operation))}};
  }
  operation["responses"] = responses_of(info, schemas);
  return operation;
}

}  // namespace

std::string openapi_document() {
  JsonSchemas schemas;
  for (const char* streamed : {"slipstitch.v1.FrameHeader", "slipstitch.v1.StreamEnd"}) {
    schemas.reference(message_named(streamed));
  }
  Json paths = Json::object();
  for (const OperationInfo& info : operations()) {
    paths[std::string(info.path)][lower_case(info.method)] = operation_object(info, schemas);
  }
  const Json document{{"openapi", "3.0.3"},
                      {"info", {{"title", "Slipstitch"}, {"version", version_string()}, {"description", kDescription}}},
                      {"paths", std::move(paths)},
                      {"components", {{"schemas", schemas.all()}}}};
  return document.dump(1) + "\n";
}

}  // namespace slipstitch::rest
