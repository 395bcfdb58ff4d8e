// SPDX-License-Identifier: MIT
#include "grpc/artefacts.h"

#include "api/artefacts.h"

namespace slipstitch {
namespace {

class ArtefactReactor final : public StreamReactor<v1::ArtefactChunk> {
 public:
  ArtefactReactor(jobs::JobStore& store, const ArtefactName& name, StreamOptions options)
      : StreamReactor(store, name.id, options), name_(name) {}

 private:
  using End = jobs::Outcome<jobs::Done>;

  Step<v1::ArtefactChunk> next() override {
    if (!reader_) {
      const jobs::Outcome<RunDir> dir = store().folder(name_.id);
      if (!dir) return End(dir.error());
      jobs::Outcome<ArtefactReader> opened = ArtefactReader::open(*dir, name_);
      if (!opened) return End(opened.error());
      reader_.emplace(std::move(*opened));
    } else if (reader_->offset() == reader_->total_bytes()) {
      return End(jobs::Done{});
    }
    v1::ArtefactChunk chunk;
    chunk.set_offset(reader_->offset());
    chunk.set_total_bytes(reader_->total_bytes());
    jobs::Outcome<std::string> data = reader_->next();
    if (!data) return End(data.error());
    chunk.set_data(std::move(*data));
    return chunk;
  }

  const ArtefactName name_;
  std::optional<ArtefactReader> reader_;
};

}  // namespace

grpc::ServerWriteReactor<v1::ArtefactChunk>* stream_artefact(jobs::JobStore& store, const ArtefactName& name,
                                                             StreamOptions options) {
  const auto reactor = std::make_shared<ArtefactReactor>(store, name, options);
  reactor->start();
  return reactor.get();
}

}  // namespace slipstitch
