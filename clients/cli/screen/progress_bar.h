// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "sim/run.h"

namespace slipstitch {

/// "[#####.......]  47 %  0.94/2 s  step 226  Newton 911  res 8.1e-05  ETA 1:23", at most `columns` - 1
/// characters: what does not fit is left out from the right, the ETA last.
std::string progress_line(const Progress& progress, std::optional<double> eta_s, int columns);

/// "[#####.......]  47 %  BDF2 8.33 ms  ETA 1:23"; of `what` as much as fits.
std::string share_line(double share, const std::string& what, std::optional<double> eta_s, int columns);

/// One line at the bottom of a terminal, redrawn at most ten times a second. Silent when stderr is none.
class ProgressBar {
 public:
  ProgressBar();
  ~ProgressBar() { clear(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(const Progress& progress, std::optional<double> eta_s);
  void show(const std::string& text);  // at once
  /// share in [0, 1] of all that is to be done.
  void show_share(double share, const std::string& what, std::optional<double> eta_s = {});
  /// Replaces the bar by its last state as a line that stays. Nothing when nothing was shown.
  void finish();
  /// Takes the bar away, e.g. before another message.
  void clear();

 private:
  bool time_to_draw();
  void draw(const std::string& line);
  int columns() const;

  bool terminal_;
  std::string line_;
  bool drawn_ = false;
  std::optional<Progress> last_;
  std::optional<std::chrono::steady_clock::time_point> drawn_at_;
};

}  // namespace slipstitch
