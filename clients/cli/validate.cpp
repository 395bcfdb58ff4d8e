// SPDX-License-Identifier: MIT
#include <cmath>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/command.h"
#include "cli/exit_code.h"
#include "cli/options.h"
#include "cli/screen/text.h"
#include "model/effect_list.h"
#include "model/remarks.h"
#include "prediction/calibration_cache.h"
#include "sim/prepare.h"
#include "sim/simulation.h"
#include "study/choose_effects.h"
#include "study/prediction.h"
#include "study/reach.h"

namespace slipstitch {
namespace {

using Json = nlohmann::ordered_json;

struct ValidateOptions {
  SceneOptions scene;
  double budget_s = PredictOptions{}.budget_s;
  bool json = false;
};

Json to_json(const RunPrediction& run) {
  return {
      {"wall_s", run.wall_s}, {"steps", std::lround(run.steps)}, {"newton_iterations", std::lround(run.iterations)}};
}

Json to_json(const PilotBasis& basis) {
  constexpr const char* kWords[] = {"whole run", "first moments", "canned run"};
  return {{"basis", kWords[static_cast<std::size_t>(basis.basis)]},
          {"until_s", basis.until_s},
          {"tolerance_m", basis.tolerance_m > 0.0 ? Json(basis.tolerance_m) : Json()}};
}

Json tolerances_json(const Prediction& found) {
  if (found.to_tolerance.empty()) return {};
  Json runs = Json::array();
  for (const TolerancePrediction& to : found.to_tolerance) {
    Json run{{"tolerance_m", to.tolerance_m}};
    run.update(to_json(to.run));
    runs.push_back(std::move(run));
  }
  return {{"runs", runs}, {"rests_on", to_json(found.to_tolerance_basis)}};
}

Json to_json(const std::string& scene, const Prediction& found, const std::vector<std::string>& remarks) {
  const auto& run = found.as_it_is;
  const auto& steps = found.least_steps;
  return {{"valid", true},
          {"scene", scene},
          {"loops", found.loops},
          {"nodes", found.nodes},
          {"dofs", found.dofs},
          {"effects", found.effects},
          {"frames", found.frames},
          {"least_steps", steps ? Json(*steps) : Json()},
          {"hessian_nonzeros", found.hessian_nonzeros},
          {"estimated_memory_bytes", std::lround(found.memory_bytes)},
          {"estimated_wall_s", run ? Json(run->wall_s) : Json()},
          {"estimated_steps", run ? Json(std::lround(run->steps)) : Json()},
          {"estimated_newton_iterations", run ? Json(std::lround(run->iterations)) : Json()},
          {"budget_tolerance_m", found.budget_tolerance_m > 0.0 ? Json(found.budget_tolerance_m) : Json()},
          {"estimate_rests_on", run ? to_json(found.as_it_is_basis) : Json()},
          {"to_tolerance", tolerances_json(found)},
          {"remarks", remarks}};
}

/// Words in lines of at most `width` characters.
std::string wrap_words(const std::string& text, std::size_t width) {
  std::istringstream words(text);
  std::string all, line, word;
  while (words >> word) {
    if (!line.empty() && line.size() + 1 + word.size() > width) {
      all += line + "\n";
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return all + line;
}

/// What a time rests on, for people.
std::string basis_text(const PilotBasis& basis) {
  const std::string to = basis.tolerance_m > 0.0 ? " to " + metres_text(basis.tolerance_m) : "";
  switch (basis.basis) {
    case Basis::whole_run:
      return "from a whole run" + to;
    case Basis::first_moments:
      return "from the first " + short_number(basis.until_s, 2) + " s of a run" + to;
    case Basis::canned_run:
      break;
  }
  return "from the unknowns and how a small swatch runs";
}

std::string time_text(const Prediction& found) {
  if (!found.as_it_is) return "not known: a static solve takes as many iterations as it takes";
  const RunPrediction& run = *found.as_it_is;
  if (run.steps == 0.0 && run.wall_s > 0.0) return duration_text(run.wall_s) + ", as it is asked to take";
  return "about " + duration_text(run.wall_s) + " (" + count_of(std::lround(run.steps), "step", "steps") + ", " +
         count_of(std::lround(run.iterations), "Newton iteration", "Newton iterations") + "), " +
         (found.budget_tolerance_m > 0.0 ? "which is enough for " + metres_text(found.budget_tolerance_m) + ", " : "") +
         basis_text(found.as_it_is_basis);
}

std::string tolerances_text(const Prediction& found) {
  std::string text;
  for (const TolerancePrediction& to : found.to_tolerance)
    text += (text.empty() ? "about " : ", ") + duration_text(to.run.wall_s) + " to " + metres_text(to.tolerance_m);
  return text + ", " + basis_text(found.to_tolerance_basis);
}

std::string to_text(const std::string& scene, const Prediction& found, const std::vector<std::string>& remarks) {
  constexpr std::size_t kWidth = 66;
  std::string effects;
  for (const std::string& line : wrap_list(found.effects, kWidth)) effects += (effects.empty() ? "" : "\n") + line;
  const std::string loops = found.loops > 0 ? count_of(found.loops, "loop", "loops") + ", " : "";
  const auto& steps = found.least_steps;
  Rows rows{
      {"fabric", loops + count_of(found.nodes, "node", "nodes") + ", " + count_of(found.dofs, "unknown", "unknowns")},
      {"effects", effects.empty() ? "none" : effects},
      {"output", count_of(found.frames, "frame", "frames") + " in " +
                     (steps ? "at least " + count_of(*steps, "step", "steps") : "as many steps as it takes")},
      {"memory", "about " + bytes_text(found.memory_bytes)},
      {"time", wrap_words(time_text(found), kWidth)}};
  if (!found.to_tolerance.empty()) rows.emplace_back("accuracy", wrap_words(tolerances_text(found), kWidth));
  for (const std::string& remark : remarks) rows.emplace_back("note", wrap_words(remark, kWidth));
  return scene + ": valid\n" + two_columns(rows);
}

/// Also those that take a model to see.
std::vector<std::string> all_remarks(const Scene& given) {
  const Scene scene = with_candidates(given);
  std::vector<std::string> remarks;
  if (given.effects.automatic)
    remarks.push_back("effects.auto: the run begins by choosing which of these effects it needs");
  for (std::string& remark : remarks_on(scene)) remarks.push_back(std::move(remark));
  if (!scene.effects.colliders) return remarks;
  Scene acting = scene;  // what cannot matter does no work on the fabric either
  for (const IdleEffect& idle : idle_effects(scene))
    if (idle.effect != "colliders") remove_effect(acting.effects, *find_effect(idle.effect));
  Prepared prepared = prepare(acting);
  if (prepared.failure) return remarks;
  Simulation simulation(std::move(prepared.model));
  const RunSpan span = span_of(acting);
  const std::vector<int> never = colliders_out_of_reach(simulation, bound_reach(simulation, span), span);
  const Reach stretched = reach_at_twice_its_length(simulation, span);
  const auto remark = [&](int i, const char* text) {
    remarks.push_back("effects.colliders.colliders[" + std::to_string(i) + "] " + text);
  };
  for (const int i : never)
    remark(i, "cannot matter here: a bound on the energy shows that the fabric never reaches it");
  if (never.size() == scene.effects.colliders->colliders.size()) {
    acting.effects.colliders.reset();
    for (const std::string& text : remarks_on(acting))
      if (text.starts_with("effects.colliders is probably missing"))
        remarks.push_back("effects.colliders has none within reach: " + text.substr(text.find(": ") + 2));
  }
  for (const int i : colliders_out_of_reach(simulation, stretched, span))
    if (std::find(never.begin(), never.end(), i) == never.end())
      remark(i, "probably cannot matter here: yarn would have to be stretched to twice its length to reach it");
  return remarks;
}

int validate(const ValidateOptions& options) {
  const std::optional<LoadedScene> loaded = load(options.scene);
  if (!loaded) return kExitBadInput;
  PredictOptions predicting;
  predicting.calibration = &machine_calibration();
  predicting.budget_s = options.budget_s;
  const Prediction found = predict(loaded->scene, predicting);
  if (!found.failure.empty()) {
    complain(found.failure);
    return kExitFailed;
  }
  const std::string& name = loaded->scene.name;
  std::vector<std::string> remarks = all_remarks(loaded->scene);
  if (found.dofs == 0) remarks.push_back("handles hold every node: nothing is left to simulate");
  if (!found.run_fails.empty()) remarks.push_back("the run fails: " + found.run_fails);
  if (options.json) {
    std::cout << to_json(name, found, remarks).dump(2) << std::endl;
  } else {
    std::cout << to_text(name.empty() ? options.scene.scene : name, found, remarks) << std::flush;
  }
  return kExitDone;
}

}  // namespace

Command add_validate(CLI::App& root) {
  auto options = std::make_shared<ValidateOptions>();
  CLI::App* app = root.add_subcommand("validate", "Check a scene, predict its memory and time from its first moments");
  add_scene_options(*app, options->scene);
  app->add_option("--budget", options->budget_s, "Wall time to try the scene in, default: 2")
      ->type_name("SECONDS")
      ->check(CLI::Range(0.0, 600.0).description(""));
  add_json_flag(*app, options->json);
  return {app, [options] { return validate(*options); }};
}

}  // namespace slipstitch
