// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "run_dir/unique_fd.h"
#include "service/service_fixture.h"
#include "support/http_client.h"

namespace slipstitch::test {

using Json = nlohmann::json;

/// A server with both interfaces.
class RestTest : public ServiceTest {
 protected:
  void start_rest(std::vector<std::string> more = {});

  HttpAnswer call(const std::string& method, const std::string& target, const HttpHeaders& headers = {},
                  const std::string& body = "");
  HttpAnswer post_json(const std::string& target, const std::string& body);
  std::string http() const { return server_->http_address(); }
  std::string ended_job();  // its name
};

/// In place of a frame log: who opens it waits until release(), and then finds nothing in it.
class BlockedLog {
 public:
  explicit BlockedLog(std::filesystem::path file);
  void release();

 private:
  const std::filesystem::path file_;
  UniqueFd open_;
};

/// "/v1/simJobs/ID" of "simJobs/ID".
std::string path_of(const std::string& name);

/// CreateSimJobRequest as a client without protobuf writes it.
std::string create_body(const v1::Scene& scene, const std::string& request_id = "");

/// That an answer is a google.rpc.Status with exactly one ErrorInfo of this reason.
void expect_http_error(const HttpAnswer& answer, unsigned status, const std::string& reason);
std::string reason_of(const HttpAnswer& answer);  // empty: no such Status

struct ServerEvent {
  std::string event, id, data;
};
/// Takes the complete events off a text of server-sent events; comments and `retry` are left out.
std::vector<ServerEvent> take_events(std::string& text);

/// One record of the binary stream of frames.
struct StreamedRecord {
  std::uint32_t kind = 0, index = 0;
  double t = 0.0;
  std::string payload;
};
/// Takes the complete records off a stream.
std::vector<StreamedRecord> take_records(std::string& bytes);
std::vector<double> doubles_of(const std::string& payload);

}  // namespace slipstitch::test
