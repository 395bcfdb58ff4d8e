// SPDX-License-Identifier: MIT
#include "platform/cpu_check.h"

#include <unistd.h>

// Compiled for the baseline x86-64. No C++ library here: the linker may keep another file's copy of an inline function,
// and that copy uses the newer instructions.
namespace slipstitch {
namespace {

#ifdef SLIPSTITCH_ARCH
bool cpu_is_enough() {
  __builtin_cpu_init();
  return __builtin_cpu_supports(SLIPSTITCH_ARCH) != 0;
}

constexpr char kMessage[] =
    "slipstitch: this CPU cannot run this program: it lacks instructions of " SLIPSTITCH_ARCH
    " (AVX2, BMI2 and FMA).\nUse a newer CPU, or build for this one: cmake -DSLIPSTITCH_ARCH=x86-64 ...\n";
#else
bool cpu_is_enough() { return true; }  // built for another target, e.g. native

constexpr char kMessage[] = "";
#endif

// 101 is the earliest priority open to programs; plain static initialisers run after all priorities.
[[gnu::constructor(101)]] void check_before_static_initialisers() { require_cpu(); }

}  // namespace

void require_cpu() {
  if (cpu_is_enough()) return;
  [[maybe_unused]] const auto written = write(STDERR_FILENO, kMessage, sizeof(kMessage) - 1);
  _exit(2);
}

}  // namespace slipstitch
