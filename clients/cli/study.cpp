// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/command.h"
#include "cli/exit_code.h"
#include "cli/interrupt.h"
#include "cli/options.h"
#include "cli/screen/progress_bar.h"
#include "cli/screen/study_table.h"
#include "cli/screen/text.h"
#include "jobs/worker_environment.h"
#include "platform/blas.h"
#include "platform/version.h"
#include "report/accuracy_report.h"
#include "run_dir/atomic_file.h"
#include "run_dir/study_dir.h"
#include "scene_io/spec_hash.h"
#include "studies/run_study.h"
#include "studies/study_json.h"

namespace slipstitch {
namespace {

struct StudyCommandOptions {
  std::vector<std::string> scenes;
  Settings settings;
  std::string out;
  double budget_s = 0.0;
  int threads = 0;
  bool quick = false, force = false, json = false;
};

std::string command_line(const StudyCommandOptions& options, const std::vector<std::string>& scenes,
                         const std::string& out) {
  std::string line = "slipstitch study";
  for (const std::string& scene : scenes) line += " " + shell_word(scene);
  for (const std::string& setting : options.settings) line += " --set " + shell_word(setting);
  line += " --out " + shell_word(out);
  if (options.quick) line += " --quick";
  if (options.budget_s > 0.0) line += " --budget " + short_number(options.budget_s, 9);
  if (options.threads > 0) line += " --threads " + std::to_string(options.threads);
  return line;
}

nlohmann::ordered_json command_json(const std::string& out, const WorkPrecision& study) {
  nlohmann::ordered_json json{{"out", out}};
  json.update(study_json(study));
  return json;
}

/// One of the scenes of a command, and the folder of its study.
struct StudiedScene {
  Scene scene;
  std::string path, stem, out;
  std::unique_ptr<StudyDir> dir;
};

class StudyCommandRun {
 public:
  StudyCommandRun(const StudyCommandOptions& options, int threads)
      : options_(options), interrupt_([this] {
          bar_.clear();
          note("Stopping; what has been run is kept. Ctrl-C again ends at once.");
        }) {
    order_.work.quick = options.quick;
    order_.threads = threads;
    order_.should_stop = [this] { return interrupt_.requested(); };
  }

  int go(std::vector<StudiedScene>& scenes) {
    int code = kExitDone;
    for (std::size_t k = 0; k < scenes.size() && code != kExitInterrupted; ++k) {
      order_.work.budget_s = budget_of_one(scenes.size() - k);
      if (const int failed = add(scenes[k], scenes.size() > 1); failed != kExitDone) code = failed;
    }
    if (options_.json) std::cout << (scenes.size() > 1 ? results_ : results_[0]).dump(2) << std::endl;
    return code;
  }

 private:
  /// An even share of what is left, and at least a moment, which tells that there was no time.
  double budget_of_one(std::size_t left) const {
    if (options_.budget_s == 0.0) return 0.0;
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
    return std::max(1e-3, (options_.budget_s - passed.count()) / static_cast<double>(left));
  }

  int add(StudiedScene& studied, bool of_many) {
    order_.report = studied.out;
    order_.command = command_line(options_, {studied.path}, studied.out);
    order_.on_progress = [this, name = studied.scene.name](double share, const std::string& what) {
      bar_.show_share(share, name + ", " + what);
    };
    StudyEnd end = run_study(std::move(studied.scene), *studied.dir, order_);
    bar_.clear();
    int code = end.study.stopped ? interrupted(studied) : report(end, studied);
    results_.push_back(command_json(studied.out, end.study));
    if (of_many && end.reported) {
      reported_.push_back({std::move(end.study), studied.stem});
      if (!write_overview()) code = kExitFailed;
    }
    return code;
  }

  bool write_overview() {
    const std::filesystem::path file = std::filesystem::path(options_.out) / "accuracy.md";
    const IoError error =
        write_file_atomic(file, accuracy_markdown(reported_, command_line(options_, options_.scenes, options_.out)));
    if (!error.empty()) complain(error);
    return error.empty();
  }

  int interrupted(const StudiedScene& studied) const {
    note(count_of(studied.dir->num_runs(), "result is", "results are") + " kept in '" + studied.out +
         "'; the same command goes on from there.");
    return kExitInterrupted;
  }

  int report(const StudyEnd& end, const StudiedScene& studied) {
    if (end.study.failure.empty() && !options_.json) std::cout << study_table(end.study) << std::endl;
    if (end.reported) note("Table, plots and one page of all are in '" + studied.out + "'.");
    const std::string problem = why_failed(end);
    if (problem.empty()) return kExitDone;
    complain(problem);
    return kExitFailed;
  }

  const StudyCommandOptions& options_;
  ProgressBar bar_;
  Interrupt interrupt_;
  StudyOrder order_;
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::vector<NamedStudy> reported_;
  nlohmann::ordered_json results_ = nlohmann::ordered_json::array();
};

/// None: it was said why.
std::optional<StudiedScene> load_one(const StudyCommandOptions& options, const std::string& path, int threads) {
  std::optional<LoadedScene> loaded = load({path, options.settings});
  if (!loaded) return std::nullopt;
  const std::string stem = std::filesystem::path(path).stem();
  if (loaded->scene.name.empty()) loaded->scene.name = stem;
  const std::filesystem::path folder(options.out);
  const std::string out = options.scenes.size() == 1 ? folder : folder / accuracy_folder({{}, stem});
  auto dir = std::make_unique<StudyDir>(out, StudyIdentity{message_hash(loaded->message), loaded->message.name(),
                                                           version_string(), to_string(blas_in_use()), threads});
  return StudiedScene{std::move(loaded->scene), path, stem, out, std::move(dir)};
}

/// Makes the folder; an exit code.
int prepare(const StudyCommandOptions& options, StudiedScene& studied) {
  const std::string refused = studied.dir->why_refused();
  const bool is_folder = std::filesystem::is_directory(studied.out);
  if (!refused.empty() && (!options.force || !is_folder)) {
    complain(refused + "; choose another folder" + (is_folder ? ", or --force to write into it" : ""));
    return kExitBadInput;
  }
  const IoError error = studied.dir->prepare();
  if (!error.empty()) complain(error);
  return error.empty() ? kExitDone : kExitFailed;
}

int study(const StudyCommandOptions& options) {
  const int threads = options.threads > 0 ? options.threads : jobs::kDefaultThreads;
  set_blas_threads(threads);
  std::vector<StudiedScene> scenes;
  for (const std::string& path : options.scenes) {
    std::optional<StudiedScene> studied = load_one(options, path, threads);
    if (!studied) return kExitBadInput;
    const auto same = [&](const StudiedScene& other) { return other.stem == studied->stem; };
    if (std::any_of(scenes.begin(), scenes.end(), same)) {
      complain("two scenes are called '" + studied->stem + "', and so would be their files");
      return kExitBadInput;
    }
    scenes.push_back(std::move(*studied));
  }
  for (StudiedScene& studied : scenes)
    if (const int code = prepare(options, studied); code != kExitDone) return code;
  return StudyCommandRun(options, threads).go(scenes);
}

}  // namespace

Command add_study(CLI::App& root) {
  auto options = std::make_shared<StudyCommandOptions>();
  CLI::App* app = root.add_subcommand("study", "Run a scene in many ways: what accuracy costs in time");
  app->add_option("SCENE", options->scenes, "Scenes (.json), or charts of K and P rows (.txt)")
      ->type_name("")
      ->required();
  add_settings_option(*app, options->settings);
  app->add_option("--out", options->out, "New or empty, or of this study, which goes on")->type_name("DIR")->required();
  app->add_flag("--quick", options->quick, "Fewer ways, and a coarser reference");
  app->add_option("--budget", options->budget_s, "Wall time for all; what does not fit is not run")
      ->type_name("SECONDS")
      ->check(CLI::PositiveNumber.description(""));
  app->add_flag("--force", options->force, "Write into a directory of something else");
  add_threads_option(*app, options->threads);
  add_json_flag(*app, options->json);
  return {app, [options] { return study(*options); }};
}

}  // namespace slipstitch
