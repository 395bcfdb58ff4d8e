// SPDX-License-Identifier: MIT
#include "run_dir/unique_fd.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace slipstitch {

UniqueFd& UniqueFd::operator=(UniqueFd&& other) noexcept {
  if (this != &other) {
    reset();
    fd_ = other.release();
  }
  return *this;
}

int UniqueFd::release() { return std::exchange(fd_, -1); }

void UniqueFd::reset() {
  if (fd_ >= 0) ::close(fd_);
  fd_ = -1;
}

IoError errno_message(const std::string& what, const std::filesystem::path& path) {
  const int code = errno;
  return what + " " + path.string() + ": " + std::strerror(code);
}

bool write_all(int fd, const void* data, std::size_t size) {
  const char* at = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t done = ::write(fd, at, size);
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) return false;
    at += done;
    size -= static_cast<std::size_t>(done);
  }
  return true;
}

bool read_all_at(int fd, void* data, std::size_t size, std::size_t offset) {
  char* at = static_cast<char*>(data);
  while (size > 0) {
    const ssize_t done = ::pread(fd, at, size, static_cast<off_t>(offset));
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) return false;
    at += done;
    size -= static_cast<std::size_t>(done);
    offset += static_cast<std::size_t>(done);
  }
  return true;
}

}  // namespace slipstitch
