// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "support/sample_run.h"

namespace slipstitch::test {

struct ProgramEnd {
  int exit_code = -1;  // -1: ended by a signal
  int signal = 0;
  std::string out, err;
};

/// A program from build/bin, without a terminal. Still running at destruction: killed.
class Program {
 public:
  /// `environment`: NAME=VALUE, besides that of the tests less SLIPSTITCH_SERVER.
  Program(const std::string& name, const std::vector<std::string>& arguments,
          const std::vector<std::string>& environment = {});
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void send(int signal) const;
  std::string out() const;  // so far
  bool running();
  bool blocks(int signal) const;  // in its main thread
  ProgramEnd wait();

 private:
  TemporaryFolder folder_;
  pid_t pid_ = -1;
  bool reaped_ = false;
  int status_ = 0;
};

ProgramEnd run_program(const std::string& name, const std::vector<std::string>& arguments,
                       const std::vector<std::string>& environment = {});
ProgramEnd slipstitch(const std::vector<std::string>& arguments);

/// Asks until it is true. Only ctest's timeout ends it otherwise.
void wait_until(const std::function<bool()>& condition);

/// A yarn of `points` points that hangs between its ends and swings.
std::string swing_scene(double duration_s, int points = 6);

}  // namespace slipstitch::test
