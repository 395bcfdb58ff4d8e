// SPDX-License-Identifier: MIT
#include "jobs/worker_environment.h"

#include <unistd.h>

#include <cstdlib>
#include <string_view>

#include "platform/blas.h"

namespace slipstitch::jobs {

std::string blas_core_for_jobs() {
  const char* chosen = std::getenv("OPENBLAS_CORETYPE");
  return chosen != nullptr ? std::string(chosen) : best_blas_core().value_or(std::string());
}

std::vector<std::string> worker_environment(const JobInfo& job) {
  std::vector<std::string> environment;
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string_view text(*variable);
    if (!text.starts_with("OPENBLAS_CORETYPE=") && !text.starts_with("OPENBLAS_NUM_THREADS=")) {
      environment.emplace_back(text);
    }
  }
  if (!job.blas.empty()) environment.push_back("OPENBLAS_CORETYPE=" + job.blas);
  environment.push_back("OPENBLAS_NUM_THREADS=" + std::to_string(job.threads));
  return environment;
}

}  // namespace slipstitch::jobs
