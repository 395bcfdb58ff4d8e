// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "run_dir/result.h"

namespace slipstitch {

/// Owns a file descriptor; closed when destroyed.
class UniqueFd {
 public:
  UniqueFd() = default;
  explicit UniqueFd(int fd) : fd_(fd) {}
  UniqueFd(UniqueFd&& other) noexcept : fd_(other.release()) {}
  UniqueFd& operator=(UniqueFd&& other) noexcept;
  ~UniqueFd() { reset(); }

  int get() const { return fd_; }
  explicit operator bool() const { return fd_ >= 0; }
  int release();
  void reset();

 private:
  int fd_ = -1;
};

/// "what PATH: strerror(errno)".
IoError errno_message(const std::string& what, const std::filesystem::path& path);

/// Writes all bytes at the file position; interrupted and short writes are continued.
bool write_all(int fd, const void* data, std::size_t size);

/// Reads exactly `size` bytes at `offset`; false on error or at the end of the file.
bool read_all_at(int fd, void* data, std::size_t size, std::size_t offset);

}  // namespace slipstitch
