// SPDX-License-Identifier: MIT
#include "rest_fixture.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <cstring>
#include <sstream>

#include "scene_io/message_json.h"

namespace slipstitch::test {

void RestTest::start_rest(std::vector<std::string> more) {
  more.insert(more.end(), {"--http", "127.0.0.1:0"});
  start_server(more);
}

HttpAnswer RestTest::call(const std::string& method, const std::string& target, const HttpHeaders& headers,
                          const std::string& body) {
  return http_call(http(), method, target, headers, body);
}

HttpAnswer RestTest::post_json(const std::string& target, const std::string& body) {
  return call("POST", target, {{"Content-Type", "application/json"}}, body);
}

std::string RestTest::ended_job() {
  const std::string name = must_create(swing(3, 0.1, 10.0, 1e-2)).name();
  wait_for_end(name);
  return name;
}

BlockedLog::BlockedLog(std::filesystem::path file) : file_(std::move(file)) {
  std::filesystem::remove(file_);
  EXPECT_EQ(::mkfifo(file_.c_str(), 0600), 0);
}

void BlockedLog::release() { open_ = UniqueFd(::open(file_.c_str(), O_RDWR | O_CLOEXEC)); }

std::string path_of(const std::string& name) { return "/v1/" + name; }

std::string create_body(const v1::Scene& scene, const std::string& request_id) {
  Json body;
  body["spec"]["scene"] = json_from_message(scene);
  body["spec"]["simulate"] = Json::object();
  body["request_id"] = request_id;
  return body.dump();
}

std::string reason_of(const HttpAnswer& answer) {
  const Json status = Json::parse(answer.body, nullptr, false);
  std::string reason;
  if (!status.is_object() || !status.contains("details")) return reason;
  for (const Json& detail : status["details"]) {
    if (detail["@type"] != "type.googleapis.com/google.rpc.ErrorInfo") continue;
    EXPECT_EQ(reason, "") << "two of them: " << answer.body;
    EXPECT_EQ(detail["domain"], "slipstitch");
    reason = detail["reason"];
  }
  return reason;
}

void expect_http_error(const HttpAnswer& answer, unsigned status, const std::string& reason) {
  EXPECT_EQ(answer.status, status) << answer.body;
  EXPECT_EQ(answer.header("content-type"), "application/json");
  EXPECT_EQ(reason_of(answer), reason) << answer.body;
}

std::vector<ServerEvent> take_events(std::string& text) {
  std::vector<ServerEvent> events;
  for (std::size_t end = text.find("\n\n"); end != std::string::npos; end = text.find("\n\n")) {
    std::istringstream lines(text.substr(0, end));
    text.erase(0, end + 2);
    ServerEvent event;
    for (std::string line; std::getline(lines, line);) {
      const std::string name = line.substr(0, line.find(':')),
                        value = line.substr(std::min(line.find(':') + 2, line.size()));
      if (name == "event") event.event = value;
      if (name == "id") event.id = value;
      if (name == "data") event.data = value;
    }
    if (!event.event.empty()) events.push_back(event);
  }
  return events;
}

std::vector<StreamedRecord> take_records(std::string& bytes) {
  std::vector<StreamedRecord> records;
  constexpr std::size_t head_bytes = 24;
  while (bytes.size() >= head_bytes) {
    StreamedRecord record;
    std::uint64_t size = 0;
    std::memcpy(&record.kind, bytes.data(), 4);
    std::memcpy(&record.index, bytes.data() + 4, 4);
    std::memcpy(&size, bytes.data() + 8, 8);
    std::memcpy(&record.t, bytes.data() + 16, 8);
    const std::size_t whole = head_bytes + (size + 7) / 8 * 8;
    if (bytes.size() < whole) break;
    record.payload = bytes.substr(head_bytes, size);
    EXPECT_EQ(bytes.find_first_not_of('\0', head_bytes + size) < whole, false) << "padding is zeros";
    bytes.erase(0, whole);
    records.push_back(std::move(record));
  }
  return records;
}

std::vector<double> doubles_of(const std::string& payload) {
  std::vector<double> values(payload.size() / sizeof(double));
  std::memcpy(values.data(), payload.data(), payload.size());
  return values;
}

}  // namespace slipstitch::test
