// SPDX-License-Identifier: MIT
#include "formats/formats.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace slipstitch {
namespace {

constexpr std::array kFormats{
    Format{"obj", "obj", "Wavefront OBJ polylines (text, exact)", write_obj, nullptr},
    Format{"bcc", "bcc", "Yuksel's binary curve collection (float32)", write_bcc, nullptr},
    Format{"vtp", "vtp", "ParaView polylines with tension, sliding and radius, and frames.pvd (exact)", write_vtp,
           &kPvd},
    Format{"json", "json", "JSON, one document a frame (exact)", write_json, nullptr},
};

constexpr std::array<std::string_view, 4> kNotYet{"usda", "glb", "ply", "npz"};

}  // namespace

std::span<const Format> formats() { return kFormats; }

const Format* find_format(std::string_view name) {
  const auto found = std::find_if(kFormats.begin(), kFormats.end(), [&](const Format& f) { return f.name == name; });
  return found == kFormats.end() ? nullptr : &*found;
}

std::string format_error(std::string_view name) {
  const bool planned = std::find(kNotYet.begin(), kNotYet.end(), name) != kNotYet.end();
  std::string message = "format '" + std::string(name) + (planned ? "' is not supported yet" : "' is unknown");
  message += "; supported:";
  for (const Format& format : kFormats) message += " " + std::string(format.name);
  return message;
}

std::string frame_file_name(const Format& format, int index) {
  std::array<char, 32> number{};
  std::snprintf(number.data(), number.size(), "frame_%06d.", index);
  return number.data() + std::string(format.extension);
}

}  // namespace slipstitch
