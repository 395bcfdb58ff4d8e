// SPDX-License-Identifier: MIT
#include "run_dir/export_run.h"

#include "formats/frame_exporter.h"
#include "run_dir/frame_log.h"

namespace slipstitch {
namespace {

using Report = Result<ExportReport>;

std::string export_frames(const FrameLogReader& log, FrameExporter& exporter, const ExportOptions& options) {
  const Result<Frame> reference = log.read_frame(0);
  if (!reference) return reference.error;
  if (std::string error = exporter.begin(*log.header(), *reference); !error.empty()) return error;
  for (std::int64_t index = options.first; index < log.num_frames(); index += options.stride) {
    if (options.should_stop && options.should_stop()) return {};
    const Result<Frame> frame = log.read_frame(static_cast<int>(index));
    if (!frame) return frame.error;
    if (std::string error = exporter.add(*frame); !error.empty()) return error;
  }
  return {};
}

std::string why_no_frames(const RunDir& run, const FrameLogReader& log) {
  if (log.state() == LogState::corrupt) return log.reason();
  if (!has_summary(run) && log.state() == LogState::growing) return run.path.string() + " has no frames yet";
  std::error_code error;
  if (!std::filesystem::exists(run.frames(), error))
    return run.frames().string() + " is missing, though the run has ended";
  return run.path.string() + " has ended without a frame";
}

}  // namespace

Report export_run(const RunDir& run, const std::filesystem::path& folder, const Format& format,
                  const ExportOptions& options) {
  if (options.first < 0 || options.stride < 1) return Report::failed("first must be >= 0 and stride >= 1");
  if (const Result<JobInfo> job = read_job(run); job && job->study) {
    return Report::failed(run.path.string() + " is a study, which has no frames; what it found is in " +
                          run.report().string());
  }
  FrameLogReader log(run.frames());
  const LogState state = log.poll();
  if (log.num_frames() == 0) return Report::failed(why_no_frames(run, log));
  if (options.first >= log.num_frames()) {
    return Report::failed("there is no frame " + std::to_string(options.first) + ", " +
                          std::to_string(log.num_frames()) + " so far");
  }
  FrameExporter exporter(folder, format, options.force);
  std::string error = export_frames(log, exporter, options);
  if (error.empty() && state == LogState::corrupt) error = log.reason();
  if (!error.empty()) return Report::failed(error);
  return Report::of({exporter.num_frames(), state == LogState::ended});
}

}  // namespace slipstitch
