// SPDX-License-Identifier: MIT
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
#include "run_dir/study_dir.h"
#include "scene_io/spec_hash.h"
#include "studies/run_study.h"
#include "studies/study_json.h"

namespace slipstitch {
namespace {

struct StudyCommandOptions {
  SceneOptions scene;
  std::string out;
  double budget_s = 0.0;
  int threads = 0;
  bool quick = false, force = false, json = false;
};

std::string study_command_line(const StudyCommandOptions& options) {
  std::string line = "slipstitch study " + shell_word(options.scene.scene);
  for (const std::string& setting : options.scene.settings) line += " --set " + shell_word(setting);
  line += " --out " + shell_word(options.out);
  if (options.quick) line += " --quick";
  if (options.budget_s > 0.0) line += " --budget " + short_number(options.budget_s, 9);
  if (options.threads > 0) line += " --threads " + std::to_string(options.threads);
  return line;
}

nlohmann::ordered_json command_json(const StudyCommandOptions& options, const WorkPrecision& study) {
  nlohmann::ordered_json json{{"out", options.out}};
  json.update(study_json(study));
  return json;
}

class StudyCommandRun {
 public:
  StudyCommandRun(const StudyCommandOptions& options, StudyDir& dir, int threads)
      : options_(options), dir_(dir), interrupt_([this] {
          bar_.clear();
          note("Stopping; what has been run is kept. Ctrl-C again ends at once.");
        }) {
    order_.work = {options.quick, options.budget_s};
    order_.threads = threads;
    order_.report = options.out;
    order_.command = study_command_line(options);
    order_.should_stop = [this] { return interrupt_.requested(); };
  }

  int go(Scene scene) {
    order_.on_progress = [this, name = scene.name](double share, const std::string& what) {
      bar_.show_share(share, name + ", " + what);
    };
    const StudyEnd end = run_study(std::move(scene), dir_, order_);
    bar_.clear();
    const int code = end.study.stopped ? interrupted() : report(end);
    if (options_.json) std::cout << command_json(options_, end.study).dump(2) << std::endl;
    return code;
  }

 private:
  int interrupted() const {
    note(count_of(dir_.num_runs(), "result is", "results are") + " kept in '" + options_.out +
         "'; the same command goes on from there.");
    return kExitInterrupted;
  }

  int report(const StudyEnd& end) {
    if (end.study.failure.empty() && !options_.json) std::cout << study_table(end.study) << std::endl;
    if (end.reported) note("Table, plots and one page of all are in '" + options_.out + "'.");
    const std::string problem = why_failed(end);
    if (problem.empty()) return kExitDone;
    complain(problem);
    return kExitFailed;
  }

  const StudyCommandOptions& options_;
  StudyDir& dir_;
  ProgressBar bar_;
  Interrupt interrupt_;
  StudyOrder order_;
};

int study(const StudyCommandOptions& options) {
  std::optional<LoadedScene> loaded = load(options.scene);
  if (!loaded) return kExitBadInput;
  const int threads = options.threads > 0 ? options.threads : jobs::kDefaultThreads;
  set_blas_threads(threads);
  StudyDir dir(options.out, {message_hash(loaded->message), loaded->scene.name, version_string(),
                             to_string(blas_in_use()), threads});
  const std::string refused = dir.why_refused();
  if (!refused.empty() && (!options.force || !std::filesystem::is_directory(options.out))) {
    complain(refused + "; choose another folder" +
             (std::filesystem::is_directory(options.out) ? ", or --force to write into it" : ""));
    return kExitBadInput;
  }
  if (const IoError error = dir.prepare(); !error.empty()) {
    complain(error);
    return kExitFailed;
  }
  if (loaded->scene.name.empty()) loaded->scene.name = std::filesystem::path(options.scene.scene).stem();
  return StudyCommandRun(options, dir, threads).go(std::move(loaded->scene));
}

}  // namespace

Command add_study(CLI::App& root) {
  auto options = std::make_shared<StudyCommandOptions>();
  CLI::App* app = root.add_subcommand("study", "Run a scene in many ways: what accuracy costs in time");
  add_scene_options(*app, options->scene);
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
