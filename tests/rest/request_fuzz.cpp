// SPDX-License-Identifier: MIT
#include "request_fuzz.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>

#include "rest/api_json.h"
#include "rest/ascii.h"
#include "rest/http_parser.h"
#include "rest/route.h"
#include "support/sample_run.h"

namespace slipstitch::test {
namespace {

constexpr int kMaxSceneMib = 1;

// An error must be told in a 4xx or 5xx whose headers hold nothing of the request that could end them, and whose body
// is JSON.
std::string error_flaw(const rest::HttpError& error) {
  if (error.status < 400 || error.status > 599) return "status " + std::to_string(error.status);
  const rest::Response response = rest::error_response(error);
  const std::string head = rest::head_text(response, response.body.size(), false, true);
  if (head.find("\r\n\r\n") != head.size() - 4) return "a head that ends early: " + head;
  for (std::size_t i = 0; i < head.size(); ++i) {
    if (head[i] == '\n' && head[i - 1] != '\r') return "a bare line feed in " + head;
  }
  const auto body = nlohmann::json::parse(response.body, nullptr, false);
  if (!body.is_object() || body["details"].size() < 1) return "no Status: " + response.body;
  return {};
}

std::string route_flaw(const rest::Route& route, const std::string& body) {
  if (route.id.find_first_of("/\\:") != std::string::npos) return "an id that is a path: " + route.id;
  if (route.operation == rest::Operation::get_artefact && route.file.find('/') != std::string::npos) {
    return "a file that is a path: " + route.file;
  }
  if (route.operation == rest::Operation::create_job) {
    const rest::ReadRequest read = rest::read_create_request(body);
    if (read.malformed && read.issues.empty()) return "a body refused without a reason";
  }
  return {};
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t");
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

// Read apart from the parser: whether others might find another end of the request that begins here.
bool has_two_readings(std::string_view bytes) {
  std::istringstream lines{std::string(bytes.substr(0, bytes.find("\r\n\r\n")))};
  std::string request_line, line;
  std::getline(lines, request_line);
  std::vector<std::string> codings, lengths;
  while (std::getline(lines, line)) {
    if (line.ends_with('\r')) line.pop_back();
    if (line.starts_with(' ') || line.starts_with('\t')) return true;
    const std::string name = rest::lower_case(trimmed(line.substr(0, line.find(':'))));
    const std::string value = rest::lower_case(trimmed(line.substr(std::min(line.find(':'), line.size() - 1) + 1)));
    if (name == "transfer-encoding") codings.push_back(value);
    if (name == "content-length") lengths.push_back(value);
  }
  if (codings.empty())
    return std::adjacent_find(lengths.begin(), lengths.end(), std::not_equal_to<>()) != lengths.end();
  return codings != std::vector<std::string>{"chunked"} || !lengths.empty() ||
         request_line.find("HTTP/1.1") == std::string::npos;
}

// One request of a connection.
struct Taken {
  std::string flaw;
  std::size_t bytes = 0;
  bool goes_on = false;  // a request may follow
};

Taken take_request(std::string_view bytes) {
  rest::Parser parser;
  rest::limit(parser, kMaxSceneMib << 20);
  boost::system::error_code error;
  Taken taken;
  taken.bytes = rest::put_head(parser, bytes, error);
  std::variant<rest::Route, rest::HttpError> routed;
  if (!error) routed = rest::route(rest::head_of(parser), {"127.0.0.1", "127.0.0.1"});
  const auto* refused = std::get_if<rest::HttpError>(&routed);
  if (!error && refused == nullptr && !parser.is_done() && taken.bytes < bytes.size()) {
    parser.eager(true);
    const std::string_view rest = bytes.substr(taken.bytes);
    taken.bytes += parser.put(boost::asio::const_buffer(rest.data(), rest.size()), error);
  }
  if (error == boost::beast::http::error::need_more) return taken;
  if (error) {
    const auto answer = rest::read_error(parser, error, kMaxSceneMib);
    taken.flaw = answer ? error_flaw(*answer) : std::string();
    return taken;
  }
  taken.goes_on = parser.is_done() && parser.keep_alive();
  taken.flaw = refused ? error_flaw(*refused) : route_flaw(std::get<rest::Route>(routed), parser.get().body());
  return taken;
}

}  // namespace

std::string request_flaw(std::string_view bytes) {
  while (!bytes.empty()) {
    const Taken taken = take_request(bytes);
    if (!taken.flaw.empty() || !taken.goes_on) return taken.flaw;
    if (has_two_readings(bytes)) return "a second answer after a request whose end is unclear";
    bytes.remove_prefix(taken.bytes);
  }
  return {};
}

std::vector<std::string> request_corpus() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(SLIPSTITCH_SOURCE_DIR "/tests/rest/corpus")) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<std::string> requests;
  for (const auto& file : files) requests.push_back(read_bytes(file));
  return requests;
}

std::string mutated_request(std::string text, const std::vector<std::string>& others, std::mt19937_64& random) {
  const auto below = [&](std::size_t end) { return end == 0 ? 0 : random() % end; };
  for (std::size_t edits = 1 + below(4); edits > 0; --edits) {
    const std::size_t at = below(text.size() + 1);
    const std::string& other = others[below(others.size())];
    const std::size_t from = below(other.size());
    switch (below(5)) {
      case 0:
        text.insert(at, other.substr(from, below(40)));
        break;
      case 1:
        text.erase(at, below(20));
        break;
      case 2:
        text.insert(at, 1, static_cast<char>(random()));
        break;
      case 3:
        text.insert(at, text.substr(at, below(30)));
        break;
      default:
        if (at < text.size()) text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
    }
  }
  return text;
}

}  // namespace slipstitch::test
