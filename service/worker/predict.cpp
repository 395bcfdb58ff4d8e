// SPDX-License-Identifier: MIT
#include "worker/predict.h"

#include <sys/resource.h>

#include <cmath>
#include <iostream>
#include <new>
#include <optional>

#include "prediction/calibration_cache.h"
#include "scene_io/load_scene.h"
#include "slipstitch/v1/job.pb.h"
#include "study/prediction.h"

namespace slipstitch {
namespace {

constexpr double kPilots_s = 0.5;
constexpr rlim_t kMostProcessor_s = 6;
constexpr rlim_t kMostMemory_bytes = rlim_t{1} << 30;
constexpr rlim_t kMostAnswer_bytes = rlim_t{1} << 20;

bool limit(__rlimit_resource what, rlim_t most) {
  const rlimit both{most, most};
  return ::setrlimit(what, &both) == 0;
}

bool set_limits() {
  return limit(RLIMIT_CPU, kMostProcessor_s) && limit(RLIMIT_DATA, kMostMemory_bytes) &&
         limit(RLIMIT_FSIZE, kMostAnswer_bytes) && limit(RLIMIT_CORE, 0);
}

v1::PredictedRun::Basis message_from_basis(Basis basis) {
  switch (basis) {
    case Basis::whole_run:
      return v1::PredictedRun::WHOLE_RUN;
    case Basis::first_moments:
      return v1::PredictedRun::FIRST_MOMENTS;
    case Basis::canned_run:
      break;
  }
  return v1::PredictedRun::CANNED_RUN;
}

std::uint64_t whole(double count) { return static_cast<std::uint64_t>(std::max(0.0, std::round(count))); }

void set_run(const RunPrediction& run, double tolerance_m, const PilotBasis& basis, v1::PredictedRun& message) {
  message.set_tolerance_m(tolerance_m);
  message.set_wall_s(run.wall_s);
  message.set_steps(whole(run.steps));
  message.set_newton_iterations(whole(run.iterations));
  message.set_basis(message_from_basis(basis.basis));
  message.set_until_s(basis.until_s);
  message.set_basis_tolerance_m(basis.tolerance_m);
}

/// Nothing of a scene that has no model.
std::optional<v1::Prediction> predict_scene(const v1::Scene& scene) {
  const LoadResult loaded = load_scene_message(scene);
  const auto* found = std::get_if<LoadedScene>(&loaded);
  if (found == nullptr) return std::nullopt;
  PredictOptions options;
  options.calibration = &machine_calibration();
  options.budget_s = kPilots_s;
  const Prediction prediction = predict(found->scene, options);
  if (!prediction.failure.empty()) return std::nullopt;
  v1::Prediction message;
  message.set_unknowns(static_cast<std::uint32_t>(prediction.dofs));
  message.set_matrix_entries(static_cast<std::uint64_t>(prediction.hessian_nonzeros));
  message.set_memory_bytes(whole(prediction.memory_bytes));
  if (prediction.as_it_is)
    set_run(*prediction.as_it_is, prediction.budget_tolerance_m, prediction.as_it_is_basis,
            *message.mutable_as_it_is());
  for (const TolerancePrediction& to : prediction.to_tolerance)
    set_run(to.run, to.tolerance_m, prediction.to_tolerance_basis, *message.add_to_tolerance());
  message.set_chooses_effects(found->scene.effects.automatic.has_value());
  message.set_run_fails(prediction.run_fails);
  return message;
}

}  // namespace

int predict_for_server() try {
  v1::Scene scene;
  if (!set_limits() || !scene.ParseFromIstream(&std::cin)) return 1;
  const std::optional<v1::Prediction> prediction = predict_scene(scene);
  return !prediction || (prediction->SerializeToOstream(&std::cout) && std::cout.flush()) ? 0 : 1;
} catch (const std::bad_alloc&) {
  return 1;
}

}  // namespace slipstitch
