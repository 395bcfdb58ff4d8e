// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/command.h"
#include "cli/exit_code.h"
#include "cli/interrupt.h"
#include "cli/options.h"
#include "cli/screen/effect_table.h"
#include "cli/screen/progress_bar.h"
#include "cli/screen/text.h"
#include "jobs/worker_environment.h"
#include "platform/blas.h"
#include "report/effect_report.h"
#include "report/fabric_picture.h"
#include "run_dir/atomic_file.h"

namespace slipstitch {
namespace {

struct EffectsOptions {
  std::vector<std::string> scenes;
  Settings settings;
  std::string out;
  int rounds = 3, threads = 0;
  bool force = false, json = false;
};

std::string command_line(const EffectsOptions& options) {
  std::string line = "slipstitch effects";
  for (const std::string& scene : options.scenes) line += " " + shell_word(scene);
  for (const std::string& setting : options.settings) line += " --set " + shell_word(setting);
  line += " --out " + shell_word(options.out);
  return options.rounds == EffectsOptions{}.rounds ? line : line + " --rounds " + std::to_string(options.rounds);
}

struct NamedScene {
  Scene scene;
  std::string stem;  // of its files: that of its path, because a name may be anything
};

std::optional<std::vector<NamedScene>> load_all(const EffectsOptions& options) {
  std::vector<NamedScene> scenes;
  for (const std::string& path : options.scenes) {
    std::optional<LoadedScene> loaded = load(SceneOptions{path, options.settings});
    if (!loaded) return std::nullopt;
    NamedScene& named = scenes.emplace_back(NamedScene{std::move(loaded->scene), std::filesystem::path(path).stem()});
    if (named.scene.name.empty()) named.scene.name = named.stem;
    if (named.scene.effects.automatic) {
      complain("'" + path + "' leaves its effects to the program (effects.auto); the price list needs them listed");
      return std::nullopt;
    }
    const auto same = [&](const NamedScene& other) { return &other != &named && other.stem == named.stem; };
    if (std::any_of(scenes.begin(), scenes.end(), same)) {
      complain("two scenes are called '" + named.stem + "', and so would be their files");
      return std::nullopt;
    }
  }
  return scenes;
}

IoError make_folders(const std::filesystem::path& folder) {
  std::error_code failed;
  const std::filesystem::path pictures = (folder / plot_file({})).parent_path();
  std::filesystem::create_directories(pictures, failed);
  return failed ? "cannot make '" + pictures.string() + "': " + failed.message() : "";
}

void remove_empty_folders(const std::filesystem::path& folder) {
  std::error_code kept;  // one that is not empty
  std::filesystem::remove((folder / plot_file({})).parent_path(), kept);
  std::filesystem::remove(folder, kept);
}

IoError write_all(const std::filesystem::path& folder, const std::vector<EffectReport>& reports,
                  const std::string& command) {
  std::vector<std::pair<std::string, std::string>> files{{"effects.csv", effect_csv(reports)},
                                                         {"effects.md", effect_markdown(reports, command)},
                                                         {"effects.html", effect_page(reports, command)}};
  for (const EffectReport& report : reports) {
    files.emplace_back(plot_file(report), effect_plot(report.study));
    if (!report.picture.empty()) files.emplace_back(picture_file(report), report.picture);
  }
  for (const auto& [name, content] : files)
    if (IoError error = write_file_atomic(folder / name, content); !error.empty()) return error;
  return {};
}

PictureBodies bodies_of(const Scene& scene) {
  return {scene.effects.colliders ? scene.effects.colliders->colliders : std::vector<Collider>(), scene.duration_s};
}

class EffectsRun {
 public:
  explicit EffectsRun(const EffectsOptions& options)
      : options_(options), interrupt_([this] {
          bar_.clear();
          note("Stopping; what whole rounds measured is kept. Ctrl-C again ends at once.");
        }) {
    study_options_.rounds = options.rounds;
    study_options_.threads = options.threads > 0 ? options.threads : jobs::kDefaultThreads;
    study_options_.should_stop = [this] { return interrupt_.requested(); };
    set_blas_threads(study_options_.threads);
  }

  int go(const std::vector<NamedScene>& scenes) {
    int code = kExitDone;
    for (const NamedScene& named : scenes) {
      if (interrupt_.requested()) break;
      if (const int failed = add(named); failed != kExitDone) code = failed;
    }
    if (options_.json) std::cout << json().dump(2) << std::endl;
    if (!written_) remove_empty_folders(options_.out);  // or the same command is refused
    if (interrupt_.requested()) return kExitInterrupted;
    if (written_) note("Tables, plots and one page of all are in '" + options_.out + "'.");
    return code;
  }

 private:
  int add(const NamedScene& named) {
    study_options_.on_progress = [&](double share, const std::string& what) {
      bar_.show_share(share, named.scene.name + ", " + what);
    };
    EffectStudy study = study_effects(named.scene, study_options_);
    bar_.clear();
    if (!study.failure.empty()) {
      complain(study.scene + " does not run: " + study.failure);
      return kExitFailed;
    }
    if (study.rounds == 0) return kExitDone;  // interrupted before there was anything to tell
    if (!options_.json) std::cout << effect_table(study) << std::endl;
    std::string picture = draw(named.scene);
    reports_.push_back({std::move(study), named.stem, std::move(picture)});
    const IoError error = write_all(options_.out, reports_, command_line(options_));
    written_ = error.empty();
    if (!written_) complain(error);
    return error.empty() ? kExitDone : kExitFailed;
  }

  std::string draw(const Scene& scene) {
    const auto sets = run_growing_sets(
        scene, study_options_.threads,
        [&](int done, int of) { bar_.show_share(double(done) / of, scene.name + ", picture"); },
        study_options_.should_stop);
    bar_.clear();
    return interrupt_.requested() ? std::string() : growing_picture(scene.name, sets, bodies_of(scene));
  }

  nlohmann::ordered_json json() const {
    auto studies = nlohmann::ordered_json::array();
    for (const EffectReport& report : reports_)
      studies.push_back({{"scene", report.study.scene}, {"rounds", report.study.rounds}, {"plot", plot_file(report)}});
    return {{"out", options_.out}, {"csv", "effects.csv"}, {"page", "effects.html"}, {"studies", studies}};
  }

  const EffectsOptions& options_;
  ProgressBar bar_;
  Interrupt interrupt_;
  StudyOptions study_options_;
  std::vector<EffectReport> reports_;
  bool written_ = false;
};

int effects(const EffectsOptions& options) {
  const auto scenes = load_all(options);
  if (!scenes || refuse_occupied(options.out, options.force)) return kExitBadInput;
  if (const IoError error = make_folders(options.out); !error.empty()) {
    complain(error);
    return kExitFailed;
  }
  return EffectsRun(options).go(*scenes);
}

}  // namespace

Command add_effects(CLI::App& root) {
  auto options = std::make_shared<EffectsOptions>();
  CLI::App* app =
      root.add_subcommand("effects", "Run scenes with and without every effect: what each changes and costs");
  app->add_option("SCENE", options->scenes, "Scene files")->type_name("")->required();
  add_settings_option(*app, options->settings);
  app->add_option("--out", options->out, "Folder for tables, plots and page, new or empty")
      ->type_name("DIR")
      ->required();
  app->add_option("--rounds", options->rounds, "Times that everything is run, default 3")
      ->type_name("COUNT")
      ->check(CLI::Range(1, 100).description(""));
  app->add_flag("--force", options->force, "Write into a directory that is not empty");
  add_threads_option(*app, options->threads);
  add_json_flag(*app, options->json);
  return {app, [options] { return effects(*options); }};
}

}  // namespace slipstitch
