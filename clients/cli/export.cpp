// SPDX-License-Identifier: MIT
#include <iostream>
#include <memory>

#include "cli/command.h"
#include "cli/exit_code.h"
#include "cli/frame_report.h"
#include "cli/interrupt.h"
#include "cli/options.h"
#include "run_dir/export_run.h"

namespace slipstitch {
namespace {

struct ExportArguments {
  std::string run;
  FrameFileOptions files;
  bool json = false;
};

int export_frames(const ExportArguments& options) {
  const Format* format = known_format(options.files);
  if (format == nullptr) return kExitBadInput;
  const Result<RunDir> run = open_run_dir(options.run);
  if (!run) {
    complain(run.error);
    return kExitBadInput;
  }
  if (refuse_occupied(options.files.out, options.files.force)) return kExitBadInput;
  Interrupt interrupt({});
  const Result<ExportReport> report = export_run(
      *run, options.files.out, *format,
      {options.files.first, options.files.stride, options.files.force, [&] { return interrupt.requested(); }});
  if (!report) {
    complain(report.error);
    return kExitFailed;
  }
  report_frames(options.files, report->frames, options.json);
  if (interrupt.requested()) return kExitInterrupted;
  if (!report->run_ended) note("The run has no end yet; these are its frames so far.");
  return kExitDone;
}

}  // namespace

Command add_export(CLI::App& root) {
  auto options = std::make_shared<ExportArguments>();
  CLI::App* app = root.add_subcommand("export", "Write the frames of a run directory as files");
  app->add_option("RUN_DIR", options->run, "Directory of a run: 'simulate --out', or a job's")
      ->type_name("")
      ->required();
  add_frame_file_options(*app, options->files);
  add_json_flag(*app, options->json);
  return {app, [options] { return export_frames(*options); }};
}

}  // namespace slipstitch
