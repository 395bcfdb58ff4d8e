// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formats/curve_frame.h"

namespace slipstitch {

struct FrameFile {
  std::string name;  // in the output folder
  double t = 0.0;    // [s]
};

/// One file that lists those of the frames: head, an entry a frame, foot.
struct Collection {
  std::string_view file_name, head;
  std::string (*entry)(const FrameFile& file);
  std::string_view foot;
};
extern const Collection kPvd;

/// One way to write frames: a file a frame, and with `collection` one file that lists them.
struct Format {
  std::string_view name;       // --format
  std::string_view extension;  // of a frame's file, without the dot
  std::string_view what;       // for --help
  std::string (*write)(const CurveFrame& frame);
  const Collection* collection;  // null: none
};

/// Every format there is, in the order in which help shows them.
std::span<const Format> formats();

/// Null for a name that formats() does not have; format_error() then says what to tell the user.
const Format* find_format(std::string_view name);
std::string format_error(std::string_view name);

std::string frame_file_name(const Format& format, int index);  // frame_000012.obj

// The writers. All lengths in metres.
std::string write_obj(const CurveFrame& frame);
std::string write_bcc(const CurveFrame& frame);
std::string write_vtp(const CurveFrame& frame);
std::string write_json(const CurveFrame& frame);

}  // namespace slipstitch
