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
#include "report/study_report.h"
#include "run_dir/atomic_file.h"
#include "run_dir/study_dir.h"
#include "scene_io/spec_hash.h"
#include "study/choose_effects.h"

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

IoError write_study(const StudyCommandOptions& options, const WorkPrecision& study) {
  const std::string command = study_command_line(options);
  std::vector<std::pair<std::string, std::string>> files{{"study.csv", study_csv(study)},
                                                         {"study.md", study_markdown(study, command)},
                                                         {"study.html", study_page(study, command)}};
  for (const StudyAxis axis : {StudyAxis::wall_time, StudyAxis::newton_iterations})
    files.emplace_back(study_plot_file(axis), study_plot(study, axis));
  for (const auto& [name, content] : files)
    if (IoError error = write_file_atomic(std::filesystem::path(options.out) / name, content); !error.empty())
      return error;
  return {};
}

template <class T>
nlohmann::ordered_json or_null(const std::optional<T>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

nlohmann::ordered_json rung_json(const RungResult& r) {
  nlohmann::ordered_json json{{"rung", rung_name(r.rung)}, {"method", r.rung.method}};
  if (!r.no_result.empty()) {
    json["no_result"] = r.no_result;
    return json;
  }
  json["wall_s"] = r.wall_s;
  json["newton_iterations"] = r.newton_iterations;
  json["position_error_m"] = r.errors ? nlohmann::ordered_json(r.errors->position_m) : nlohmann::ordered_json();
  json["error_estimate_m"] = or_null(r.error_estimate_m);
  for (const auto& [key, speedup] :
       {std::pair{"speedup", &r.speedup}, std::pair{"speedup_of_95_percent", &r.speedup_most}})
    json[key] = *speedup
                    ? nlohmann::ordered_json{{"factor", (*speedup)->factor}, {"extrapolated", (*speedup)->extrapolated}}
                    : nlohmann::ordered_json();
  json["on_front"] = r.on_front;
  return json;
}

nlohmann::ordered_json study_json(const StudyCommandOptions& options, const WorkPrecision& study) {
  auto rungs = nlohmann::ordered_json::array();
  for (const RungResult& result : study.rungs) rungs.push_back(rung_json(result));
  const StudyReference& reference = study.reference;
  return {{"out", options.out},
          {"csv", "study.csv"},
          {"page", "study.html"},
          {"plots", {study_plot_file(StudyAxis::wall_time), study_plot_file(StudyAxis::newton_iterations)}},
          {"scene", study.scene},
          {"finished", !study.stopped && study.failure.empty()},
          {"reference",
           {{"method", reference.method},
            {"step_s", reference.refinements > 0 ? nlohmann::ordered_json(reference.step_s) : nlohmann::ordered_json()},
            {"error_m", or_null(reference.error_m)},
            {"settled", reference.settled}}},
          {"horizon_s", or_null(study.horizon_s)},
          {"digit_factor", or_null(study.digit_factor)},
          {"rungs", rungs}};
}

class StudyCommandRun {
 public:
  StudyCommandRun(const StudyCommandOptions& options, StudyDir& dir, int threads)
      : options_(options), dir_(dir), interrupt_([this] {
          bar_.clear();
          note("Stopping; what has been run is kept. Ctrl-C again ends at once.");
        }) {
    work_.quick = options.quick;
    work_.threads = threads;
    work_.budget_s = options.budget_s;
    work_.shelf = &dir;
    work_.should_stop = [this] { return interrupt_.requested(); };
  }

  int go(Scene scene) {
    WorkPrecision study;
    if (scene.effects.automatic) {
      bar_.show("choosing the effects of " + scene.name);
      ChosenScene chosen = choose_effects(scene, work_.threads, work_.should_stop);
      study.stopped = chosen.cancelled;
      scene = std::move(chosen.scene);
    }
    work_.on_progress = [&](double share, const std::string& what) {
      bar_.show_share(share, scene.name + ", " + what);
    };
    if (!study.stopped) study = study_work_precision(scene, work_);
    bar_.clear();
    const int code = study.stopped ? interrupted() : report(study);
    if (options_.json) std::cout << study_json(options_, study).dump(2) << std::endl;
    return code;
  }

 private:
  int interrupted() const {
    note(count_of(dir_.num_runs(), "result is", "results are") + " kept in '" + options_.out +
         "'; the same command goes on from there.");
    return kExitInterrupted;
  }

  int report(const WorkPrecision& study) {
    if (!study.failure.empty()) {
      complain(study.scene + " cannot be studied: " + study.failure);
      return kExitFailed;
    }
    if (!options_.json) std::cout << study_table(study) << std::endl;
    if (const IoError error = write_study(options_, study); !error.empty()) {
      complain(error);
      return kExitFailed;
    }
    note("Table, plots and one page of all are in '" + options_.out + "'.");
    if (study.reference.failure.empty()) return kExitDone;
    complain("there is no reference: " + study.reference.failure);
    return kExitFailed;
  }

  const StudyCommandOptions& options_;
  StudyDir& dir_;
  ProgressBar bar_;
  Interrupt interrupt_;
  WorkPrecisionOptions work_;
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
