// SPDX-License-Identifier: MIT
#include "rest/route.h"

#include <algorithm>
#include <charconv>

#include "rest/ascii.h"
#include "rest/query.h"
#include "scene_io/nearest_name.h"

namespace slipstitch::rest {
namespace {

// What the braces of a path stood for.
struct PathValues {
  std::string id, index, file;
};

std::string* value_named(PathValues& values, std::string_view name) {
  if (name == "id") return &values.id;
  return name == "index" ? &values.index : &values.file;
}

// "{id}:cancel" takes "x:cancel" and sets id to x. A colon is never part of a value: behind one stands a verb.
bool match_segment(std::string_view pattern, std::string_view segment, PathValues& values) {
  if (!pattern.starts_with('{')) return pattern == segment;
  const std::size_t close = pattern.find('}');
  const std::string_view rest = pattern.substr(close + 1);
  if (!segment.ends_with(rest)) return false;
  const std::string_view value = segment.substr(0, segment.size() - rest.size());
  if (value.empty() || value.find_first_of(":/\\") != std::string_view::npos) return false;
  *value_named(values, pattern.substr(1, close - 1)) = value;
  return true;
}

bool match_path(std::string_view pattern, const std::vector<std::string>& segments, PathValues& values) {
  std::size_t matched = 0;
  for (pattern.remove_prefix(1);; ++matched) {
    const std::size_t slash = std::min(pattern.find('/'), pattern.size());
    if (matched == segments.size() || !match_segment(pattern.substr(0, slash), segments[matched], values)) return false;
    if (slash == pattern.size()) return matched + 1 == segments.size();
    pattern.remove_prefix(slash + 1);
  }
}

bool takes(const OperationInfo& info, std::string_view method) {
  return info.method == method || (info.method == "GET" && method == "HEAD");
}

std::string allowed_methods(const std::vector<std::string>& segments) {
  std::string allowed;
  for (const OperationInfo& info : operations()) {
    PathValues values;
    if (!match_path(info.path, segments, values)) continue;
    allowed += (allowed.empty() ? "" : ", ") + std::string(info.method) + (info.method == "GET" ? ", HEAD" : "");
  }
  return allowed;
}

template <class Integer>
bool read_integer(const std::string& text, Integer& value) {
  const char* end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data(), end, value);
  return parsed.ec == std::errc() && parsed.ptr == end;
}

bool read_flag(const std::string& text, bool& value) {
  value = text == "true";
  return value || text == "false";
}

bool read_state(const std::string& text, v1::SimJob::State& state) {
  return v1::SimJob::State_Parse(text, &state) && state != v1::SimJob::STATE_UNSPECIFIED;
}

// Why a parameter cannot be taken; empty: it was.
std::string set_list_parameter(const std::string& name, const std::string& value, v1::ListSimJobsRequest& list) {
  std::int32_t size = 0;
  v1::SimJob::State state{};
  if (name == "page_token") {
    list.set_page_token(value);
  } else if (name == "page_size") {
    if (!read_integer(value, size)) return "a whole number";
    list.set_page_size(size);
  } else {
    if (!read_state(value, state)) return "QUEUED, RUNNING, SUCCEEDED, FAILED, CANCELLED or PAUSED";
    list.set_state(state);
  }
  return {};
}

std::string set_stream_parameter(const std::string& name, const std::string& value, v1::StreamFramesRequest& frames) {
  bool follow = false;
  std::uint32_t number = 0;
  if (name == "follow") {
    if (!read_flag(value, follow)) return "true or false";
    frames.set_follow(follow);
    return {};
  }
  if (!read_integer(value, number)) return "a whole number from 0 to 4294967295";
  if (name == "first_index") frames.set_first_index(number);
  if (name == "stride") frames.set_stride(number);
  if (name == "end_index") frames.set_end_index(number);
  return {};
}

std::string format_names() {
  std::vector<std::string> names;
  for (const Format& format : formats()) names.emplace_back(format.name);
  return one_of(names);
}

std::string set_parameter(const std::string& name, const std::string& value, Route& route) {
  switch (route.operation) {
    case Operation::list_jobs:
      return set_list_parameter(name, value, route.list);
    case Operation::stream_frames:
      return set_stream_parameter(name, value, route.frames);
    case Operation::get_artefact:
      return read_flag(value, route.shown) ? "" : "true or false";
    default:
      route.format = find_format(value);
      return route.format == nullptr ? format_names() : std::string();
  }
}

HttpError unknown_parameter(const std::string& name, const OperationInfo& info) {
  std::vector<std::string> known;
  for (const Parameter& parameter : info.query) known.emplace_back(parameter.name);
  const std::string meant = nearest_name(name, known);
  std::string expected = known.empty() ? "no query parameter here" : "a parameter of this path: " + one_of(known);
  if (!meant.empty()) expected = "a parameter of this path; did you mean \"" + meant + "\"?";
  return wrong_parameter(name, "an unknown parameter", expected);
}

std::optional<HttpError> read_query(const Target& target, const OperationInfo& info, Route& route) {
  std::vector<std::string> seen;
  for (const auto& [name, value] : target.query) {
    const auto is_named = [&](const Parameter& parameter) { return parameter.name == name; };
    if (std::none_of(info.query.begin(), info.query.end(), is_named)) return unknown_parameter(name, info);
    if (std::find(seen.begin(), seen.end(), name) != seen.end())
      return wrong_parameter(name, value, "to be given once");
    if (std::string expected = set_parameter(name, value, route); !expected.empty()) {
      return wrong_parameter(name, "'" + value + "'", expected);
    }
    seen.push_back(name);
  }
  return std::nullopt;
}

// "application/json; charset=utf-8".
bool is_json(const RequestHead& request) {
  const std::string* type = request.find("content-type");
  if (type == nullptr) return false;
  std::string media = type->substr(0, type->find(';'));
  media.erase(media.find_last_not_of(" \t") + 1);
  return lower_case(media) == "application/json";
}

std::optional<HttpError> check_body(const RequestHead& request, const OperationInfo& info) {
  if (info.method != "POST") {
    if (request.has_body) return malformed_request(request.method + " has no body");
    return std::nullopt;
  }
  const std::string* encoding = request.find("content-encoding");
  if (request.has_body && encoding != nullptr && lower_case(*encoding) != "identity")
    return unsupported_encoding(*encoding);
  if ((info.request.empty() && !request.has_body) || is_json(request)) return std::nullopt;
  const std::string* type = request.find("content-type");
  return unsupported_media_type(type == nullptr ? "" : *type);
}

void read_headers(const RequestHead& request, Route& route) {
  std::uint64_t id = 0;
  if (const std::string* last = request.find("last-event-id"); last && read_integer(*last, id))
    route.last_event_id = id;
  if (const std::string* tag = request.find("if-none-match")) route.if_none_match = *tag;
}

std::variant<Route, HttpError> route_to(const OperationInfo& info, const PathValues& values, const Target& target,
                                        const RequestHead& request) {
  Route route;
  route.operation = info.operation;
  route.head_only = request.method == "HEAD";
  route.id = values.id;
  route.file = values.file;
  route.format = find_format("json");
  if (info.operation == Operation::get_frame && !read_integer(values.index, route.frame_index)) {
    return wrong_parameter("index", "'" + values.index + "'", "a whole number from 0 to 4294967295");
  }
  if (auto error = read_query(target, info, route)) return std::move(*error);
  if (auto error = check_body(request, info)) return std::move(*error);
  read_headers(request, route);
  return route;
}

std::variant<Route, HttpError> route_file(const std::string& path, const RequestHead& request) {
  if (request.method != "GET" && request.method != "HEAD") {
    return path == "/" ? method_not_allowed(request.method, "GET, HEAD") : no_such_path(path);
  }
  if (request.has_body) return malformed_request(request.method + " has no body");
  Route route;
  route.head_only = request.method == "HEAD";
  route.file = path;
  read_headers(request, route);
  return route;
}

}  // namespace

std::variant<Route, HttpError> route(const RequestHead& request, const ServedHosts& hosts) {
  if (auto error = check_host_and_origin(request, hosts)) return std::move(*error);
  std::string why;
  const std::optional<Target> target = parse_target(request.target, why);
  if (!target) return malformed_request(why);
  for (const OperationInfo& info : operations()) {
    PathValues values;
    if (takes(info, request.method) && match_path(info.path, target->segments, values)) {
      return route_to(info, values, *target, request);
    }
  }
  if (const std::string allowed = allowed_methods(target->segments); !allowed.empty()) {
    return method_not_allowed(request.method, allowed);
  }
  std::string path;
  for (const std::string& segment : target->segments) path += "/" + segment;
  if (target->segments[0] == "v1") return no_such_path(path);
  return route_file(path, request);
}

}  // namespace slipstitch::rest
