// SPDX-License-Identifier: MIT
#include "run_dir/study_dir.h"

#include <cstring>
#include <nlohmann/json.hpp>

#include "run_dir/atomic_file.h"
#include "run_dir/frame_record.h"
#include "run_dir/run_dir.h"
#include "run_dir/run_json.h"

namespace slipstitch {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostIdentityBytes = 1 << 16, kMostRunBytes = std::size_t{1} << 30;
constexpr std::size_t kHashDigits = 16;
constexpr const char* kIdentityFile = "study.json";

Json json_of(const StudyIdentity& identity) {
  return {{"scene_hash", identity.scene_hash},
          {"scene", identity.scene_name},
          {"version", identity.version},
          {"threads", identity.threads},
          {"blas", identity.blas}};
}

std::optional<Json> read_json(const fs::path& path, std::size_t most) {
  const Result<std::string> text = read_file(path, most);
  if (!text) return std::nullopt;
  Json json = Json::parse(*text, nullptr, false);
  return json.is_object() ? std::optional<Json>(std::move(json)) : std::nullopt;
}

std::string text_at(const Json& json, const char* key) {
  const auto found = json.find(key);
  if (found == json.end()) return "?";
  return found->is_string() ? found->get<std::string>() : found->dump();
}

/// FNV-1a, 16 hex digits.
std::string hash_of(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  std::string digits;
  for (int shift = 60; shift >= 0; shift -= 4) digits += "0123456789abcdef"[(hash >> shift) & 15U];
  return digits;
}

/// Those that keep() writes.
std::vector<fs::path> run_files(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(folder, failed)) {
    const fs::path &path = entry.path(), extension = path.extension();
    const bool ours = path.stem().string().size() == kHashDigits && (extension == ".json" || extension == ".frames");
    if (ours) files.push_back(path);
  }
  return files;
}

/// Head of the one record, then x of all frames.
std::string frames_bytes(const FrameTrace& trace) {
  std::string payload;
  for (const VecX& x : trace.x) {
    const std::size_t bytes = static_cast<std::size_t>(x.size()) * sizeof(double), at = payload.size();
    payload.resize(at + bytes);
    std::memcpy(payload.data() + at, x.data(), bytes);
  }
  const RecordHead head{RecordKind::frame, RecordEncoding::raw_f64, static_cast<std::int64_t>(trace.size()),
                        trace.t.empty() ? 0.0 : trace.t.back(), payload.size()};
  const RecordHeadBytes bytes = encode_head(head, payload.data());
  return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()) + payload;
}

bool read_frames(const std::string& bytes, FrameTrace& trace) {
  RecordHeadBytes head_bytes;
  RecordHead head;
  if (bytes.size() < head_bytes.size()) return false;
  std::memcpy(head_bytes.data(), bytes.data(), head_bytes.size());
  if (!decode_head(head_bytes, head).empty() || head.length != bytes.size() - head_bytes.size()) return false;
  const char* payload = bytes.data() + head_bytes.size();
  const std::size_t frames = trace.size();
  if (!payload_matches(head_bytes, payload, head.length) || head.index != static_cast<std::int64_t>(frames))
    return false;
  if (frames == 0 || head.length % (frames * sizeof(double)) != 0) return frames == 0 && head.length == 0;
  const std::size_t bytes_each = head.length / frames;
  for (std::size_t k = 0; k < frames; ++k) {
    VecX& x = trace.x.emplace_back(static_cast<Eigen::Index>(bytes_each / sizeof(double)));
    std::memcpy(x.data(), payload + k * bytes_each, bytes_each);
  }
  return true;
}

Json json_of(const std::string& key, const KeptRun& run) {
  return {{"run", key},
          {"wall_s", run.wall_s},
          {"memory_bytes", run.memory_bytes},
          {"t_s", run.trace.t},
          {"stored_j", run.trace.stored_j},
          {"force_n", run.trace.force_n},
          {"length_m", run.trace.length_m},
          {"summary", to_json(run.summary)}};
}

/// Throws nlohmann's exceptions for what has another type.
std::optional<KeptRun> run_of(const Json& json, const std::string& key) {
  if (json.at("run") != key) return std::nullopt;
  Result<RunSummary> summary = summary_from_json(json.at("summary").dump());
  if (!summary) return std::nullopt;
  KeptRun run;
  run.summary = std::move(*summary);
  run.wall_s = json.at("wall_s").get<std::vector<double>>();
  run.memory_bytes = json.at("memory_bytes").get<double>();
  run.trace.t = json.at("t_s").get<std::vector<double>>();
  for (const auto& [name, values] :
       {std::pair{"stored_j", &run.trace.stored_j}, std::pair{"force_n", &run.trace.force_n},
        std::pair{"length_m", &run.trace.length_m}}) {
    for (const Json& value : json.at(name)) values->push_back(value.is_null() ? std::nan("") : value.get<double>());
    if (values->size() != run.trace.size()) return std::nullopt;
  }
  return run.wall_s.empty() ? std::nullopt : std::optional<KeptRun>(std::move(run));
}

}  // namespace

std::string StudyDir::why_refused() const {
  const std::string name = "'" + path_.string() + "'";
  std::error_code error;
  const fs::file_status status = fs::status(path_, error);
  if (fs::exists(status) && !fs::is_directory(status)) return name + " exists and is not a folder";
  if (!occupied(path_)) return {};
  const std::optional<Json> there = read_json(path_ / kIdentityFile, kMostIdentityBytes);
  if (!there) return name + " is not empty, and no study is in it";
  const Json ours = json_of(identity_);
  const auto other = [&](const char* key) { return text_at(*there, key) != text_at(ours, key); };
  if (other("scene_hash")) {
    const bool same_name = !other("scene");
    return name + " holds the study of " +
           (same_name ? "this scene with other contents" : "another scene, '" + text_at(*there, "scene") + "'");
  }
  for (const char* key : {"version", "threads", "blas"})
    if (other(key))
      return name + " holds a study with " + key + " " + text_at(*there, key) + ", this one has " + text_at(ours, key);
  return {};
}

IoError StudyDir::prepare() {
  std::error_code failed;
  if (fs::exists(path_ / kIdentityFile, failed) && !why_refused().empty())
    for (const fs::path& run : run_files(runs())) fs::remove(run, failed);
  fs::create_directories(runs(), failed);
  if (failed) return "cannot make '" + runs().string() + "': " + failed.message();
  return write_file_atomic(path_ / kIdentityFile, json_of(identity_).dump(2) + "\n");
}

fs::path StudyDir::file(const std::string& key, const char* extension) const {
  return runs() / (hash_of(json_of(identity_).dump() + key) + extension);
}

std::optional<KeptRun> StudyDir::find(const std::string& key) {
  const std::optional<Json> json = read_json(file(key, ".json"), kMostRunBytes);
  if (!json) return std::nullopt;
  try {
    std::optional<KeptRun> run = run_of(*json, key);
    if (!run) return std::nullopt;
    const Result<std::string> bytes = read_file(file(key, ".frames"), kMostRunBytes);
    if (!bytes || !read_frames(*bytes, run->trace)) return std::nullopt;
    return run;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

std::string StudyDir::keep(const std::string& key, const KeptRun& run) {
  if (IoError error = write_file_atomic(file(key, ".frames"), frames_bytes(run.trace)); !error.empty()) return error;
  return write_file_atomic(file(key, ".json"), json_of(key, run).dump() + "\n");
}

int StudyDir::num_runs() const {
  int count = 0;
  for (const fs::path& run : run_files(runs())) count += run.extension() == ".json";
  return count;
}

}  // namespace slipstitch
