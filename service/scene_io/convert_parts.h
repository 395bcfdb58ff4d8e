// SPDX-License-Identifier: MIT
#pragma once

#include <google/protobuf/repeated_field.h>

#include <string>
#include <vector>

#include "model/effects.h"
#include "model/issue.h"
#include "model/material.h"
#include "slipstitch/v1/effects.pb.h"
#include "slipstitch/v1/scene.pb.h"

namespace slipstitch {

/// Shared by the files behind convert.h.

using Doubles = google::protobuf::RepeatedField<double>;

/// No numbers mean `otherwise`; any count but 3 is an issue.
Vec3 vector_from(const Doubles& numbers, const Vec3& otherwise, const std::string& path, Issues& issues);
void add_vector(const Vec3& vector, Doubles& numbers);

YarnMaterial material_from_message(const v1::YarnMaterial& message);
void write_material(const YarnMaterial& yarn, v1::YarnMaterial& message);

std::vector<Keyframe> motion_from(const google::protobuf::RepeatedPtrField<v1::Keyframe>& message, const std::string& path,
                                  Issues& issues);
void write_motion(const std::vector<Keyframe>& motion, google::protobuf::RepeatedPtrField<v1::Keyframe>& message);

CollidersEffect colliders_from(const v1::CollidersEffect& message, Issues& issues);
void write_colliders(const CollidersEffect& effect, v1::CollidersEffect& message);
using LengthKeyframes = google::protobuf::RepeatedPtrField<v1::LengthKeyframe>;
std::vector<LengthKeyframe> length_keyframes_from(const LengthKeyframes& messages);
void add_length_keyframes(const std::vector<LengthKeyframe>& keyframes, LengthKeyframes& messages);

Effects effects_from_message(const v1::Effects& message, Issues& issues);
void write_effects(const Effects& effects, v1::Effects& message);

}  // namespace slipstitch
