// SPDX-License-Identifier: MIT
#include "run_dir/reactions_csv.h"

#include <fcntl.h>

#include <array>
#include <cstdio>

namespace slipstitch {

Result<ReactionsCsv> ReactionsCsv::create(const std::filesystem::path& file) {
  ReactionsCsv csv;
  csv.file_ = file;
  csv.fd_ = UniqueFd(::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644));
  if (!csv.fd_) return Result<ReactionsCsv>::failed(errno_message("cannot create", file));
  if (IoError error = csv.append("t_s,handle,fx_n,fy_n,fz_n\n"); !error.empty()) {
    return Result<ReactionsCsv>::failed(std::move(error));
  }
  return Result<ReactionsCsv>::of(std::move(csv));
}

IoError ReactionsCsv::append(double t, const std::vector<Vec3>& forces) {
  std::string lines;
  for (std::size_t i = 0; i < forces.size(); ++i) {
    std::array<char, 128> line{};
    std::snprintf(line.data(), line.size(), "%.9g,%zu,%.9g,%.9g,%.9g\n", t, i, forces[i].x(), forces[i].y(),
                  forces[i].z());
    lines += line.data();
  }
  return append(lines);
}

IoError ReactionsCsv::append(const std::string& text) {
  return write_all(fd_.get(), text.data(), text.size()) ? IoError() : errno_message("cannot write", file_);
}

}  // namespace slipstitch
