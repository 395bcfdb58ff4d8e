// SPDX-License-Identifier: MIT
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/command.h"
#include "cli/estimate.h"
#include "cli/exit_code.h"
#include "cli/options.h"
#include "cli/screen/text.h"
#include "model/effect_list.h"
#include "model/remarks.h"
#include "sim/prepare.h"
#include "study/choose_effects.h"
#include "study/reach.h"

namespace slipstitch {
namespace {

using Json = nlohmann::ordered_json;

struct ValidateOptions {
  SceneOptions scene;
  bool json = false;
};

Json to_json(const std::string& scene, const Estimate& estimate, const std::vector<std::string>& remarks) {
  const auto& memory = estimate.memory_bytes;
  const auto& wall = estimate.wall_s;
  const auto& steps = estimate.least_steps;
  return {{"valid", true},
          {"scene", scene},
          {"loops", estimate.loops},
          {"nodes", estimate.nodes},
          {"dofs", estimate.dofs},
          {"effects", estimate.effects},
          {"frames", estimate.frames},
          {"least_steps", steps ? Json(*steps) : Json()},
          {"hessian_nonzeros", estimate.hessian_nonzeros},
          {"estimated_memory_bytes", memory ? Json(static_cast<long>(*memory)) : Json()},
          {"estimated_wall_s", wall ? Json(*wall) : Json()},
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

std::string to_text(const std::string& scene, const Estimate& estimate, const std::vector<std::string>& remarks) {
  constexpr std::size_t kWidth = 66;
  std::string effects;
  for (const std::string& line : wrap_list(estimate.effects, kWidth)) effects += (effects.empty() ? "" : "\n") + line;
  const std::string loops = estimate.loops > 0 ? count_of(estimate.loops, "loop", "loops") + ", " : "";
  const auto& memory = estimate.memory_bytes;
  const auto& wall = estimate.wall_s;
  const auto& steps = estimate.least_steps;
  Rows rows{{"fabric",
             loops + count_of(estimate.nodes, "node", "nodes") + ", " + count_of(estimate.dofs, "unknown", "unknowns")},
            {"effects", effects.empty() ? "none" : effects},
            {"output", count_of(estimate.frames, "frame", "frames") + " in " +
                           (steps ? "at least " + count_of(*steps, "step", "steps") : "as many steps as it takes")},
            {"memory", memory ? "about " + bytes_text(*memory) : "not known"},
            {"time", wall ? "about " + duration_text(*wall) + ", roughly estimated from the unknowns"
                          : std::string("not known for ") + (steps ? "static solves" : "a tolerance")}};
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
  const Estimate found = estimate(loaded->scene);
  if (!found.failure.empty()) {
    complain(found.failure);
    return kExitFailed;
  }
  const std::string& name = loaded->scene.name;
  std::vector<std::string> remarks = all_remarks(loaded->scene);
  if (found.dofs == 0) remarks.push_back("handles hold every node: nothing is left to simulate");
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
  CLI::App* app = root.add_subcommand("validate", "Check a scene, estimate memory and time; run nothing");
  add_scene_options(*app, options->scene);
  add_json_flag(*app, options->json);
  return {app, [options] { return validate(*options); }};
}

}  // namespace slipstitch
