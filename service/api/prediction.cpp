// SPDX-License-Identifier: MIT
#include "api/prediction.h"

#include <cmath>

#include "prediction/calibration_cache.h"
#include "scene_io/load_scene.h"
#include "study/prediction.h"

namespace slipstitch {
namespace {

constexpr double kBudget_s = 0.5;
constexpr std::size_t kMostStitchesAndPoints = 4'000;

std::size_t stitches_and_points(const Scene& scene) {
  std::size_t count = scene.knit ? scene.knit->pattern.cells.size() : 0;
  for (const BareYarn& yarn : scene.yarns) count += yarn.points.size();
  return count;
}

/// What its model takes is not known before it is built, where yarn may meet yarn or a body in any number of places.
bool may_take_long(const Scene& scene) {
  const Effects& effects = scene.effects;
  return effects.automatic || effects.self_collision || effects.colliders ||
         stitches_and_points(scene) > kMostStitchesAndPoints;
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

}  // namespace

bool wants_prediction(const v1::CreateSimJobRequest& request) {
  return request.validate_only() && request.spec().has_simulate();
}

std::optional<v1::Prediction> predict_run(const v1::Scene& scene) {
  const LoadResult loaded = load_scene_message(scene);
  const auto* found = std::get_if<LoadedScene>(&loaded);
  if (found == nullptr || may_take_long(found->scene)) return std::nullopt;
  PredictOptions options;
  options.calibration = &machine_calibration();
  options.budget_s = kBudget_s;
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
  message.set_run_fails(prediction.run_fails);
  return message;
}

bool PredictionLane::post(std::function<void()> task) {
  const std::lock_guard lock(mutex_);
  if (stopping_ || waiting_.size() >= kMostWaiting) return false;
  waiting_.push_back(std::move(task));
  if (!thread_.joinable()) thread_ = std::thread([this] { work(); });
  changed_.notify_one();
  return true;
}

void PredictionLane::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return stopping_ || !waiting_.empty(); });
    if (waiting_.empty()) return;
    const std::function<void()> task = std::move(waiting_.front());
    waiting_.pop_front();
    lock.unlock();
    task();
    lock.lock();
  }
}

void PredictionLane::stop() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
    changed_.notify_one();
  }
  if (thread_.joinable()) thread_.join();
}

}  // namespace slipstitch
