// SPDX-License-Identifier: MIT
#include "run_dir/run_recorder.h"

#include <optional>
#include <utility>

#include "run_dir/control_log.h"
#include "run_dir/frame_log.h"
#include "run_dir/history_csv.h"
#include "run_dir/throttle.h"
#include "run_dir/vector_csv.h"

namespace slipstitch {

struct RunRecorder::State {
  State(RunDir run_dir, RecorderOptions recorder_options)
      : dir(std::move(run_dir)),
        options(std::move(recorder_options)),
        control(dir.control()),
        progress_due(options.progress_interval_s),
        control_due(options.control_interval_s) {}

  RunDir dir;
  RecorderOptions options;
  ControlLogReader control;
  Throttle progress_due, control_due;
  std::optional<FrameLogWriter> log;
  std::optional<HistoryCsv> history;
  std::optional<VectorCsv> reactions, bodies;
  std::optional<Progress> last;
  bool unwritten = false;  // that
  bool cancelled = false;
  IoError error;  // the first

  void note(IoError failure) {
    if (error.empty()) error = std::move(failure);
  }

  void record_header(const FrameHeader& header) {
    Result<FrameLogWriter> created = FrameLogWriter::create(dir.frames());
    if (!created) return note(created.error);
    log.emplace(std::move(*created));
    note(log->append_header(header));
  }

  void record_frame(const Frame& frame) {
    if (log && error.empty()) note(log->append_frame(frame));
  }

  void record_report(const FrameReport& report) {
    if (!error.empty()) return;
    if (!history) {
      Result<HistoryCsv> created = HistoryCsv::create(dir.report(), report);
      if (!created) return note(created.error);
      history.emplace(std::move(*created));
    }
    note(history->append(report));
  }

  void record(std::optional<VectorCsv>& csv, const VectorTable& table, double t, const std::vector<Vec3>& vectors) {
    if (!error.empty()) return;
    if (!csv) {
      Result<VectorCsv> created = VectorCsv::create(dir.report(), table);
      if (!created) return note(created.error);
      csv.emplace(std::move(*created));
    }
    note(csv->append(t, vectors));
  }

  void record_progress(const Progress& progress) {
    const bool news = progress.doing != (last ? last->doing : std::string());  // the next may come in minutes
    last = progress;
    unwritten = true;
    if (progress_due.due() || news) flush_progress();
    if (options.on_progress) options.on_progress(progress);
  }

  void flush_progress() {
    if (!unwritten) return;
    note(write_progress(dir, progress_info(*last)));
    unwritten = false;
  }

  bool should_stop() {
    if (!cancelled && control_due.due()) {
      for (const std::string& command : control.poll()) cancelled = cancelled || command == kCancelCommand;
    }
    return cancelled || !error.empty() || (options.should_stop && options.should_stop());
  }
};

RunRecorder::RunRecorder(RunDir dir, RecorderOptions options)
    : state_(std::make_unique<State>(std::move(dir), std::move(options))) {}
RunRecorder::~RunRecorder() = default;
RunRecorder::RunRecorder(RunRecorder&&) noexcept = default;
RunRecorder& RunRecorder::operator=(RunRecorder&&) noexcept = default;

RunHooks RunRecorder::hooks() {
  State* state = state_.get();
  RunHooks hooks;
  hooks.on_header = [state](const FrameHeader& header) { state->record_header(header); };
  hooks.on_frame = [state](const Frame& frame) { state->record_frame(frame); };
  hooks.on_frame_report = [state](const FrameReport& report) { state->record_report(report); };
  hooks.on_reactions = [state](double t, const std::vector<Vec3>& forces) {
    state->record(state->reactions, kReactionsTable, t, forces);
  };
  hooks.on_bodies = [state](double t, const std::vector<Vec3>& centres) {
    state->record(state->bodies, kBodiesTable, t, centres);
  };
  hooks.on_progress = [state](const Progress& progress) { state->record_progress(progress); };
  hooks.should_stop = [state] { return state->should_stop(); };
  return hooks;
}

Result<RunSummary> RunRecorder::finish(RunSummary summary) {
  State& state = *state_;
  if (state.log && state.error.empty()) state.note(state.log->append_end(summary.sim_time_s));
  if (state.last) {
    state.last->wall_s = summary.wall_s;  // what it took as a whole
    state.unwritten = true;
  }
  state.flush_progress();
  if (!state.error.empty()) {
    summary.status = RunStatus::failed;
    summary.message = state.error + (summary.message.empty() ? "" : "; " + summary.message);
  }
  if (state.log) summary.frames = state.log->num_frames();
  if (IoError error = write_summary(state.dir, summary); !error.empty()) {
    return Result<RunSummary>::failed(std::move(error));
  }
  return Result<RunSummary>::of(std::move(summary));
}

}  // namespace slipstitch
