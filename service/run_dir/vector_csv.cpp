// SPDX-License-Identifier: MIT
#include "run_dir/vector_csv.h"

#include <fcntl.h>

#include <array>
#include <cstdio>

namespace slipstitch {

Result<VectorCsv> VectorCsv::create(const std::filesystem::path& folder, const VectorTable& table) {
  VectorCsv csv;
  csv.file_ = folder / table.file;
  csv.fd_ = UniqueFd(::open(csv.file_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644));
  if (!csv.fd_) return Result<VectorCsv>::failed(errno_message("cannot create", csv.file_));
  if (IoError error = csv.append(table.columns + std::string("\n")); !error.empty()) {
    return Result<VectorCsv>::failed(std::move(error));
  }
  return Result<VectorCsv>::of(std::move(csv));
}

IoError VectorCsv::append(double t, const std::vector<Vec3>& vectors) {
  std::string lines;
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    std::array<char, 128> line{};
    std::snprintf(line.data(), line.size(), "%.9g,%zu,%.9g,%.9g,%.9g\n", t, i, vectors[i].x(), vectors[i].y(),
                  vectors[i].z());
    lines += line.data();
  }
  return append(lines);
}

IoError VectorCsv::append(const std::string& text) {
  return write_all(fd_.get(), text.data(), text.size()) ? IoError() : errno_message("cannot write", file_);
}

}  // namespace slipstitch
