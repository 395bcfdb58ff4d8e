// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace slipstitch::test {

/// Runs to its end: exit code (minus the signal if killed), what it wrote.
struct Finished {
  int code = 0;
  std::string out, err;
};
Finished run_program(const std::vector<std::string>& arguments);

/// A running slipstitchd. Killed when destroyed.
class ServerProcess {
 public:
  /// Returns when the server said that it is ready, or ended.
  explicit ServerProcess(const std::vector<std::string>& arguments);
  ~ServerProcess();
  ServerProcess(const ServerProcess&) = delete;
  ServerProcess& operator=(const ServerProcess&) = delete;

  const std::string& ready_line() const { return ready_line_; }
  std::string address() const { return address_of("grpc"); }
  std::string http_address() const { return address_of("http"); }
  pid_t pid() const { return pid_; }
  void signal(int number) const;
  int wait();  // exit code, or minus the signal

 private:
  std::string address_of(const std::string& interface) const;

  pid_t pid_ = -1;
  std::string ready_line_;
};

inline const std::string kServer = SLIPSTITCH_BIN_DIR "/slipstitchd";

}  // namespace slipstitch::test
