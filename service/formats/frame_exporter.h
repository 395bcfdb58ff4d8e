// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "formats/formats.h"

namespace slipstitch {

/// Writes frames as files of one format, from wherever they come: a log, a stream, a running simulation.
/// Order of calls: open, begin, add for every frame, finish. Each returns an error, empty when all is well.
class FrameExporter {
 public:
  FrameExporter(std::filesystem::path folder, const Format& format) : folder_(std::move(folder)), format_(format) {}

  /// Makes the folder. One with content is refused; with `force` files of the same names are overwritten, others stay.
  std::string open(bool force);

  /// `reference`: the frame from which sliding is counted, frame 0 of the run.
  std::string begin(FrameHeader header, Frame reference);

  std::string add(const Frame& frame);

  /// Writes the list of frames where the format has one. Also right after an interruption: lists what was added.
  std::string finish();

  const std::vector<FrameFile>& files() const { return files_; }

 private:
  std::string write(const std::string& name, const std::string& bytes) const;

  std::filesystem::path folder_;
  const Format& format_;
  FrameHeader header_;
  Frame reference_;
  std::vector<FrameFile> files_;
};

}  // namespace slipstitch
