// SPDX-License-Identifier: MIT
#include "run_dir/header_codec.h"

#include <array>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#include "run_dir/header_check.h"

namespace slipstitch {
namespace {

class Encoder {
 public:
  template <class... T>
  void operator()(const T&... values) {
    (put(values), ...);
  }
  std::string take() { return std::move(bytes_); }

 private:
  template <class T>
  requires std::is_arithmetic_v<T>
  void put(const T& value) { bytes_.append(reinterpret_cast<const char*>(&value), sizeof value); }
  template <class T>
  requires std::is_enum_v<T>
  void put(const T& value) { put(static_cast<std::uint8_t>(value)); }
  template <class T, std::size_t N>
  void put(const std::array<T, N>& values) {
    for (const T& value : values) put(value);
  }
  template <class T>
  void put(const std::vector<T>& values) {
    put(static_cast<std::uint64_t>(values.size()));
    for (const T& value : values) put(value);
  }
  template <class T>
  requires std::is_class_v<T>
  void put(const T& value) { fields(*this, value); }

  std::string bytes_;
};

class Decoder {
 public:
  explicit Decoder(std::string_view bytes) : bytes_(bytes) {}
  template <class... T>
  void operator()(T&... values) {
    (get(values), ...);
  }
  bool complete() const { return ok_ && bytes_.empty(); }

 private:
  template <class T>
  requires std::is_arithmetic_v<T>
  void get(T& value) {
    std::array<char, sizeof(T)> raw{};
    ok_ = ok_ && bytes_.size() >= sizeof(T);
    if (!ok_) return;
    std::memcpy(raw.data(), bytes_.data(), sizeof(T));
    bytes_.remove_prefix(sizeof(T));
    if constexpr (std::same_as<T, bool>) {
      ok_ = raw[0] == 0 || raw[0] == 1;
      value = raw[0] == 1;
    } else {
      std::memcpy(&value, raw.data(), sizeof(T));
    }
  }
  template <class T>
  requires std::is_enum_v<T>
  void get(T& value) {
    std::uint8_t raw = 0;
    get(raw);
    value = static_cast<T>(raw);
  }
  template <class T, std::size_t N>
  void get(std::array<T, N>& values) {
    for (T& value : values) get(value);
  }
  template <class T>
  void get(std::vector<T>& values) {
    std::uint64_t count = 0;
    get(count);
    values.clear();
    // Every element takes at least a byte, so a false count ends with the bytes; nothing is reserved on its word.
    for (std::uint64_t i = 0; i < count && ok_; ++i) get(values.emplace_back());
  }
  template <class T>
  requires std::is_class_v<T>
  void get(T& value) { fields(*this, value); }

  std::string_view bytes_;
  bool ok_ = true;
};

// The structured bindings name every member, so that a changed struct does not compile until the format follows.
template <class Archive, class T>
requires std::same_as<std::remove_const_t<T>, StitchContact>
void fields(Archive& archive, T& contact) {
  auto& [q0, q1, q4, q5, q2, q3, u_visit, v_visit, sign, kind, side, stitch, owned] = contact;
  archive(q0, q1, q4, q5, q2, q3, u_visit, v_visit, sign, kind, side, stitch, owned);
}

template <class Archive, class T>
requires std::same_as<std::remove_const_t<T>, Stitch>
void fields(Archive& archive, T& loop) {
  auto& [course, wale, kind, base_left, base_right, head_left, head_right, node] = loop;
  archive(course, wale, kind, base_left, base_right, head_left, head_right, node);
}

template <class Archive, class T>
requires std::same_as<std::remove_const_t<T>, Topology>
void fields(Archive& archive, T& topology) {
  auto& [num_nodes, num_bodies, yarn_first, visit_node, visit_slides, visit_owned, visit_extra, segment_kind, rest_arc,
         yarn_material, density_scale, contacts, stitches, num_courses, num_wales] = topology;
  archive(num_nodes, yarn_first, visit_node, visit_slides, visit_owned, segment_kind, rest_arc, yarn_material,
          density_scale, contacts, stitches, num_courses, num_wales, num_bodies, visit_extra);
}

template <class Archive, class T>
requires std::same_as<std::remove_const_t<T>, YarnMaterial>
void fields(Archive& archive, T& yarn) {
  auto& [radius_m, linear_density_kg_per_m, stretch_n, bending_nm2] = yarn;
  archive(radius_m, linear_density_kg_per_m, stretch_n, bending_nm2);
}

template <class Archive, class T>
requires std::same_as<std::remove_const_t<T>, LengthKeyframe>
void fields(Archive& archive, T& keyframe) {
  auto& [t, factor] = keyframe;
  archive(t, factor);
}

template <class Archive, class T>
requires std::same_as<std::remove_const_t<T>, FrameHeader>
void fields(Archive& archive, T& header) {
  auto& [topology, yarn, frames_per_s, num_frames, shrinkage] = header;
  archive(topology, yarn, frames_per_s, num_frames, shrinkage);
}

}  // namespace

std::string encode_header(const FrameHeader& header) {
  Encoder encoder;
  encoder(header);
  return encoder.take();
}

Result<FrameHeader> decode_header(std::string_view bytes) {
  FrameHeader header;
  Decoder decoder(bytes);
  decoder(header);
  if (!decoder.complete()) return Result<FrameHeader>::failed("the header is not what its length says");
  if (std::string why = header_flaw(header); !why.empty()) return Result<FrameHeader>::failed(std::move(why));
  return Result<FrameHeader>::of(std::move(header));
}

}  // namespace slipstitch
