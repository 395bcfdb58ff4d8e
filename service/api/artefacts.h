// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <fstream>
#include <string>

#include "api/job_message.h"
#include "jobs/error.h"
#include "run_dir/run_dir.h"

namespace slipstitch {

/// scene.json, the files in report/ and, once there is one, summary.json, by name.
v1::ListArtefactsResponse artefacts_of(const std::string& id, const RunDir& dir);

/// One of them, read in pieces. What is added to the file after open() is left out.
class ArtefactReader {
 public:
  /// Error: there is no such artefact; only names that artefacts_of() lists are looked for.
  static jobs::Outcome<ArtefactReader> open(const RunDir& dir, const ArtefactName& name);

  /// At most kChunkBytes; empty at the end.
  jobs::Outcome<std::string> next();

  std::uint64_t offset() const { return offset_; }  // of the next piece [byte]
  std::uint64_t total_bytes() const { return total_; }

 private:
  ArtefactReader(std::ifstream file, std::uint64_t total, std::string name)
      : file_(std::move(file)), total_(total), name_(std::move(name)) {}

  std::ifstream file_;
  std::uint64_t offset_ = 0, total_ = 0;  // [byte]
  std::string name_;
};

}  // namespace slipstitch
