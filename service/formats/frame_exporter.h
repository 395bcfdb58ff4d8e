// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "formats/formats.h"

namespace slipstitch {

/// Writes frames as files of one format, from wherever they come: a log, a stream, a running simulation. First begin,
/// then add for every frame; each returns an error, empty when all is well. What is there is whole after each call, so
/// that an export may end, or be killed, at any time.
class FrameExporter {
 public:
  /// A folder with content is refused; with `force` files of the same names are overwritten, others stay.
  FrameExporter(std::filesystem::path folder, const Format& format, bool force)
      : folder_(std::move(folder)), format_(format), force_(force) {}

  /// `reference`: the frame from which sliding is counted, frame 0 of the run.
  std::string begin(FrameHeader header, Frame reference);

  /// The first one makes the folder.
  std::string add(const Frame& frame);

  int num_frames() const { return num_frames_; }

 private:
  std::string open();
  std::string write(const std::string& name, const std::string& bytes) const;
  std::string list(const FrameFile& file);

  std::filesystem::path folder_;
  const Format& format_;
  const bool force_;
  FrameHeader header_;
  Frame reference_;
  int num_frames_ = 0;
  std::ofstream list_;  // the format's collection
};

}  // namespace slipstitch
