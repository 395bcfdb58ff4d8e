// SPDX-License-Identifier: MIT
#pragma once

#include <map>

#include "sim/sim_scenes.h"
#include "study/work_precision.h"

namespace slipstitch::testing {

/// A soft yarn that swings from one end for a fifth of a second: smooth, and soon run.
inline Scene smooth_swing() {
  Scene scene = hanging_yarn();
  scene.name = "swing";
  scene.yarn.stretch_n = 0.5;
  scene.effects.damping.emplace().stretch_ns = 1e-3;
  scene.duration_s = 0.1;
  scene.frames_per_s = 30.0;
  return scene;
}

/// A shelf that counts what is put on it: one run each time.
class CountingShelf final : public RunShelf {
 public:
  std::optional<KeptRun> find(const std::string& key) override {
    const auto found = runs_.find(key);
    return found == runs_.end() ? std::nullopt : std::optional<KeptRun>(found->second);
  }
  std::string keep(const std::string& key, const KeptRun& run) override {
    ++kept;
    runs_[key] = run;
    if (wall_s > 0.0) runs_[key].wall_s = {wall_s};
    return error;
  }
  std::size_t size() const { return runs_.size(); }

  int kept = 0;
  double wall_s = 0.0;  // that runs are said to have taken; 0: what they took
  std::string error;

 private:
  std::map<std::string, KeptRun> runs_;
};

inline const RungResult& rung_of(const WorkPrecision& study, const std::string& method, std::size_t from_finest) {
  const RungResult* found = nullptr;
  for (auto r = study.rungs.rbegin(); r != study.rungs.rend() && found == nullptr; ++r)
    if (r->rung.method == method && from_finest-- == 0) found = &*r;
  EXPECT_NE(found, nullptr) << method;
  return *found;
}

}  // namespace slipstitch::testing
