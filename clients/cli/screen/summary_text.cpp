// SPDX-License-Identifier: MIT
#include "cli/screen/summary_text.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "cli/screen/text.h"

namespace slipstitch {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kValueWidth = 66;

std::optional<double> number(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_number() ? std::optional(found->get<double>()) : std::nullopt;
}

std::string text(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

long whole(std::optional<double> value) { return static_cast<long>(value.value_or(0.0)); }

std::string joined(const std::vector<std::string>& parts) {
  std::string line;
  for (const std::string& part : parts) line += (line.empty() || part.empty() ? "" : ", ") + part;
  return line;
}

std::string lines(const std::vector<std::string>& parts) {
  std::string all;
  for (const std::string& line : wrap_list(parts, kValueWidth)) all += (all.empty() ? "" : "\n") + line;
  return all;
}

std::string size_line(const Json& json) {
  std::vector<std::string> parts;
  if (const auto loops = number(json, "loops"); loops && *loops > 0) {
    parts.push_back(count_of(whole(loops), "loop", "loops"));
  }
  if (const auto nodes = number(json, "nodes")) parts.push_back(count_of(whole(nodes), "node", "nodes"));
  if (const auto dofs = number(json, "dofs")) parts.push_back(count_of(whole(dofs), "unknown", "unknowns"));
  return joined(parts);
}

std::string effects_line(const Json& json) {
  const auto found = json.find("effects");
  if (found == json.end() || !found->is_array()) return {};
  std::vector<std::string> names;
  for (const Json& name : *found) {
    if (name.is_string()) names.push_back(name.get<std::string>());
  }
  return names.empty() ? "none" : lines(names);
}

// What a scene with effects.auto left out, and what was looked at.
std::string choice_lines(const Json& json) {
  const auto found = json.find("effect_choice");
  if (found == json.end() || !found->is_object()) return {};
  const auto verdicts = found->find("verdicts");
  if (verdicts == found->end() || !verdicts->is_array()) return {};
  std::string all;
  for (const Json& verdict : *verdicts) {
    if (verdict.value("kept", true)) continue;
    all += text(verdict, "effect") + ": " + text(verdict, "why");
    if (const auto moved = number(verdict, "difference_m")) all += " (" + metres_text(*moved) + ")";
    all += "\n";
  }
  const auto window = number(*found, "window_s"), tolerance = number(*found, "tolerance_m");
  return (all.empty() ? "nothing; " : all) + "as seen in the first " + short_number(window.value_or(0.0)) + " s, to " +
         metres_text(tolerance.value_or(0.0)) + "; no guarantee for later\n(choosing took " +
         duration_text(number(*found, "wall_s").value_or(0.0)) + ")";
}

std::string time_line(const Json& json) {
  const auto time = number(json, "sim_time_s");
  if (!time) return {};
  std::string line = short_number(*time, 6) + " s";
  if (const auto steps = number(json, "steps")) line += " in " + count_of(whole(steps), "step", "steps");
  if (const auto rejected = number(json, "rejected_steps"); rejected && *rejected > 0) {
    line += " (" + thousands(whole(rejected)) + " more rejected)";
  }
  if (const auto frames = number(json, "frames")) line += ", " + count_of(whole(frames), "frame", "frames");
  return line;
}

std::string newton_line(const Json& json) {
  const auto iterations = number(json, "newton_iterations");
  if (!iterations) return {};
  std::string line = count_of(whole(iterations), "iteration", "iterations");
  const auto steps = number(json, "steps");
  if (steps && *steps > 0) line += ", " + short_number(*iterations / *steps, 2) + " a step";
  const std::string unit = text(json, "residual_unit");
  if (const auto residual = number(json, "residual")) {
    line += "; largest residual " + short_number(*residual, 2) + (unit.empty() ? "" : " " + unit);
  }
  return line;
}

std::string error_line(const Json& json) {
  const auto error = number(json, "error_estimate_m");
  if (!error) return {};
  const auto until = number(json, "predictable_until_s");
  return "of positions at frames about " + metres_text(*error) + ", by the run's own estimate" +
         (until ? "\nnot predictable to the tolerance beyond " + short_number(*until) + " s" : "");
}

// What a run with a budget made of it.
std::string budget_lines(const Json& json) {
  const auto budget = json.find("budget");
  if (budget == json.end() || !budget->is_object()) return {};
  const auto asked = number(*budget, "budget_s"), wall = number(json, "wall_s");
  if (!asked || !wall) return {};
  std::string text = duration_text(*wall) + " of " + duration_text(*asked);
  const auto same = number(*budget, "same_tolerance_m");
  if (same) text += ", as a tolerance of about " + metres_text(*same) + " takes";
  const auto loosest = number(*budget, "loosest_tolerance_m");
  if (budget->value("kept", true) || !loosest) return text;
  return text + "\nnot kept: it goes no looser than to " + metres_text(*loosest) + ", at which " +
         percent_text(number(*budget, "share_at_loosest").value_or(0.0)) + " of the motion ran";
}

// Of a study, whose report has the rest.
std::string study_lines(const Json& json) {
  const auto study = json.find("study");
  if (study == json.end() || !study->is_object()) return {};
  long ways = 0;
  for (const Json& rung : study->value("rungs", Json::array())) ways += rung.contains("wall_s");
  std::string text = count_of(ways, "way", "ways") + " to run it";
  const Json reference = study->value("reference", Json::object());
  if (const auto error = number(reference, "error_m"))
    text += ", compared with a reference that is off by about " + metres_text(*error);
  if (const auto factor = number(*study, "digit_factor"))
    text += "\none more digit costs x" + short_number(*factor, 2) + " the time";
  return text;
}

std::string sliding_line(const Json& json) {
  const auto largest = number(json, "max_slid_m"), mean = number(json, "mean_slid_m");
  if (!largest) return {};
  return "up to " + metres_text(*largest) + (mean ? ", " + metres_text(*mean) + " on average" : "");
}

std::string wraps_line(const Json& json) {
  std::vector<std::string> parts;
  if (const auto faded = number(json, "faded_wrap_share")) parts.push_back(percent_text(*faded) + " faded");
  if (const auto inside = number(json, "faded_wrap_share_interior")) {
    parts.push_back(percent_text(*inside) + " away from the edges");
  }
  if (const auto ridge = number(json, "wrap_ridge_entries"); ridge && *ridge > 0) {
    parts.push_back(count_of(whole(ridge), "turn past pi", "turns past pi"));
  }
  return joined(parts);
}

std::string overlaps_line(const Json& json) {
  const auto overlaps = number(json, "self_collision_start_overlaps");
  if (!overlaps || *overlaps == 0.0) return {};
  return count_of(whole(overlaps), "pair of segments", "pairs of segments") +
         " overlapped at the start and kept\ntheir distance there: self_collision does not part them";
}

std::string yarn_line(const Json& json) {
  std::vector<std::string> parts;
  if (const auto stretch = number(json, "max_stretch")) {
    parts.push_back("stretched to " + percent_text(*stretch) + " at most");
  }
  if (const auto gap = number(json, "min_arc_gap_ratio")) {
    parts.push_back("closest contacts at " + percent_text(*gap) + " of rest");
  }
  if (const auto crushed = number(json, "crushed_entries"); crushed && *crushed > 0)
    parts.push_back(count_of(whole(crushed), "segment crushed", "segments crushed"));
  return joined(parts);
}

double length(const Json& vector) {
  double squares = 0.0;
  for (const Json& component : vector) squares += component.is_number() ? std::pow(component.get<double>(), 2) : 0.0;
  return std::sqrt(squares);
}

std::string handle_line(const Json& handle) {
  const auto largest = number(handle, "max_reaction_n"), when = number(handle, "max_reaction_t_s");
  const auto found = handle.find("reaction_n");
  if (!largest || !when || found == handle.end() || !found->is_array()) return {};
  return short_number(length(*found)) + " N at the end, " + short_number(*largest) + " N at most (at " +
         short_number(*when) + " s)";
}

std::string body_line(const Json& body) {
  const auto place = body.find("position_m"), velocity = body.find("velocity_m_per_s");
  if (place == body.end() || !place->is_array() || velocity == body.end() || !velocity->is_array()) return {};
  std::string line;
  for (const Json& component : *place) {
    if (!component.is_number()) return {};
    line += (line.empty() ? "" : ", ") + short_number(component.get<double>());
  }
  return "ends at " + line + " m with " + short_number(length(*velocity)) + " m/s";
}

/// A line for each of a list, four lines at most.
void add_each(const Json& json, const char* key, const std::string& one, const std::string& many,
              std::string (*line_of)(const Json&), Rows& rows) {
  constexpr std::size_t kLines = 4;
  const auto found = json.find(key);
  if (found == json.end() || !found->is_array()) return;
  const std::size_t shown = found->size() <= kLines ? found->size() : kLines - 1;
  for (std::size_t i = 0; i < shown; ++i) {
    std::string line = (*found)[i].is_object() ? line_of((*found)[i]) : std::string();
    if (!line.empty()) rows.emplace_back(one + " " + std::to_string(i), std::move(line));
  }
  const auto hidden = static_cast<long>(found->size() - shown);
  if (hidden > 0) rows.emplace_back("", count_of(hidden, "more " + one, "more " + many) + " in the JSON summary");
}

std::string wall_line(const Json& json) {
  const auto wall = number(json, "wall_s");
  if (!wall) return {};
  std::vector<std::pair<double, std::string>> phases;
  if (const auto found = json.find("wall_by_phase_s"); found != json.end() && found->is_object()) {
    for (const auto& [name, value] : found->items()) {
      if (value.is_number() && *wall > 0.0) phases.emplace_back(value.get<double>() / *wall, name);
    }
  }
  std::sort(phases.rbegin(), phases.rend());
  std::vector<std::string> parts;
  for (const auto& [share, name] : phases) parts.push_back(name + " " + percent_text(share));
  const std::string by_phase = lines(parts);
  return duration_text(*wall) + (by_phase.empty() ? "" : "\n" + by_phase);
}

std::string machine_line(const Json& json) {
  std::vector<std::string> parts;
  for (const char* key : {"linear_solver", "blas"}) {
    if (const std::string part = text(json, key); !part.empty()) parts.push_back(part);
  }
  if (const auto memory = number(json, "peak_memory_bytes")) parts.push_back(bytes_text(*memory) + " at most");
  return lines(parts);
}

}  // namespace

std::string summary_text(const Json& json, const Rows& more) {
  Rows rows;
  const auto add = [&rows](const char* name, std::string value) {
    if (!value.empty()) rows.emplace_back(name, std::move(value));
  };
  add("fabric", size_line(json));
  add("effects", effects_line(json));
  add("left out", choice_lines(json));
  add("simulated", time_line(json));
  add("Newton", newton_line(json));
  add("error", error_line(json));
  add("budget", budget_lines(json));
  add("study", study_lines(json));
  add("sliding", sliding_line(json));
  add("wraps", wraps_line(json));
  add("overlaps", overlaps_line(json));
  add("yarn", yarn_line(json));
  add_each(json, "handles", "handle", "handles", handle_line, rows);
  add_each(json, "bodies", "body", "bodies", body_line, rows);
  add("wall time", wall_line(json));
  add("machine", machine_line(json));
  rows.insert(rows.end(), more.begin(), more.end());
  const std::string scene = text(json, "scene"), status = text(json, "status");
  return (scene.empty() ? "scene" : scene) + ": " + (status.empty() ? "no result" : status) + "\n" + two_columns(rows);
}

}  // namespace slipstitch
