// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace slipstitch {

struct EnvironmentVariable {
  std::string name, value;
};

/// OPENBLAS_CORETYPE value whose kernels this CPU runs and OpenBLAS 0.3.21 has: "SkylakeX" or "Haswell"; nothing below
/// AVX2. By CPUID, so that it fits what valgrind and emulators really execute.
std::optional<std::string> best_blas_core();

/// What a program must find in its environment to run BLAS with the best kernels and `threads` >= 1.
std::vector<EnvironmentVariable> blas_environment(int threads);

/// The BLAS this process really uses.
struct BlasInUse {
  std::string kernel;          // e.g. "SkylakeX"; empty: not OpenBLAS
  std::optional<int> threads;  // unknown where not OpenBLAS
};
BlasInUse blas_in_use();

/// "OpenBLAS SkylakeX, 2 threads", "unknown BLAS".
std::string to_string(const BlasInUse& blas);

/// Threads of later BLAS calls, >= 1. False where the BLAS is not OpenBLAS.
bool set_blas_threads(int threads);

}  // namespace slipstitch
