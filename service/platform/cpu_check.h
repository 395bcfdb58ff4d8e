// SPDX-License-Identifier: MIT
#pragma once

namespace slipstitch {

/// Ends the process with a message and exit code 2 if the CPU lacks the instructions the programs are compiled for.
/// Also runs by itself before every C++ static initialiser of the program that links it; calling it is what links it.
void require_cpu();

}  // namespace slipstitch
