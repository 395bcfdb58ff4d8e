// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <filesystem>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include "slipstitch/v1/job.pb.h"

namespace slipstitch {

/// Whether the answer to a request that is in order is to say what its run would take.
bool wants_prediction(const v1::CreateSimJobRequest& request);

/// Says what runs would take. One at a time, each in a process of its own (`slipstitch-worker --predict`), because a
/// scene's model can take any time and memory: that process has limits of both, and can be ended.
class Predictor {
 public:
  using Clock = std::chrono::steady_clock;
  using Wanted = std::function<bool()>;
  using Done = std::function<void(const v1::Prediction*)>;

  /// `worker`: the program. `most_wait`: of wall time, from post() on; the process is limited in processor time,
  /// because on a busy machine it gets on late.
  Predictor(std::filesystem::path worker, std::chrono::milliseconds most_wait)
      : worker_(std::move(worker)), most_wait_(most_wait) {}
  Predictor(const Predictor&) = delete;
  Predictor& operator=(const Predictor&) = delete;
  ~Predictor() { stop(); }

  /// Calls `done` once, from another thread; with null: no prediction, because there is no model, it takes too long or
  /// too much, `wanted` (asked from the same thread, now and then) became false, or stop() was called. False, without
  /// calling it ever, while kMostWaiting others wait, and once stopped.
  bool post(const v1::Scene& scene, Wanted wanted, Done done);
  /// Ends what is under way; returns once all that was posted has been answered.
  void stop();

 private:
  struct Task {
    std::string scene;  // serialized
    Wanted wanted;
    Done done;
    Clock::time_point give_up;
  };
  static constexpr std::size_t kMostWaiting = 4;

  void work();
  void answer(const Task& task);
  bool keeps_waiting(const Task& task);
  bool run(const Task& task, int in, int out);

  const std::filesystem::path worker_;
  const std::chrono::milliseconds most_wait_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Task> waiting_;
  bool stopping_ = false;
  std::thread thread_;  // from the first task on
};

}  // namespace slipstitch
