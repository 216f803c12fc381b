#include "progress_line.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

#include "slope/couple/water_amounts.hpp"
#include "time_unit.hpp"

namespace slope::tools {

namespace {

constexpr double seconds_between_updates = 0.1;
constexpr double seconds_between_lines = 10.0;  // of the initial state, where they stay

std::string duration_text(double seconds) {
  const long whole = std::lround(seconds);
  if (whole >= 3600) return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

/// The water's books (m3/m), save what is zero.
std::string water_text(const couple::WaterBudget& water) {
  namespace amounts = couple::water_amounts;
  std::string text;
  const auto add = [&](std::string_view name, const couple::WaterAmount& amount) {
    if (water.*amount.value == 0.0) return;
    text += fmt::format("{}{} {:.3g}", text.empty() ? "" : ", ", name, water.*amount.value);
  };
  add(amounts::rain.name, amounts::rain);
  add(amounts::infiltration.phrase, amounts::infiltration);
  add(amounts::run_off.name, amounts::run_off);
  add(amounts::outflow.phrase, amounts::outflow);
  add(fmt::format("of it {}", amounts::seepage.name), amounts::seepage);
  add(amounts::evaporation.name, amounts::evaporation);
  add(amounts::storage.phrase, amounts::storage);
  if (text.empty()) return "";
  return fmt::format("  water ({}): {}, {} {:.0e}", amounts::storage.unit, text, amounts::relative_balance_error.phrase,
                     water.relative_balance_error);
}

/// Columns of the terminal; no limit if it does not say.
std::size_t terminal_width() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : std::string::npos;
}

}  // namespace

std::string progress_text(const couple::Progress& progress, double end_time, double stepping_seconds) {
  const double millimetres = 1000.0 * progress.largest_displacement;
  const TimeUnit unit = time_unit(end_time);
  std::string text = fmt::format("{:.4g} {} of {:g} {}  {:3.0f} %", progress.time / unit.seconds, unit.name,
                                 end_time / unit.seconds, unit.name, 100.0 * progress.share);
  if (progress.share > 0.01 && progress.share < 1.0) {
    text += fmt::format("  {} left", duration_text(stepping_seconds * (1.0 - progress.share) / progress.share));
  }
  text += fmt::format("  clock x{:.3g}  displacement {}", progress.clock_factor,
                      millimetres < 100.0 ? fmt::format("{:.2g} mm", millimetres)
                                          : fmt::format("{:.3g} m", progress.largest_displacement));
  return text + water_text(progress.water);
}

std::string progress_text(const couple::InitialProgress& progress) {
  if (progress.step_time > 0.0) {
    return fmt::format("{}: {}, pressures change by {:.2g} Pa in a step of {:.2g} s (until {:g} Pa)", progress.search,
                       progress.stage, progress.measure, progress.step_time, progress.wanted);
  }
  return fmt::format("{}: {}, {:.2g} of the weight unbalanced (until {:g})", progress.search, progress.stage,
                     progress.measure, progress.wanted);
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
    write_over(line);
    return;
  }
  const int tenths = static_cast<int>(10.0 * progress.share);
  if (tenths <= tenths_shown_) return;
  tenths_shown_ = tenths;
  std::fprintf(stderr, "%s\n", line.c_str());
}

void ProgressLine::show(const couple::InitialProgress& progress) {
  if (quiet_) return;
  const std::string line = progress_text(progress);
  if (terminal_) {
    write_over(line);
    return;
  }
  if (progress.stage == stage_shown_ && elapsed() - last_shown_ < seconds_between_lines) return;
  stage_shown_ = progress.stage;
  last_shown_ = elapsed();
  std::fprintf(stderr, "%s\n", line.c_str());
}

void ProgressLine::write_over(const std::string& line) {
  if (line_open_ && elapsed() - last_shown_ < seconds_between_updates) return;
  std::fprintf(stderr, "\r%s\x1b[K", line.substr(0, terminal_width()).c_str());
  std::fflush(stderr);
  line_open_ = true;
  last_shown_ = elapsed();
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
