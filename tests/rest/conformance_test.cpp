// SPDX-License-Identifier: MIT
#include <signal.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <set>
#include <tuple>

#include "rest_fixture.h"
#include "schema_check.h"

namespace slipstitch::test {
namespace {

// One operation of the document.
struct Documented {
  std::string path, method, id;
  Json operation;

  std::string upper_method() const {
    std::string upper = method;
    for (char& c : upper) c = static_cast<char>(c - 'a' + 'A');
    return upper;
  }
};

void replace(std::string& text, const std::string& from, const std::string& to) {
  if (const std::size_t at = text.find(from); at != std::string::npos) text.replace(at, from.size(), to);
}

// Operation, status, and the reason of an error.
using Answers = std::set<std::tuple<std::string, std::string, std::string>>;

Answers answers_of(const Documented& documented) {
  Answers answers;
  for (const auto& [status, response] : documented.operation["responses"].items()) {
    if (status == "200") answers.emplace(documented.id, status, "");
    if (status == "200") continue;
    for (const auto& [reason, unused] : response["content"]["application/json"]["examples"].items()) {
      answers.emplace(documented.id, status, reason);
    }
  }
  return answers;
}

class ConformanceTest : public RestTest {
 protected:
  void read_document() {
    const HttpAnswer answer = call("GET", "/openapi.json");
    ASSERT_EQ(answer.status, 200U);
    document_ = Json::parse(answer.body);
    operations_.clear();
    for (const auto& [path, methods] : document_["paths"].items()) {
      for (const auto& [method, operation] : methods.items()) {
        operations_.push_back({path, method, operation["operationId"], operation});
      }
    }
  }

  const Documented& operation(const std::string& id) const {
    return *std::find_if(operations_.begin(), operations_.end(), [&](const Documented& o) { return o.id == id; });
  }

  // That an answer is as the document says.
  void check(const Documented& documented, const HttpAnswer& answer) {
    SCOPED_TRACE(documented.id + " " + std::to_string(answer.status));
    const std::string status = std::to_string(answer.status);
    EXPECT_TRUE(answer.complete);
    ASSERT_TRUE(documented.operation["responses"].contains(status)) << answer.body;
    const std::string reason = answer.status == 200 ? "" : reason_of(answer);
    EXPECT_TRUE(answers_of(documented).contains({documented.id, status, reason})) << answer.body;
    seen_.emplace(documented.id, status, reason);
    const Json& content = documented.operation["responses"][status]["content"];
    const std::string type = answer.header("content-type");
    ASSERT_TRUE(content.contains(type)) << type;
    if (type != "application/json") return;
    EXPECT_EQ(schema_flaw(Json::parse(answer.body), content[type]["schema"], document_), "") << answer.body;
  }

  // With the placeholders of its path filled in.
  void ask(const std::string& id, const std::string& job_name, const std::string& more = "",
           const HttpHeaders& headers = {}, const std::string& body = "") {
    const Documented& documented = operation(id);
    check(documented, call(documented.upper_method(), path_with(documented, job_name) + more, headers, body));
  }

  static std::string path_with(const Documented& documented, const std::string& job_name,
                               const std::string& index = "0", const std::string& file = "history.csv") {
    std::string path = documented.path;
    replace(path, "{id}", job_name.substr(job_name.find('/') + 1));
    replace(path, "{index}", index);
    replace(path, "{file}", file);
    return path;
  }

  // Begins a request with these bytes behind its path.
  std::unique_ptr<HttpConnection> begin(const Documented& documented, const std::string& job_name,
                                        const std::string& bytes) {
    auto connection = std::make_unique<HttpConnection>(http());
    connection->send(documented.upper_method() + " " + path_with(documented, job_name) + bytes);
    return connection;
  }

  // What HTTP itself is refused for.
  void check_requests(const std::string& job) {
    const std::string head = " HTTP/1.1\r\nHost: localhost\r\n";
    const std::string upload = head + "Content-Type: application/json\r\nContent-Length: ";
    std::vector<std::unique_ptr<HttpConnection>> uploads;
    for (int i = 0; i < 8; ++i) uploads.push_back(begin(operation("createSimJob"), "", upload + "100000\r\n\r\n{"));
    EXPECT_EQ(call("GET", "/healthz").status, 200U);  // accepted after those, so those have begun
    for (const Documented& documented : operations_) {
      const auto told = [&](const std::string& bytes) {
        check(documented, begin(documented, job, bytes)->read_answer());
      };
      const bool post = documented.method == "post";
      HttpHeaders headers{{"Content-Type", "application/json"}};
      const std::string body = post ? "{}" : "";
      ask(documented.id, job, "?nonsense=1", headers, body);
      headers.emplace_back("Origin", "http://example.com");
      ask(documented.id, job, "", headers, body);
      headers.back() = {"Host", "example.com"};
      ask(documented.id, job, "", headers, body);
      check(documented, call("PATCH", path_with(documented, job)));
      told(" HTTP/1.1\r\n\r\n");
      told(head + "A: " + std::string(20'000, 'a') + "\r\n\r\n");
      told(upload + "2000000000\r\n\r\n");
      told(upload + "100000\r\n\r\n");
      if (post) told(head + "Content-Type: text/plain\r\nContent-Length: 1\r\n\r\nx");
    }
  }

  // By a server that takes no more, and by one that does not wait.
  void check_limits(const std::string& ended) {
    start_rest({"--http-connections", "1"});
    HttpConnection first(http());
    first.send_request("GET", "/healthz");
    EXPECT_EQ(first.read_answer().status, 200U);
    for (const Documented& documented : operations_) ask(documented.id, "simJobs/x");
    server_->signal(SIGTERM);
    EXPECT_EQ(server_->wait(), 0);
    start_rest({"--http-timeout", "0.3"});
    std::vector<std::unique_ptr<HttpConnection>> slow;
    for (const Documented& documented : operations_) slow.push_back(begin(documented, "simJobs/x", " HTTP/1.1\r\n"));
    for (std::size_t i = 0; i < slow.size(); ++i) check(operations_[i], slow[i]->read_answer());
    BlockedLog log(folder_of(ended).frames());
    HttpConnection exporting(http());
    exporting.send_request("GET", path_of(ended) + "/frames/0");
    EXPECT_EQ(call("GET", "/healthz").status, 200U);  // accepted after that, so that has begun
    ask("getFrame", ended);
    log.release();
  }

  void while_gone(const std::filesystem::path& path, const std::function<void()>& then) {
    std::filesystem::rename(path, folder_ / "away");
    then();
    std::filesystem::rename(folder_ / "away", path);
  }

  void create(const std::string& body, const HttpHeaders& headers = {{"Content-Type", "application/json"}}) {
    ask("createSimJob", "", "", headers, body);
  }

  // What requests are told that were on their way when the server was stopped.
  void check_stop(const std::string& body, const std::string& running) {
    HttpConnection events(http());
    events.send_request("GET", path_of(running) + "/events");
    EXPECT_EQ(events.read_answer(true).status, 200U);
    const std::vector<std::string> ids{"createSimJob", "watchSimJob", "streamFrames", "getReadiness"};
    const std::vector<std::string> lines{"POST /v1/simJobs", "GET " + path_of(running) + "/events",
                                         "GET " + path_of(running) + "/frames:stream", "GET /readyz"};
    std::vector<std::unique_ptr<HttpConnection>> late;
    for (const std::string& line : lines) {
      late.push_back(std::make_unique<HttpConnection>(http()));
      late.back()->send(line + " HTTP/1.1\r\nHost: localhost\r\n");
    }
    EXPECT_EQ(call("GET", "/healthz").status, 200U);  // accepted after those, so those have begun
    server_->signal(SIGTERM);
    while (!events.read_part().empty()) {
    }
    for (std::size_t i = 0; i < ids.size(); ++i) {
      std::string rest = "\r\n";
      if (i == 0) {
        rest = "Content-Type: application/json\r\nContent-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body;
      }
      late[i]->send(rest);
      check(operation(ids[i]), late[i]->read_answer());
    }
    late.clear();
    EXPECT_EQ(server_->wait(), 0);
  }

  Json document_;
  std::vector<Documented> operations_;
  Answers seen_;
};

TEST_F(ConformanceTest, EveryDocumentedAnswerIsGiven) {
  start_rest({"--max-scene-mib", "1", "--slots", "1", "--queue", "1", "--stop-grace", "60"});
  read_document();
  const std::string example =
      operation("createSimJob").operation["requestBody"]["content"]["application/json"]["example"].dump();
  const std::string ended = ended_job(), none = "simJobs/0000000000000000";

  // What goes well.
  for (const char* id : {"listSimJobs", "getHealth", "getReadiness", "getMetrics", "getVersion", "getOpenApi"})
    ask(id, "");
  for (const char* id : {"getSimJob", "watchSimJob", "streamFrames", "listArtefacts", "getArtefact"}) ask(id, ended);
  for (const char* format : {"json", "obj", "bcc", "vtp"}) ask("getFrame", ended, std::string("?format=") + format);
  create(example);
  ask("deleteSimJob", ended_job());

  check_requests(ended);

  // What is not there, or not in that state.
  for (const char* id : {"getSimJob", "deleteSimJob", "cancelSimJob", "watchSimJob", "getFrame", "streamFrames",
                         "listArtefacts", "getArtefact"}) {
    ask(id, none);
  }
  check(operation("getFrame"), call("GET", path_with(operation("getFrame"), ended, "999")));
  check(operation("getArtefact"), call("GET", path_with(operation("getArtefact"), ended, "", "none.csv")));
  const std::string study = must_create_study(swing(3, 0.1, 10.0, 1e-2), 1e-9).name();
  for (const char* id : {"getFrame", "streamFrames"}) ask(id, study);
  wait_for_end(study);
  ask("listSimJobs", "", "?page_token=x");
  create("{}");
  ask("cancelSimJob", ended);
  Json other = Json::parse(example);
  other["spec"]["scene"]["name"] = "another";
  create(other.dump());
  wait_for_end(Json::parse(call("GET", "/v1/simJobs").body)["jobs"][0]["name"]);
  while_gone(folder_ / "data/jobs", [&] {
    create(create_body(endless_swing()));
    ask("deleteSimJob", ended);
  });
  const std::string running = must_create(endless_swing()).name();
  wait_for_frames(running, 1);
  ask("deleteSimJob", running);
  const std::string waiting = must_create(endless_swing()).name();
  create(create_body(endless_swing()));

  while_gone(folder_of(waiting).path, [&] { ask("cancelSimJob", waiting); });

  // A damaged log.
  std::string log = read_bytes(folder_of(ended).frames());
  log[60] = static_cast<char>(log[60] ^ 1);  // in the header
  write_bytes(folder_of(ended).frames(), log);
  ask("getFrame", ended);
  ask("streamFrames", ended);

  ask("cancelSimJob", waiting);
  check_stop(example, running);
  check_limits(ended);

  Answers documented;
  for (const Documented& one : operations_) documented.merge(answers_of(one));
  const auto expect_all_in = [](const Answers& these, const Answers& those, const char* what) {
    for (const auto& answer : these) {
      EXPECT_TRUE(those.contains(answer)) << ::testing::PrintToString(answer) << what;
    }
  };
  expect_all_in(documented, seen_, " is documented and was not given");
  expect_all_in(seen_, documented, " was given and is not documented");
}

TEST_F(ConformanceTest, ExamplesFitTheirSchemas) {
  start_rest();
  read_document();
  int examples = 0;
  const auto check_content = [&](const std::string& where, const Json& content) {
    for (const auto& [type, body] : content.items()) {
      const auto check_example = [&](const std::string& name, const Json& example) {
        ++examples;
        EXPECT_EQ(schema_flaw(example, body["schema"], document_), "") << where << " " << type << " " << name;
      };
      if (body.contains("example")) check_example("", body["example"]);
      if (!body.contains("examples")) continue;
      for (const auto& [name, example] : body["examples"].items()) check_example(name, example["value"]);
    }
  };
  for (const Documented& one : operations_) {
    if (one.operation.contains("requestBody")) check_content(one.id, one.operation["requestBody"]["content"]);
    for (const auto& [status, response] : one.operation["responses"].items()) {
      check_content(one.id + " " + status, response["content"]);
    }
    const Json& done = one.operation["responses"]["200"]["content"];
    const bool only_bytes = done.size() == 1 && done.contains("application/octet-stream");
    const bool shown = std::any_of(done.begin(), done.end(), [](const Json& body) { return body.contains("example"); });
    EXPECT_TRUE(shown || only_bytes || one.id == "getOpenApi") << one.id << " has no example";
    for (const Json& parameter : one.operation["parameters"]) EXPECT_TRUE(parameter.contains("schema")) << one.id;
  }
  EXPECT_GT(examples, 150);
}

// Streamed messages have schemas too.
TEST_F(ConformanceTest, StreamedMessagesFitTheirSchemas) {
  start_rest();
  read_document();
  const std::string example =
      operation("createSimJob").operation["requestBody"]["content"]["application/json"]["example"].dump();
  const std::string name = Json::parse(post_json("/v1/simJobs", example).body)["name"];
  EXPECT_EQ(wait_for_end(name).state(), v1::SimJob::SUCCEEDED);
  std::string bytes = call("GET", path_of(name) + "/frames:stream").body;
  const std::vector<StreamedRecord> records = take_records(bytes);
  ASSERT_GE(records.size(), 3U);
  const auto flaw = [&](const StreamedRecord& record, const char* schema) {
    return schema_flaw(Json::parse(record.payload), {{"$ref", std::string("#/components/schemas/") + schema}},
                       document_);
  };
  EXPECT_EQ(flaw(records.front(), "FrameHeader"), "");
  EXPECT_EQ(flaw(records.back(), "StreamEnd"), "");
}

}  // namespace
}  // namespace slipstitch::test
