// SPDX-License-Identifier: MIT
#include "run_dir/history_csv.h"

#include <fcntl.h>

#include <cmath>

#include "formats/number_text.h"

namespace slipstitch {
namespace {

constexpr char kColumns[] =
    "frame,t_s,steps,rejected_steps,newton_iterations,linear_iterations,step_s,residual,error_estimate_m";
constexpr char kKinetic[] = "kinetic";  // the first column of energy

void add_cell(const std::optional<double>& value, std::string& line) {
  line += ',';
  if (value && std::isfinite(*value)) append_number(line, *value);
}

}  // namespace

Result<HistoryCsv> HistoryCsv::create(const std::filesystem::path& folder, const FrameReport& first) {
  HistoryCsv csv;
  csv.file_ = folder / kHistoryFile;
  csv.fd_ = UniqueFd(::open(csv.file_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644));
  if (!csv.fd_) return Result<HistoryCsv>::failed(errno_message("cannot create", csv.file_));
  csv.terms_.emplace_back(kKinetic);
  for (const auto& [term, energy] : first.energy_j) {
    if (term != kKinetic) csv.terms_.push_back(term);
  }
  std::string columns = kColumns;
  for (const std::string& term : csv.terms_) columns += "," + term + "_j";
  if (IoError error = csv.write(columns + "\n"); !error.empty()) return Result<HistoryCsv>::failed(std::move(error));
  return Result<HistoryCsv>::of(std::move(csv));
}

IoError HistoryCsv::append(const FrameReport& report) {
  std::string line = std::to_string(report.frame);
  add_cell(report.t, line);
  for (const long count : {report.steps, report.rejected_steps, report.newton_iterations, report.linear_iterations}) {
    line += "," + std::to_string(count);
  }
  for (const auto& value : {report.step_s, report.residual, report.error_estimate_m}) add_cell(value, line);
  for (const std::string& term : terms_) {
    const auto energy = report.energy_j.find(term);
    add_cell(energy == report.energy_j.end() ? std::nullopt : energy->second, line);
  }
  return write(line + "\n");
}

IoError HistoryCsv::write(const std::string& line) {
  return write_all(fd_.get(), line.data(), line.size()) ? IoError() : errno_message("cannot write", file_);
}

}  // namespace slipstitch
