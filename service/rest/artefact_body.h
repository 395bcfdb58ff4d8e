// SPDX-License-Identifier: MIT
#pragma once

#include "api/artefacts.h"
#include "rest/body_source.h"

namespace slipstitch::rest {

class ArtefactBody final : public BodySource {
 public:
  explicit ArtefactBody(ArtefactReader reader) : reader_(std::move(reader)) {}

  Piece next() override {
    jobs::Outcome<std::string> bytes = reader_.next();
    if (!bytes) return {"", Piece::Then::broken};
    const bool whole = reader_.offset() == reader_.total_bytes();
    return {std::move(*bytes), whole ? Piece::Then::end : Piece::Then::more};
  }

 private:
  ArtefactReader reader_;
};

}  // namespace slipstitch::rest
