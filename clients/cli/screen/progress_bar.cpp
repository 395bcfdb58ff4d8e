// SPDX-License-Identifier: MIT
#include "cli/screen/progress_bar.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <vector>

#include "cli/screen/text.h"

namespace slipstitch {
namespace {

constexpr std::chrono::milliseconds kRedrawInterval{100};
constexpr int kBarWidth = 12;
constexpr char kClearLine[] = "\r\x1b[K";

double share_of(const Progress& progress) {
  return progress.duration_s > 0.0 ? std::clamp(progress.t / progress.duration_s, 0.0, 1.0) : 1.0;
}

std::string bar(double share) {
  const int filled = static_cast<int>(std::floor(share * kBarWidth));
  return "[" + std::string(static_cast<std::size_t>(filled), '#') +
         std::string(static_cast<std::size_t>(kBarWidth - filled), '.') + "]";
}

std::string percent(double share) {
  std::string text = std::to_string(static_cast<int>(std::floor(100.0 * share)));
  return std::string(3 - text.size(), ' ') + text + " %";
}

// "0.94/2": to about a hundredth of the duration.
std::string time_of(const Progress& progress) {
  const double duration = std::max(progress.duration_s, 1e-6);
  const int decimals = std::max(0, 2 - static_cast<int>(std::floor(std::log10(duration))));
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, progress.t);
  return text.data() + ("/" + short_number(progress.duration_s));
}

}  // namespace

std::string progress_line(const Progress& progress, std::optional<double> eta_s, int columns) {
  const double share = share_of(progress);
  std::string line = bar(share) + " " + percent(share);
  const std::string eta = eta_s ? "  ETA " + clock_text(*eta_s) : "";
  std::vector<std::string> parts{
      "  " + time_of(progress) + " s",
      "  step " + thousands(progress.steps),
      "  Newton " + thousands(progress.newton_iterations),
      "  res " + short_number(progress.residual, 2),
  };
  if (progress.error_estimate_m) parts.insert(parts.begin() + 1, "  error ~" + metres_text(*progress.error_estimate_m));
  if (progress.budget_s)
    parts.insert(parts.begin() + 1, "  " + duration_text(progress.wall_s) + " of " + duration_text(*progress.budget_s));
  const auto room = static_cast<std::size_t>(std::max(columns - 1, 1));
  for (const std::string& part : parts) {
    if (line.size() + part.size() + eta.size() > room) break;
    line += part;
  }
  return (line + eta).substr(0, room);
}

std::string share_line(double share, const std::string& what, std::optional<double> eta_s, int columns) {
  const double done = std::clamp(share, 0.0, 1.0);
  const std::string eta = eta_s ? "  ETA " + clock_text(*eta_s) : "";
  const auto room = static_cast<std::size_t>(std::max(columns - 1, 1));
  const std::string line = bar(done) + " " + percent(done) + "  " + what;
  return (line.substr(0, room - std::min(room, eta.size())) + eta).substr(0, room);
}

ProgressBar::ProgressBar() : terminal_(::isatty(STDERR_FILENO) == 1) {}

int ProgressBar::columns() const {
  winsize size{};
  return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

bool ProgressBar::time_to_draw() {
  const auto now = std::chrono::steady_clock::now();
  if (drawn_at_ && now - *drawn_at_ < kRedrawInterval) return false;
  drawn_at_ = now;
  return true;
}

void ProgressBar::show(const Progress& progress, std::optional<double> eta_s) {
  if (!terminal_) return;
  last_ = progress;
  if (time_to_draw()) draw(progress_line(progress, eta_s, columns()));
}

void ProgressBar::show_share(double share, const std::string& what, std::optional<double> eta_s) {
  if (terminal_ && time_to_draw()) draw(share_line(share, what, eta_s, columns()));
}

void ProgressBar::show(const std::string& text) {
  if (!terminal_) return;
  draw(text.substr(0, static_cast<std::size_t>(columns() - 1)));
}

void ProgressBar::finish() {
  if (!last_) return clear();
  const std::string wall = "  " + duration_text(last_->wall_s);
  draw(progress_line(*last_, std::nullopt, columns() - static_cast<int>(wall.size())) + wall);
  std::cerr << std::endl;
  drawn_ = false;
  last_.reset();
}

void ProgressBar::clear() {
  if (drawn_) std::cerr << kClearLine << std::flush;
  drawn_ = false;
}

void ProgressBar::draw(const std::string& line) {
  std::cerr << kClearLine << line << std::flush;
  drawn_ = true;
}

}  // namespace slipstitch
