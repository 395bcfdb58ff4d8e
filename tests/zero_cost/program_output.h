// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <string>

namespace slipstitch::test {

inline std::string in_bin(const std::string& program) { return std::string(SLIPSTITCH_BIN_DIR) + "/" + program; }

/// Standard output of a shell command, which is expected to succeed.
inline std::string output_of(const std::string& command) {
  std::FILE* pipe = ::popen(command.c_str(), "r");
  std::string text;
  std::array<char, 4096> buffer{};
  while (pipe && std::fgets(buffer.data(), buffer.size(), pipe)) text += buffer.data();
  EXPECT_TRUE(pipe && ::pclose(pipe) == 0) << command << ": " << text;
  return text;
}

}  // namespace slipstitch::test
