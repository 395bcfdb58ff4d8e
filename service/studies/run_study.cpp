// SPDX-License-Identifier: MIT
#include "studies/run_study.h"

#include <utility>
#include <vector>

#include "report/study_report.h"
#include "run_dir/atomic_file.h"
#include "study/choose_effects.h"

namespace slipstitch {
namespace {

IoError write_study(const WorkPrecision& study, const StudyOrder& order) {
  std::vector<std::pair<std::string, std::string>> files{{"study.csv", study_csv(study)},
                                                         {"study.md", study_markdown(study, order.command, order.job)},
                                                         {"study.html", study_page(study, order.command, order.job)}};
  for (const StudyAxis axis : {StudyAxis::wall_time, StudyAxis::newton_iterations})
    files.emplace_back(study_plot_file(axis), study_plot(study, axis));
  for (const auto& [name, content] : files)
    if (IoError error = write_file_atomic(order.report / name, content); !error.empty()) return error;
  return {};
}

/// False: stopped before the choice was made.
bool settle_effects(Scene& scene, const StudyOrder& order) {
  if (!scene.effects.automatic) return true;
  ChosenScene chosen = choose_effects(scene, order.threads, order.should_stop, [&](const std::string& what) {
    if (order.on_progress) order.on_progress(0.0, what);
  });
  scene = std::move(chosen.scene);
  return !chosen.cancelled;
}

}  // namespace

StudyEnd run_study(Scene scene, StudyDir& dir, const StudyOrder& order) {
  StudyEnd end;
  end.study.scene = scene.name;
  end.study.stopped = !settle_effects(scene, order);
  if (end.study.stopped) return end;
  WorkPrecisionOptions options;
  options.quick = order.work.quick;
  options.threads = order.threads;
  options.budget_s = order.work.budget_s;
  options.shelf = &dir;
  options.on_progress = order.on_progress;
  options.should_stop = order.should_stop;
  end.study = study_work_precision(scene, options);
  if (end.study.stopped || !end.study.failure.empty()) return end;
  end.error = write_study(end.study, order);
  end.reported = end.error.empty();
  return end;
}

std::string why_failed(const StudyEnd& end) {
  if (!end.study.failure.empty()) return end.study.scene + " cannot be studied: " + end.study.failure;
  if (!end.error.empty()) return end.error;
  return end.study.reference.failure.empty() ? "" : "there is no reference: " + end.study.reference.failure;
}

}  // namespace slipstitch
