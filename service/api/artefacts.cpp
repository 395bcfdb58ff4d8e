// SPDX-License-Identifier: MIT
#include "api/artefacts.h"

#include <algorithm>

#include "api/message_limits.h"

namespace slipstitch {
namespace {

constexpr char kScene[] = "scene.json", kSummary[] = "summary.json";

std::filesystem::path artefact_path(const RunDir& dir, const std::string& file) {
  if (file == kSummary) return dir.summary();
  return file == kScene ? dir.scene() : dir.report() / file;
}

std::vector<std::string> artefact_files(const RunDir& dir) {
  std::vector<std::string> files = list_artefacts(dir);
  files.emplace_back(kScene);
  if (has_summary(dir)) files.emplace_back(kSummary);
  std::sort(files.begin(), files.end());
  files.erase(std::unique(files.begin(), files.end()), files.end());
  return files;
}

jobs::Error artefact_not_found(const ArtefactName& name) {
  return {jobs::ErrorCode::not_found,
          "ARTEFACT_NOT_FOUND",
          "job simJobs/" + name.id + " has no artefact '" + name.file.substr(0, 200) + "'",
          {},
          {},
          {}};
}

}  // namespace

v1::ListArtefactsResponse artefacts_of(const std::string& id, const RunDir& dir) {
  v1::ListArtefactsResponse response;
  for (const std::string& file : artefact_files(dir)) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(artefact_path(dir, file), error);
    if (error) continue;
    v1::Artefact& artefact = *response.add_artefacts();
    artefact.set_name(artefact_name(id, file));
    artefact.set_size_bytes(size);
  }
  return response;
}

jobs::Outcome<ArtefactReader> ArtefactReader::open(const RunDir& dir, const ArtefactName& name) {
  const std::vector<std::string> files = artefact_files(dir);
  if (std::find(files.begin(), files.end(), name.file) == files.end()) return artefact_not_found(name);
  const std::filesystem::path path = artefact_path(dir, name.file);
  std::ifstream file(path, std::ios::binary);
  std::error_code error;
  const std::uintmax_t total = std::filesystem::file_size(path, error);
  if (!file || error) return artefact_not_found(name);
  return ArtefactReader(std::move(file), total, name.file);
}

jobs::Outcome<std::string> ArtefactReader::next() {
  std::string data(std::min(kChunkBytes, total_ - offset_), '\0');
  if (!file_.read(data.data(), static_cast<std::streamsize>(data.size()))) {
    return jobs::storage_failed(name_ + " cannot be read");
  }
  offset_ += data.size();
  return data;
}

}  // namespace slipstitch
