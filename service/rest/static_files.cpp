// SPDX-License-Identifier: MIT
#include "rest/static_files.h"

#include <array>
#include <cstdio>

#include "rest/content_type.h"
#include "rest/http_error.h"
#include "run_dir/atomic_file.h"

namespace slipstitch::rest {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostBytes = std::size_t{64} << 20;  // of all files

// Everything from here and nothing from elsewhere; what the viewer draws itself it may show and download.
constexpr char kContentSecurityPolicy[] =
    "default-src 'self'; img-src 'self' data: blob:; object-src 'none'; base-uri 'none'; form-action 'none'; "
    "frame-ancestors 'none'";

constexpr char kNoViewer[] =
    "The viewer is not there: build it with ./run build, or name its folder with --viewer.\n"
    "The REST interface works without it; /openapi.json describes it.\n";

// FNV-1a, 64 bits: names a version of a file, protects nothing.
std::string etag_of(const std::string& bytes) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  std::array<char, 24> text{};
  std::snprintf(text.data(), text.size(), "\"%016llx\"", static_cast<unsigned long long>(hash));
  return text.data();
}

}  // namespace

StaticFiles::StaticFiles(const fs::path& folder) {
  std::error_code error;
  if (fs::is_directory(folder, error)) read(folder);
}

void StaticFiles::read(const fs::path& folder) {
  std::size_t left = kMostBytes;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    std::error_code status_error;
    if (!fs::is_regular_file(entry->symlink_status(status_error))) continue;
    Result<std::string> bytes = read_file(entry->path(), left);
    if (!bytes) continue;
    left -= bytes->size();
    std::string etag = etag_of(*bytes);
    files_["/" + entry->path().lexically_relative(folder).generic_string()] = {std::move(*bytes), std::move(etag)};
  }
}

Response StaticFiles::answer(const Route& route) const {
  const std::string path = route.file == "/" ? "/index.html" : route.file;
  const auto found = files_.find(path);
  if (found == files_.end()) {
    if (route.file != "/") return error_response(no_such_path(route.file));
    Response none = text_response("text/plain; charset=utf-8", kNoViewer);
    none.status = 404;
    return none;
  }
  const File& file = found->second;
  Response response = text_response(content_type_of(path), {});
  response.headers.emplace_back("ETag", file.etag);
  response.headers.emplace_back("Cache-Control", "no-cache");
  response.headers.emplace_back("Content-Security-Policy", kContentSecurityPolicy);
  response.headers.emplace_back("Referrer-Policy", "no-referrer");
  const std::string tags = route.if_none_match.value_or("");
  if (tags == "*" || tags.find(file.etag) != std::string::npos) {
    response.status = 304;
  } else {
    response.body = file.bytes;
  }
  return response;
}

}  // namespace slipstitch::rest
