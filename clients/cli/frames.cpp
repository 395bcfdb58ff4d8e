// SPDX-License-Identifier: MIT
#include <memory>

#include "cli/command.h"
#include "cli/exit_code.h"
#include "cli/frame_report.h"
#include "cli/interrupt.h"
#include "cli/options.h"
#include "cli/remote/frame_download.h"
#include "cli/remote_command.h"
#include "cli/screen/progress_bar.h"
#include "cli/screen/text.h"
#include "formats/frame_exporter.h"

namespace slipstitch {
namespace {

struct FramesOptions {
  std::string job, server;
  FrameFileOptions files;
  bool follow = false, json = false;
};

// Downloads into files. First frame 0 with the header, because sliding counts from there, then what was asked for.
class FrameFetch {
 public:
  FrameFetch(const FramesOptions& options, std::string name, const Format& format)
      : options_(options),
        name_(std::move(name)),
        interrupt_({}),
        exporter_(options.files.out, format, options.files.force) {}

  int run() {
    const std::optional<Connection> connection = connect(options_.server);
    if (!connection) return kExitBadInput;
    FrameDownload download = fetch_reference(*connection);
    if (const auto code = ended_early(download, *connection)) return *code;
    if (!begun_) return no_frames(*download.end);
    download = fetch_frames(*connection);
    bar_.clear();
    if (const auto code = ended_early(download, *connection)) return *code;
    return done(*download.end);
  }

 private:
  static int fail(const std::string& error) {
    complain(error);
    return kExitFailed;
  }

  FrameSink sink(std::function<std::string(const Frame&)> frame) {
    FrameSink sink;
    sink.header = [this](const FrameHeader& header) {
      header_ = header;
      return std::string();
    };
    sink.frame = std::move(frame);
    sink.broken = [this](const RemoteError& error) {
      bar_.clear();
      note("The stream broke (" + plain_text(error) + "); going on where it was.");
    };
    return sink;
  }

  FrameDownload fetch(const Connection& connection, const FrameQuery& query, const FrameSink& to) {
    return download_frames(
        connection, query, [this] { return interrupt_.requested(); }, to);
  }

  FrameDownload fetch_reference(const Connection& connection) {
    if (options_.follow) bar_.show("waiting for the first frame");
    return fetch(connection, {name_, 0, 1, 1, options_.follow}, sink([this](const Frame& frame) {
                   begun_ = true;
                   return exporter_.begin(header_, frame);
                 }));
  }

  FrameDownload fetch_frames(const Connection& connection) {
    const auto first = static_cast<std::uint32_t>(options_.files.first);
    const auto stride = static_cast<std::uint32_t>(options_.files.stride);
    return fetch(connection, {name_, first, stride, {}, options_.follow}, sink([this](const Frame& frame) {
                   bar_.show("frame " + thousands(frame.index) + " of " + thousands(header_.num_frames - 1));
                   return exporter_.add(frame);
                 }));
  }

  std::optional<int> ended_early(const FrameDownload& download, const Connection& connection) {
    if (download.end) return std::nullopt;
    bar_.clear();
    if (!download.sink_error.empty()) return fail(download.sink_error);
    if (download.error) return report_error(*download.error, connection);
    const FrameFileOptions& files = options_.files;
    std::string again =
        command_for("frames", name_, connection) + " --out " + shell_word(files.out) + " --format " + files.format;
    if (files.first > 0) again += " --first " + std::to_string(files.first);
    if (files.stride > 1) again += " --stride " + std::to_string(files.stride);
    note(count_of(exporter_.num_frames(), "frame", "frames") + " written; " + name_ +
         " is not touched. To fetch them all:\n  " + again + (options_.follow ? " --follow" : "") + " --force");
    return kExitInterrupted;
  }

  int no_frames(const v1::StreamEnd& end) {
    bar_.clear();
    const bool waits = end.reason() == "NO_MORE_YET";
    return fail(name_ + (waits ? " has no frames yet; --follow waits for them"
                               : " has no frames, it " + v1::SimJob::State_Name(end.state())));
  }

  int done(const v1::StreamEnd& end) {
    const int frames = exporter_.num_frames();
    if (frames == 0 && end.reason() != "NO_MORE_YET") {
      complain("there is no frame " + std::to_string(options_.files.first) + "; " + name_ + " has " +
               std::to_string(end.frame_count()));
      return kExitFailed;
    }
    report_frames(options_.files, frames, options_.json);
    if (end.reason() == "NO_MORE_YET") {
      note(name_ + " still runs; --follow waits for the rest.");
    } else if (end.state() != v1::SimJob::SUCCEEDED) {
      note(name_ + " ended as " + v1::SimJob::State_Name(end.state()) + "; these are the frames it has.");
    }
    return kExitDone;
  }

  const FramesOptions& options_;
  const std::string name_;
  Interrupt interrupt_;
  ProgressBar bar_;
  FrameExporter exporter_;
  FrameHeader header_;
  bool begun_ = false;
};

int fetch_frames(const FramesOptions& options) {
  const Format* format = known_format(options.files);
  const std::optional<std::string> name = job_name(options.job);
  if (format == nullptr || !name || refuse_occupied(options.files.out, options.files.force)) return kExitBadInput;
  return FrameFetch(options, *name, *format).run();
}

}  // namespace

Command add_frames(CLI::App& root) {
  auto options = std::make_shared<FramesOptions>();
  CLI::App* app = root.add_subcommand("frames", "Fetch a job's frames and write them as files");
  add_job_argument(*app, options->job);
  add_frame_file_options(*app, options->files);
  app->add_flag("--follow", options->follow, "Wait for frames still to come");
  add_server_option(*app, options->server);
  add_json_flag(*app, options->json);
  return {app, [options] { return fetch_frames(*options); }};
}

}  // namespace slipstitch
