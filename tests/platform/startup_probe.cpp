// SPDX-License-Identifier: MIT
// Prints a line before and after start_process, so that a test sees how often the program started and what it got.
#include <unistd.h>

#include <cstdlib>
#include <iostream>

#include "platform/blas.h"
#include "platform/memory.h"
#include "platform/startup.h"

int main(int argc, char** argv) {
  std::cout << "start " << getpid() << std::endl;
  slipstitch::start_process(argv, 3);
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "unset" : value;
  };
  const slipstitch::BlasInUse blas = slipstitch::blas_in_use();
  std::cout << "coretype " << variable("OPENBLAS_CORETYPE") << "\nnum_threads " << variable("OPENBLAS_NUM_THREADS")
            << "\nkernel " << blas.kernel << "\nthreads " << blas.threads.value_or(0) << "\narguments " << argc - 1;
  for (int i = 1; i < argc; ++i) std::cout << ' ' << argv[i];
  std::cout << "\npeak " << slipstitch::peak_memory_bytes().value_or(0) << std::endl;
  const bool changed = slipstitch::set_blas_threads(1);
  std::cout << "threads_set_to_one " << (changed ? slipstitch::blas_in_use().threads.value_or(0) : 0) << std::endl;
}
