// SPDX-License-Identifier: MIT
#include "grpc/artefacts.h"

#include <algorithm>
#include <fstream>

#include "grpc/message_limits.h"

namespace slipstitch {
namespace {

constexpr char kScene[] = "scene.json";

std::filesystem::path artefact_path(const RunDir& dir, const std::string& file) {
  return file == kScene ? dir.scene() : dir.report() / file;
}

std::vector<std::string> artefact_files(const RunDir& dir) {
  std::vector<std::string> files = list_artefacts(dir);
  files.emplace_back(kScene);
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

class ArtefactReactor final : public StreamReactor<v1::ArtefactChunk> {
 public:
  ArtefactReactor(jobs::JobStore& store, const ArtefactName& name, StreamOptions options)
      : StreamReactor(store, name.id, options), name_(name) {}

 private:
  Step<v1::ArtefactChunk> next() override {
    if (!file_.is_open()) {
      if (jobs::Outcome<jobs::Done> opened = open(); !opened) return opened;
    }
    if (offset_ == total_ && any_sent_) return jobs::Outcome<jobs::Done>(jobs::Done{});
    v1::ArtefactChunk chunk;
    std::string& data = *chunk.mutable_data();
    data.resize(std::min(kChunkBytes, total_ - offset_));
    if (!file_.read(data.data(), static_cast<std::streamsize>(data.size()))) {
      return jobs::Outcome<jobs::Done>(jobs::storage_failed(name_.file + " cannot be read"));
    }
    chunk.set_offset(offset_);
    chunk.set_total_bytes(total_);
    offset_ += data.size();
    any_sent_ = true;
    return chunk;
  }

  jobs::Outcome<jobs::Done> open() {
    const jobs::Outcome<RunDir> dir = store().folder(name_.id);
    if (!dir) return dir.error();
    const std::vector<std::string> files = artefact_files(*dir);
    if (std::find(files.begin(), files.end(), name_.file) == files.end()) return artefact_not_found(name_);
    const std::filesystem::path path = artefact_path(*dir, name_.file);
    file_.open(path, std::ios::binary);
    std::error_code error;
    total_ = std::filesystem::file_size(path, error);
    if (!file_ || error) return artefact_not_found(name_);
    return jobs::Done{};
  }

  const ArtefactName name_;
  std::ifstream file_;
  std::uint64_t offset_ = 0, total_ = 0;  // [byte]
  bool any_sent_ = false;
};

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

grpc::ServerWriteReactor<v1::ArtefactChunk>* stream_artefact(jobs::JobStore& store, const ArtefactName& name,
                                                             StreamOptions options) {
  const auto reactor = std::make_shared<ArtefactReactor>(store, name, options);
  reactor->start();
  return reactor.get();
}

}  // namespace slipstitch
