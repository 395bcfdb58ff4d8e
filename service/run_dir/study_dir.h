// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "run_dir/result.h"
#include "study/run_shelf.h"

namespace slipstitch {

/// What every result of a study has in common.
struct StudyIdentity {
  std::string scene_hash, scene_name, version, blas;
  int threads = 1;
};

/// The folder of a study:
///   study.json        StudyIdentity
///   runs/KEY.json     what is kept of a run but its positions; written last: a run without it is not there
///   runs/KEY.frames   its positions, one record (frame_record.h) of all frames
/// KEY is a hash of the identity and of the run. Everything is written as a whole or not at all, so that a study goes
/// on where one before it was killed.
class StudyDir final : public RunShelf {
 public:
  StudyDir(std::filesystem::path path, StudyIdentity identity)
      : path_(std::move(path)), identity_(std::move(identity)) {}

  /// Why this is no place for the study: a file, or a folder that is not empty and not of the same identity. Empty: it
  /// is.
  std::string why_refused() const;
  /// Makes the folder. The runs in one of another identity are removed; anything else in it is left alone.
  IoError prepare();

  std::optional<KeptRun> find(const std::string& key) override;
  std::string keep(const std::string& key, const KeptRun& run) override;
  int num_runs() const;  // that are there

 private:
  std::filesystem::path runs() const { return path_ / "runs"; }
  std::filesystem::path file(const std::string& key, const char* extension) const;

  std::filesystem::path path_;
  StudyIdentity identity_;
};

}  // namespace slipstitch
