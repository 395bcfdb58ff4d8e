// SPDX-License-Identifier: MIT
#include "run_dir/control_log.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>

#include "run_dir/unique_fd.h"

namespace slipstitch {
namespace {

constexpr std::uint64_t kMaxBytesPerPoll = 1 << 16;

}  // namespace

IoError append_command(const std::filesystem::path& file, std::string_view command) {
  const UniqueFd fd(::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644));
  const std::string line = std::string(command) + '\n';
  if (!fd || !write_all(fd.get(), line.data(), line.size())) return errno_message("cannot append to", file);
  return {};
}

std::vector<std::string> ControlLogReader::poll() {
  std::vector<std::string> commands;
  struct stat info {};
  if (::stat(file_.c_str(), &info) != 0 || static_cast<std::uint64_t>(info.st_size) <= offset_) return commands;
  const UniqueFd fd(::open(file_.c_str(), O_RDONLY | O_CLOEXEC));
  std::string text(std::min(static_cast<std::uint64_t>(info.st_size) - offset_, kMaxBytesPerPoll), '\0');
  if (!fd || !read_all_at(fd.get(), text.data(), text.size(), offset_)) return commands;
  std::size_t begin = 0;
  for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', begin)) {
    commands.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  // A line longer than one poll is no command: step over it.
  offset_ += begin == 0 && text.size() == kMaxBytesPerPoll ? text.size() : begin;
  return commands;
}

}  // namespace slipstitch
