// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "run_dir/run_json.h"
#include "run_dir/study_dir.h"
#include "study/work_precision.h"

namespace slipstitch {

struct StudyOrder {
  StudyWork work;
  int threads = 1;
  std::filesystem::path report;  // folder, which is there, for study.csv, study.md, study.html and the plots
  std::string command, job;      // as in study_markdown()
  std::function<void(double share, const std::string& what)> on_progress;  // may be empty
  std::function<bool()> should_stop;  // polled every Newton iteration; may be empty
};

struct StudyEnd {
  WorkPrecision study;
  IoError error;  // of the report
  bool reported = false;
};

/// Chooses the effects of a checked scene that leaves them to the program, runs what is not in `dir` yet, and writes
/// the report unless the study was stopped or failed.
StudyEnd run_study(Scene scene, StudyDir& dir, const StudyOrder& order);

/// What keeps a study that was not stopped from being a success; empty: nothing.
std::string why_failed(const StudyEnd& end);

}  // namespace slipstitch
