// SPDX-License-Identifier: MIT
#include "run_paths.h"

#include <cstdio>
#include <set>

#include "cli/remote/frame_download.h"
#include "run_dir/frame_log.h"
#include "support/sample_run.h"

namespace slipstitch::test {
namespace {

std::string frame_stem(std::size_t index) {
  std::array<char, 32> name{};
  std::snprintf(name.data(), name.size(), "frame_%06zu", index);
  return name.data();
}

template <class Real>
std::vector<std::vector<std::array<double, 3>>> widened(const Curves<Real>& file) {
  std::vector<std::vector<std::array<double, 3>>> yarns;
  for (const auto& curve : file.curves) {
    auto& yarn = yarns.emplace_back();
    for (const auto& point : curve) yarn.push_back({point[0], point[1], point[2]});
  }
  return yarns;
}

std::optional<ParsedFrame> parsed_obj(const std::string& bytes) {
  const auto file = parse_obj(bytes);
  return file ? std::optional<ParsedFrame>({widened(*file), false, {}, {}}) : std::nullopt;
}

std::optional<ParsedFrame> parsed_bcc(const std::string& bytes) {
  const auto file = parse_bcc(bytes);
  return file ? std::optional<ParsedFrame>({widened(*file), true, {}, {}}) : std::nullopt;
}

std::optional<ParsedFrame> parsed_vtp(const std::string& bytes) {
  const auto file = parse_vtp(bytes);
  if (!file || !file->point_data.contains("arc_length_m")) return std::nullopt;
  return ParsedFrame{widened(*file), false, file->time, file->point_data.at("arc_length_m")};
}

std::optional<ParsedFrame> parsed_frame(const std::string& format, const std::string& bytes) {
  if (format == "obj") return parsed_obj(bytes);
  return format == "bcc" ? parsed_bcc(bytes) : parsed_vtp(bytes);
}

}  // namespace

Result<ShownRun> logged_run(const RunDir& dir) {
  FrameLogReader log(dir.frames());
  if (log.poll() != LogState::ended) return Result<ShownRun>::failed("no end: " + log.reason());
  const Result<RunSummary> summary = read_summary(dir);
  if (!summary) return Result<ShownRun>::failed(summary.error);
  ShownRun run{*log.header(), {}, summary->state_hash};
  for (int index = 0; index < log.num_frames(); ++index) {
    const Result<Frame> frame = log.read_frame(index);
    if (!frame) return Result<ShownRun>::failed(frame.error);
    run.frames.push_back(*frame);
  }
  return Result<ShownRun>::of(std::move(run));
}

Result<ShownRun> downloaded_run(const std::string& address, const std::string& job, const std::string& state_hash) {
  ShownRun run{{}, {}, state_hash};
  FrameSink sink;
  sink.header = [&](const FrameHeader& header) {
    run.header = header;
    return std::string();
  };
  sink.frame = [&](const Frame& frame) {
    run.frames.push_back(frame);
    return std::string();
  };
  sink.broken = [](const RemoteError&) {};
  const FrameDownload download = download_frames(
      Connection(address), {job, 0, 1, {}, false}, [] { return false; }, sink);
  if (download.end) return Result<ShownRun>::of(std::move(run));
  return Result<ShownRun>::failed("download: " + (download.error ? download.error->message : download.sink_error));
}

ParsedFrames parsed_frames(const std::filesystem::path& folder, const std::string& format) {
  std::set<std::filesystem::path> files;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    if (file.path().extension() == "." + format) files.insert(file.path());
  }
  ParsedFrames frames;
  for (const auto& file : files) {
    const bool in_order = file.stem() == frame_stem(frames.size());
    frames.push_back(in_order ? parsed_frame(format, read_bytes(file)) : std::nullopt);
  }
  return frames;
}

}  // namespace slipstitch::test
