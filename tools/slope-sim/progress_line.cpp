#include "progress_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace slope::tools {

namespace {

constexpr double seconds_between_updates = 0.1;

std::string duration_text(double seconds) {
  const long whole = std::lround(seconds);
  if (whole >= 3600) return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

}  // namespace

std::string progress_text(const couple::Progress& progress, double end_time, double stepping_seconds) {
  const double millimetres = 1000.0 * progress.largest_displacement;
  std::string text = fmt::format("{:.4g} s of {:g} s  {:3.0f} %  clock x{:.3g}  displacement {}", progress.time,
                                 end_time, 100.0 * progress.share, progress.clock_factor,
                                 millimetres < 100.0 ? fmt::format("{:.2g} mm", millimetres)
                                                     : fmt::format("{:.3g} m", progress.largest_displacement));
  if (progress.infiltration > 0.0) text += fmt::format("  water in {:.3g} m3/m", progress.infiltration);
  if (progress.share > 0.01 && progress.share < 1.0) {
    text += fmt::format("  {} left", duration_text(stepping_seconds * (1.0 - progress.share) / progress.share));
  }
  return text;
}

ProgressLine::ProgressLine(double end_time, bool quiet)
    : end_time_(end_time), quiet_(quiet), terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
  clear();
}

void ProgressLine::show(const couple::Progress& progress) {
  if (quiet_) return;
  const std::string line = text(progress);
  if (terminal_) {
    if (line_open_ && elapsed() - last_shown_ < seconds_between_updates) return;
    std::fprintf(stderr, "\r%s\x1b[K", line.c_str());
    std::fflush(stderr);
    line_open_ = true;
    last_shown_ = elapsed();
    return;
  }
  const int tenths = static_cast<int>(10.0 * progress.share);
  if (tenths <= tenths_shown_) return;
  tenths_shown_ = tenths;
  std::fprintf(stderr, "%s\n", line.c_str());
}

std::string ProgressLine::text(const couple::Progress& progress) const {
  return progress_text(progress, end_time_, elapsed() - steps_began_);
}

void ProgressLine::say(const std::string& line) {
  if (quiet_) return;
  clear();
  std::fprintf(stderr, "%s\n", line.c_str());
}

double ProgressLine::elapsed() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

void ProgressLine::clear() {
  if (line_open_) std::fputs("\r\x1b[K", stderr);
  line_open_ = false;
}

}  // namespace slope::tools
