// SPDX-License-Identifier: MIT
#include "platform/startup.h"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

#include "platform/blas.h"
#include "platform/cpu_check.h"

namespace slipstitch {
namespace {

/// True if the variable was unset and now has the value.
bool set_if_unset(const EnvironmentVariable& variable) {
  if (std::getenv(variable.name.c_str()) != nullptr) return false;
  return setenv(variable.name.c_str(), variable.value.c_str(), 0) == 0;
}

void start_again(char** argv) {
  // The resolved path keeps the program's name in ps; the link still works after the file was replaced.
  std::error_code error;
  const std::string path = std::filesystem::read_symlink("/proc/self/exe", error).string();
  if (!error) execv(path.c_str(), argv);
  execv("/proc/self/exe", argv);
  // Without /proc the program goes on with the kernels it has; blas_in_use() names them.
}

}  // namespace

void start_process(char** argv, int blas_threads) {
  require_cpu();
  bool changed = false;
  for (const EnvironmentVariable& variable : blas_environment(blas_threads)) changed |= set_if_unset(variable);
  if (changed) start_again(argv);
}

}  // namespace slipstitch
