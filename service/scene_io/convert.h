// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "model/scene.h"
#include "sim/frame.h"
#include "slipstitch/v1/frames.pb.h"
#include "slipstitch/v1/scene.pb.h"

namespace slipstitch {

/// The only translation between protobuf and the core.

/// Absent fields take the core's defaults. What a message can say but the core's types cannot hold (vectors of a wrong
/// length, unknown enum values, a missing choice, a bad pattern) is appended to issues. Ranges are check()'s business;
/// the limits only keep a small message from asking for a huge pattern.
Scene scene_from_message(const v1::Scene& message, Issues& issues, const SceneLimits& limits = {});

/// Every field is written out, patterns as charts: equal scenes give equal messages.
v1::Scene message_from_scene(const Scene& scene);

v1::FrameHeader message_from_header(const FrameHeader& header);

/// Nothing when a fixed-length field has another length or an enum another value. Indices are not checked.
std::optional<FrameHeader> header_from_message(const v1::FrameHeader& message);

}  // namespace slipstitch
