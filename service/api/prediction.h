// SPDX-License-Identifier: MIT
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "slipstitch/v1/job.pb.h"

namespace slipstitch {

/// Whether the answer to a request that is in order is to say what its run would take.
bool wants_prediction(const v1::CreateSimJobRequest& request);

/// Of a scene that can be run; nothing: see Prediction of job.proto. Takes a second or two; the first call of a process
/// may calibrate, which takes as long.
std::optional<v1::Prediction> predict_run(const v1::Scene& scene);

/// One thread of its own for predictions, so that nothing else of a server waits for them.
class PredictionLane {
 public:
  PredictionLane() = default;
  PredictionLane(const PredictionLane&) = delete;
  PredictionLane& operator=(const PredictionLane&) = delete;
  ~PredictionLane() { stop(); }

  /// False, without doing anything, while kMostWaiting others wait, and once stopped.
  bool post(std::function<void()> task);
  /// Waits for all that was posted.
  void stop();

 private:
  static constexpr std::size_t kMostWaiting = 4;
  void work();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> waiting_;
  bool stopping_ = false;
  std::thread thread_;  // from the first task on
};

}  // namespace slipstitch
