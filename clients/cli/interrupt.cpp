// SPDX-License-Identifier: MIT
#include "cli/interrupt.h"

#include <signal.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <ctime>
#include <utility>

namespace slipstitch {
namespace {

sigset_t stop_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  return signals;
}

// A library's thread that started before main() does not block the signals; what it gets waits for the main thread.
void hand_to_main_thread(int signal) { ::syscall(SYS_tgkill, ::getpid(), ::getpid(), signal); }

void set_handler(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  ::sigaction(SIGINT, &action, nullptr);
  ::sigaction(SIGTERM, &action, nullptr);
}

}  // namespace

Interrupt::Interrupt(std::function<void()> on_first) : on_first_(std::move(on_first)) {
  const sigset_t signals = stop_signals();
  ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  set_handler(hand_to_main_thread);
}

bool Interrupt::requested() {
  if (requested_) return true;
  const sigset_t signals = stop_signals();
  const timespec now{};
  if (::sigtimedwait(&signals, nullptr, &now) < 0) return false;
  requested_ = true;
  set_handler(SIG_DFL);
  ::pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
  if (on_first_) on_first_();
  return true;
}

}  // namespace slipstitch
