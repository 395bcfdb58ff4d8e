// SPDX-License-Identifier: MIT
#include "run_dir/run_json.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <type_traits>

namespace slipstitch {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 3> kStatusWords{"succeeded", "failed", "cancelled"};

void fields(auto& visit, auto& force) requires std::is_same_v<std::remove_cvref_t<decltype(force)>, HandleForce> {
  visit("reaction_n", force.reaction_n);
  visit("max_reaction_n", force.max_reaction_n);
  visit("max_reaction_t_s", force.max_reaction_t_s);
}

void fields(auto& visit, auto& verdict) requires std::is_same_v<std::remove_cvref_t<decltype(verdict)>, EffectVerdict> {
  visit("effect", verdict.effect);
  visit("kept", verdict.kept);
  visit("why", verdict.why);
  visit("difference_m", verdict.difference_m);
}

void fields(auto& visit, auto& choice) requires std::is_same_v<std::remove_cvref_t<decltype(choice)>, EffectChoice> {
  visit("window_s", choice.window_s);
  visit("tolerance_m", choice.tolerance_m);
  visit("wall_s", choice.wall_s);
  visit("verdicts", choice.verdicts);
}

void fields(auto& visit, auto& budget) requires std::is_same_v<std::remove_cvref_t<decltype(budget)>, BudgetReport> {
  visit("budget_s", budget.budget_s);
  visit("kept", budget.kept);
  visit("same_tolerance_m", budget.same_tolerance_m);
  visit("loosest_tolerance_m", budget.loosest_tolerance_m);
  visit("share_at_loosest", budget.share_at_loosest);
}

void fields(auto& visit, auto& body) requires std::is_same_v<std::remove_cvref_t<decltype(body)>, BodyMotion> {
  visit("collider", body.collider);
  visit("position_m", body.position_m);
  visit("velocity_m_per_s", body.velocity_m_per_s);
}

void fields(auto& visit, auto& study) requires std::is_same_v<std::remove_cvref_t<decltype(study)>, StudyWork> {
  visit("quick", study.quick);
  visit("budget_s", study.budget_s);
}

void fields(auto& visit, auto& cost) requires std::is_same_v<std::remove_cvref_t<decltype(cost)>, EffectCost> {
  visit("dofs", cost.dofs);
  visit("stencils", cost.stencils);
  visit("bytes", cost.bytes);
  visit("nonzeros", cost.nonzeros);
  visit("evaluations", cost.evaluations);
  visit("searches", cost.searches);
}

class JsonWriter {
 public:
  template <class T>
  void operator()(const char* key, const T& value) {
    json_[key] = as_json(value);
  }
  template <class T>
  void if_there(const char* key, const T& value) {
    (*this)(key, value);
  }
  template <class T>
  void if_known(const char* key, const T& value, bool known) {
    json_[key] = known ? as_json(value) : Json(nullptr);
  }
  Json take() { return std::move(json_); }

 private:
  static Json as_json(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
  static Json as_json(RunStatus value) { return status_word(value); }
  template <class T>
  static Json as_json(const std::optional<T>& value) {
    return value ? as_json(*value) : Json(nullptr);
  }
  template <class T>
  static Json as_json(const std::map<std::string, T>& values) {
    Json json = Json::object();
    for (const auto& [key, value] : values) json[key] = as_json(value);
    return json;
  }
  static Json as_json(const Vec3& vector) { return {as_json(vector[0]), as_json(vector[1]), as_json(vector[2])}; }
  template <class T>
  static Json as_json(const std::vector<T>& values) {
    Json json = Json::array();
    for (const T& value : values) json.push_back(as_json(value));
    return json;
  }
  static Json as_json(const HandleForce& value) { return as_object(value); }
  static Json as_json(const BodyMotion& value) { return as_object(value); }
  static Json as_json(const EffectCost& value) { return as_object(value); }
  static Json as_json(const EffectVerdict& value) { return as_object(value); }
  static Json as_json(const EffectChoice& value) { return as_object(value); }
  static Json as_json(const StudyWork& value) { return as_object(value); }
  static Json as_json(const BudgetReport& value) { return as_object(value); }
  template <class T>
  static Json as_object(const T& value) {
    JsonWriter writer;
    fields(writer, value);
    return writer.take();
  }
  template <class T>
  static Json as_json(const T& value) {
    return value;
  }

  Json json_ = Json::object();
};

class JsonReader {
 public:
  explicit JsonReader(const nlohmann::json& json) : json_(json) {}

  template <class T>
  void operator()(const char* key, T& value) {
    const auto found = json_.find(key);
    if (found == json_.end() || !from_json(*found, value)) {
      if (error_.empty()) error_ = std::string(key) + (found == json_.end() ? " is missing" : " has the wrong type");
    }
  }
  /// What programs before it did not write.
  template <class T>
  void if_there(const char* key, T& value) {
    if (json_.contains(key)) (*this)(key, value);
  }
  template <class T>
  void if_known(const char* key, T& value, bool) {
    const auto found = json_.find(key);
    if (found == json_.end() || !found->is_null()) (*this)(key, value);
  }
  const std::string& error() const { return error_; }

 private:
  static bool from_json(const nlohmann::json& json, double& value) {
    if (!json.is_number() && !json.is_null()) return false;
    value = json.is_null() ? std::nan("") : json.get<double>();
    return true;
  }
  static bool from_json(const nlohmann::json& json, std::string& value) {
    return json.is_string() && (value = json.get<std::string>(), true);
  }
  static bool from_json(const nlohmann::json& json, RunStatus& value) {
    const auto status = json.is_string() ? status_from_word(json.get<std::string>()) : std::nullopt;
    return status && (value = *status, true);
  }
  template <class T>
  requires std::is_integral_v<T>
  static bool from_json(const nlohmann::json& json, T& value) {
    return json.is_number_integer() && (value = json.get<T>(), true);
  }
  template <class T>
  static bool from_json(const nlohmann::json& json, std::optional<T>& value) {
    value.reset();
    if (json.is_null()) return true;
    T read{};
    const bool ok = from_json(json, read);
    value = std::move(read);
    return ok;
  }
  static bool from_json(const nlohmann::json& json, bool& value) {
    return json.is_boolean() && (value = json.get<bool>(), true);
  }
  template <class T>
  static bool from_json(const nlohmann::json& json, std::vector<T>& values) {
    bool ok = json.is_array();
    for (std::size_t i = 0; ok && i < json.size(); ++i) ok = from_json(json[i], values.emplace_back());
    return ok;
  }
  static bool from_json(const nlohmann::json& json, Vec3& vector) {
    if (!json.is_array() || json.size() != 3) return false;
    return from_json(json[0], vector[0]) && from_json(json[1], vector[1]) && from_json(json[2], vector[2]);
  }
  static bool from_json(const nlohmann::json& json, HandleForce& value) { return from_object(json, value); }
  static bool from_json(const nlohmann::json& json, BodyMotion& value) { return from_object(json, value); }
  static bool from_json(const nlohmann::json& json, EffectCost& value) { return from_object(json, value); }
  static bool from_json(const nlohmann::json& json, EffectVerdict& value) { return from_object(json, value); }
  static bool from_json(const nlohmann::json& json, EffectChoice& value) { return from_object(json, value); }
  static bool from_json(const nlohmann::json& json, StudyWork& value) { return from_object(json, value); }
  static bool from_json(const nlohmann::json& json, BudgetReport& value) { return from_object(json, value); }
  template <class T>
  static bool from_object(const nlohmann::json& json, T& value) {
    if (!json.is_object()) return false;
    JsonReader reader(json);
    fields(reader, value);
    return reader.error().empty();
  }
  template <class T>
  static bool from_json(const nlohmann::json& json, std::map<std::string, T>& values) {
    if (!json.is_object()) return false;
    for (const auto& [key, value] : json.items()) {
      if (!from_json(value, values[key])) return false;
    }
    return true;
  }

  const nlohmann::json& json_;
  std::string error_;
};

void fields(auto& visit, auto& job) requires std::is_same_v<std::remove_cvref_t<decltype(job)>, JobInfo> {
  visit("name", job.name);
  visit("request_id", job.request_id);
  visit("spec_hash", job.spec_hash);
  visit("threads", job.threads);
  visit("blas", job.blas);
  visit("create_time", job.create_time);
  visit("scene_name", job.scene_name);
  visit.if_there("study", job.study);
}

void fields(auto& visit, auto& info) requires std::is_same_v<std::remove_cvref_t<decltype(info)>, ProgressInfo> {
  auto& progress = info.progress;
  visit("t", progress.t);
  visit("duration_s", progress.duration_s);
  visit("frames", progress.frames);
  visit("num_frames", progress.num_frames);
  visit("steps", progress.steps);
  visit("newton_iterations", progress.newton_iterations);
  visit("step_s", progress.step_s);
  visit("residual", progress.residual);
  visit("error_estimate_m", progress.error_estimate_m);
  visit("wall_s", progress.wall_s);
  visit("eta_s", info.eta_s);
  visit("update_time", info.update_time);
  visit.if_there("share_done", info.share_done);
  visit.if_there("doing", info.doing);
  visit.if_there("wall_by_phase_s", progress.wall_by_phase_s);
  visit.if_there("budget_s", progress.budget_s);
}

void fields(auto& visit, auto& worker) requires std::is_same_v<std::remove_cvref_t<decltype(worker)>, WorkerInfo> {
  visit("pid", worker.pid);
  visit("start_ticks", worker.start_ticks);
  visit("boot_id", worker.boot_id);
  visit("handle", worker.handle);
}

void fields(auto& visit, auto& summary) requires std::is_same_v<std::remove_cvref_t<decltype(summary)>, RunSummary> {
  const bool made = summary.nodes > 0;  // the fabric, and with it all that is told of it
  visit("status", summary.status);
  visit("message", summary.message);
  visit("scene", summary.scene);
  visit.if_known("loops", summary.loops, made);
  visit.if_known("nodes", summary.nodes, made);
  visit.if_known("dofs", summary.dofs, made);
  visit.if_known("nonzeros", summary.nonzeros, made);
  visit.if_known("effects", summary.effects, made);
  visit("effect_choice", summary.effect_choice);
  visit("effect_cost", summary.effect_cost);
  visit("sim_time_s", summary.sim_time_s);
  visit("wall_s", summary.wall_s);
  visit("frames", summary.frames);
  visit("steps", summary.steps);
  visit("rejected_steps", summary.rejected_steps);
  visit("newton_iterations", summary.newton_iterations);
  visit("linear_iterations", summary.linear_iterations);
  visit("cg_iterations", summary.cg_iterations);
  visit("factorizations", summary.factorizations);
  visit("convex_hessians", summary.convex_hessians);
  visit("wall_by_phase_s", summary.wall_by_phase_s);
  visit("energy_j", summary.energy_j);
  visit("residual", summary.residual);
  visit.if_known("residual_unit", summary.residual_unit, made);
  visit("error_estimate_m", summary.error_estimate_m);
  visit("predictable_until_s", summary.predictable_until_s);
  visit.if_there("budget", summary.budget);
  visit("min_arc_gap_ratio", summary.min_arc_gap_ratio);
  visit("max_stretch", summary.max_stretch);
  visit("max_slid_m", summary.max_slid_m);
  visit("mean_slid_m", summary.mean_slid_m);
  visit("faded_wrap_share", summary.faded_wrap_share);
  visit("faded_wrap_share_interior", summary.faded_wrap_share_interior);
  visit("wrap_ridge_entries", summary.wrap_ridge_entries);
  visit("wrap_fade_entries", summary.wrap_fade_entries);
  visit("crushed_entries", summary.crushed_entries);
  visit("self_collision_start_overlaps", summary.self_collision_start_overlaps);
  visit("handles", summary.handles);
  visit("bodies", summary.bodies);
  visit("peak_memory_bytes", summary.peak_memory_bytes);
  visit.if_known("state_hash", summary.state_hash, made);
  visit.if_known("linear_solver", summary.linear_solver, made);
  visit("blas", summary.blas);
  visit("threads", summary.threads);
  visit("version", summary.version);
}

template <class T>
Json write_fields(const T& value) {
  JsonWriter writer;
  fields(writer, value);
  return writer.take();
}

template <class T>
Result<T> read_fields(std::string_view text) {
  const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_object()) return Result<T>::failed("not a JSON object");
  T value;
  JsonReader reader(json);
  fields(reader, value);
  return reader.error().empty() ? Result<T>::of(std::move(value)) : Result<T>::failed(reader.error());
}

}  // namespace

Json to_json(const JobInfo& job) { return write_fields(job); }
Json to_json(const ProgressInfo& progress) { return write_fields(progress); }
Json to_json(const WorkerInfo& worker) { return write_fields(worker); }
Json to_json(const RunSummary& summary) { return write_fields(summary); }

Json empty_summary() {
  Json json = to_json(RunSummary{});
  for (auto& [key, value] : json.items()) value = nullptr;
  return json;
}

Json to_json(const StudySummary& summary) {
  Json json = empty_summary();
  json["status"] = status_word(summary.status);
  json["message"] = summary.message;
  json["scene"] = summary.scene;
  json["wall_s"] = summary.wall_s;
  if (summary.peak_memory_bytes) json["peak_memory_bytes"] = *summary.peak_memory_bytes;
  json["blas"] = summary.blas;
  json["version"] = summary.version;
  json["threads"] = summary.threads;
  json["study"] = summary.study;
  return json;
}

Result<JobInfo> job_from_json(std::string_view text) { return read_fields<JobInfo>(text); }
Result<ProgressInfo> progress_from_json(std::string_view text) {
  Result<ProgressInfo> info = read_fields<ProgressInfo>(text);
  if (info && info->doing.empty()) info->share_done = share_done(info->progress);  // of an earlier program
  return info;
}
Result<WorkerInfo> worker_from_json(std::string_view text) { return read_fields<WorkerInfo>(text); }
Result<RunSummary> summary_from_json(std::string_view text) { return read_fields<RunSummary>(text); }

std::string_view status_word(RunStatus status) { return kStatusWords[static_cast<std::size_t>(status)]; }

std::optional<RunStatus> status_from_word(std::string_view word) {
  for (std::size_t i = 0; i < kStatusWords.size(); ++i) {
    if (kStatusWords[i] == word) return static_cast<RunStatus>(i);
  }
  return std::nullopt;
}

std::string utc_now() {
  using namespace std::chrono;
  const auto micros = duration_cast<microseconds>(system_clock::now().time_since_epoch()).count();
  const std::time_t seconds = static_cast<std::time_t>(micros / 1'000'000);
  std::tm utc{};
  ::gmtime_r(&seconds, &utc);
  std::array<char, 32> date{};
  std::strftime(date.data(), date.size(), "%Y-%m-%dT%H:%M:%S", &utc);
  std::array<char, 16> fraction{};
  std::snprintf(fraction.data(), fraction.size(), ".%06dZ", static_cast<int>(micros % 1'000'000));
  return std::string(date.data()) + fraction.data();
}

double share_done(const Progress& progress) {
  if (progress.duration_s > 0.0) return std::clamp(progress.t / progress.duration_s, 0.0, 1.0);
  return progress.num_frames > 0 ? std::min(1.0, static_cast<double>(progress.frames) / progress.num_frames) : 0.0;
}

ProgressInfo progress_info(const Progress& progress) {
  return {progress, estimate_eta(progress), utc_now(), share_done(progress),
          progress.doing.empty() ? "simulating" : progress.doing};
}

std::optional<double> estimate_eta(const Progress& progress) {
  if (progress.budget_s && *progress.budget_s > progress.wall_s) return *progress.budget_s - progress.wall_s;
  if (!(progress.t > 0.0) || !(progress.duration_s >= progress.t)) return std::nullopt;
  return (progress.wall_s - progress.before_s) * (progress.duration_s - progress.t) / progress.t;
}

}  // namespace slipstitch
