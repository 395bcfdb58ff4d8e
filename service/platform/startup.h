// SPDX-License-Identifier: MIT
#pragma once

namespace slipstitch {

/// Call first in main of every program. Checks the CPU (cpu_check.h), then makes sure that OpenBLAS runs kernels that
/// fit it: Debian's 0.3.21 does not know newer Intel cores, falls back to SSE3 kernels, and chooses when it is loaded,
/// before main. So whichever of OPENBLAS_CORETYPE and OPENBLAS_NUM_THREADS is unset is set, and the program starts
/// itself again, once, with the same pid and arguments. What the user set is kept.
/// `blas_threads` >= 1; change it later with set_blas_threads().
///
/// A program run under valgrind without --trace-children=yes should get both variables from outside.
void start_process(char** argv, int blas_threads = 1);

}  // namespace slipstitch
