// SPDX-License-Identifier: MIT
#pragma once

namespace slipstitch {

inline constexpr int kExitDone = 0;
inline constexpr int kExitFailed = 1;    // the run, or what was asked for
inline constexpr int kExitBadInput = 2;  // usage, scene, name of a job
inline constexpr int kExitNoServer = 3;
inline constexpr int kExitCancelled = 4;
inline constexpr int kExitInterrupted = 130;

}  // namespace slipstitch
