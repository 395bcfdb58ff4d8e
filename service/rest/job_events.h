// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "jobs/job_store.h"
#include "rest/body_source.h"

namespace slipstitch::rest {

/// Snapshots of a job as server-sent events, then `end` when it has ended. `last_seen`: revision the client has
/// already.
class JobEvents final : public BodySource {
 public:
  JobEvents(const jobs::JobStore& store, std::string id, std::optional<std::uint64_t> last_seen)
      : store_(store), id_(std::move(id)), last_seen_(last_seen) {}

  Piece next() override;
  std::string keep_alive() const override { return ":\n\n"; }
  std::string job() const override { return id_; }

 private:
  const jobs::JobStore& store_;
  const std::string id_;
  std::optional<std::uint64_t> last_seen_;
};

}  // namespace slipstitch::rest
