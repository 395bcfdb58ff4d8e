// SPDX-License-Identifier: MIT
#include "run_dir/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <vector>

#include "run_dir/unique_fd.h"

namespace slipstitch {

IoError sync_folder(const std::filesystem::path& folder) {
  const UniqueFd fd(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!fd || (::fsync(fd.get()) != 0 && errno != EINVAL)) return errno_message("cannot sync", folder);
  return {};
}

IoError write_file_atomic(const std::filesystem::path& path, std::string_view bytes) {
  std::string name = path.string() + ".tmp-XXXXXX";
  UniqueFd fd(::mkostemp(name.data(), O_CLOEXEC));
  if (!fd) return errno_message("cannot create", name);
  const bool written =
      ::fchmod(fd.get(), 0644) == 0 && write_all(fd.get(), bytes.data(), bytes.size()) && ::fsync(fd.get()) == 0;
  if (!written || ::rename(name.c_str(), path.c_str()) != 0) {
    IoError error = errno_message("cannot write", path);
    ::unlink(name.c_str());
    return error;
  }
  return sync_folder(path.has_parent_path() ? path.parent_path() : ".");
}

Result<std::string> read_file(const std::filesystem::path& path, std::size_t max_bytes) {
  const UniqueFd fd(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  struct stat info {};
  if (!fd || ::fstat(fd.get(), &info) != 0) return Result<std::string>::failed(errno_message("cannot open", path));
  if (!S_ISREG(info.st_mode)) return Result<std::string>::failed(path.string() + " is not a file");
  if (static_cast<std::size_t>(info.st_size) > max_bytes) {
    return Result<std::string>::failed(path.string() + " has " + std::to_string(info.st_size) + " bytes, above " +
                                       std::to_string(max_bytes));
  }
  std::string bytes(static_cast<std::size_t>(info.st_size), '\0');
  if (!read_all_at(fd.get(), bytes.data(), bytes.size(), 0)) {
    return Result<std::string>::failed(errno_message("cannot read", path));
  }
  return Result<std::string>::of(std::move(bytes));
}

}  // namespace slipstitch
