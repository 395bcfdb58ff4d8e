// SPDX-License-Identifier: MIT
#include "api/predictor.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <optional>

#include "jobs/spawn_program.h"
#include "jobs/worker_environment.h"
#include "run_dir/unique_fd.h"

namespace slipstitch {
namespace {

constexpr std::chrono::milliseconds kLookAgain{10};
constexpr std::size_t kMostAnswerBytes = 1 << 20;

// At its beginning.
UniqueFd file_in_memory(const std::string& bytes) {
  UniqueFd file(::memfd_create("slipstitch", MFD_CLOEXEC));
  if (!file || !write_all(file.get(), bytes.data(), bytes.size()) || ::lseek(file.get(), 0, SEEK_SET) != 0) return {};
  return file;
}

std::optional<v1::Prediction> read_prediction(int file) {
  struct stat info {};
  if (::fstat(file, &info) != 0 || info.st_size <= 0) return std::nullopt;
  std::string bytes(static_cast<std::size_t>(info.st_size), '\0');
  v1::Prediction prediction;
  if (bytes.size() > kMostAnswerBytes || !read_all_at(file, bytes.data(), bytes.size(), 0) ||
      !prediction.ParseFromString(bytes))
    return std::nullopt;
  return prediction;
}

std::vector<std::string> environment() {
  JobInfo job;
  job.threads = jobs::kDefaultThreads;
  job.blas = jobs::blas_core_for_jobs();
  return jobs::worker_environment(job);
}

}  // namespace

bool wants_prediction(const v1::CreateSimJobRequest& request) {
  return request.validate_only() && request.spec().has_simulate();
}

bool Predictor::post(const v1::Scene& scene, Wanted wanted, Done done) {
  const std::lock_guard lock(mutex_);
  if (stopping_ || waiting_.size() >= kMostWaiting) return false;
  waiting_.push_back({scene.SerializeAsString(), std::move(wanted), std::move(done), Clock::now() + most_wait_});
  if (!thread_.joinable()) thread_ = std::thread([this] { work(); });
  changed_.notify_one();
  return true;
}

void Predictor::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return stopping_ || !waiting_.empty(); });
    if (waiting_.empty()) return;
    const Task task = std::move(waiting_.front());
    waiting_.pop_front();
    lock.unlock();
    answer(task);
    lock.lock();
  }
}

void Predictor::answer(const Task& task) {
  const UniqueFd in = file_in_memory(task.scene), out = file_in_memory({});
  std::optional<v1::Prediction> prediction;
  if (in && out && keeps_waiting(task) && run(task, in.get(), out.get())) prediction = read_prediction(out.get());
  task.done(prediction ? &*prediction : nullptr);
}

// Comes back at once when stopped.
bool Predictor::keeps_waiting(const Task& task) {
  std::unique_lock lock(mutex_);
  if (changed_.wait_for(lock, kLookAgain, [this] { return stopping_; })) return false;
  lock.unlock();
  return Clock::now() < task.give_up && task.wanted();
}

// Whether it came to its end.
bool Predictor::run(const Task& task, int in, int out) {
  const UniqueFd nowhere(::open("/dev/null", O_WRONLY | O_CLOEXEC));
  pid_t pid = -1;
  if (jobs::spawn_program(pid, {worker_.string(), "--predict"}, environment(), {in, out, nowhere.get()}) != 0)
    return false;
  int status = 0;
  while (::waitpid(pid, &status, WNOHANG) == 0) {
    if (keeps_waiting(task)) continue;
    ::kill(-pid, SIGKILL);
    ::waitpid(pid, &status, 0);
    return false;
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

void Predictor::stop() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
    changed_.notify_one();
  }
  if (thread_.joinable()) thread_.join();
}

}  // namespace slipstitch
