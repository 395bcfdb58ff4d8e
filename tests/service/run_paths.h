// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "run_dir/run_dir.h"
#include "sim/frame.h"
#include "support/parsers/curves.h"

namespace slipstitch::test {

/// A run as a log or a stream shows it.
struct ShownRun {
  FrameHeader header;
  std::vector<Frame> frames;
  std::string state_hash;  // as reported beside the frames
};

Result<ShownRun> logged_run(const RunDir& dir);  // of an ended run

/// Through the command line's own download.
Result<ShownRun> downloaded_run(const std::string& address, const std::string& job, const std::string& state_hash);

/// A frame as a parser of the tests reads it from a file.
struct ParsedFrame {
  std::vector<std::vector<std::array<double, 3>>> yarns;  // one point a visit
  bool single = false;                                    // coordinates are float32
  std::optional<double> t;                                // where the format has it
  std::vector<double> arc_length_m;                       // likewise, by point
};

/// All files of a format ("obj", "bcc" or "vtp") in a folder, by name. None in place of a file that is malformed or not
/// called after its frame.
using ParsedFrames = std::vector<std::optional<ParsedFrame>>;
ParsedFrames parsed_frames(const std::filesystem::path& folder, const std::string& format);

/// What a file with float32 coordinates keeps.
inline double rounded_to_float(double value) { return static_cast<double>(static_cast<float>(value)); }

/// Empty: the same bits, in a float32 file those of the rounded value. Otherwise a line a frame, its first difference.
std::vector<std::string> differences(const ShownRun& expected, const ShownRun& found);
std::vector<std::string> differences(const ShownRun& expected, const ParsedFrames& found);

/// Several ways to one run, by name.
struct RunPaths {
  std::map<std::string, ShownRun> runs;
  std::map<std::string, ParsedFrames> files;
};

/// By the name of the path, those that differ only.
using PathDifferences = std::map<std::string, std::vector<std::string>>;
PathDifferences differences(const ShownRun& expected, const RunPaths& paths);

}  // namespace slipstitch::test
