#pragma once

#include <chrono>
#include <string>

#include "slope/couple/simulation.hpp"

namespace slope::tools {

/// "412 s of 2400 s   17 %  2:31 left  clock x12.4  displacement 1.2 mm  water (m3/m): rain 0.5, in 0.4, run-off 0.1,
/// stored 0.4, balance error 2e-09"
/// @param stepping_seconds  wall time that the steps so far have taken
[[nodiscard]] std::string progress_text(const couple::Progress& progress, double end_time, double stepping_seconds);

/// "initial state: steady flow, pressures change by 35 Pa in a step of 4.1e+03 s (until 0.001 Pa in 1e+08 s)"
[[nodiscard]] std::string progress_text(const couple::InitialProgress& progress);

/// Shows how far a run is: on a terminal one line that is written over, elsewhere a line per tenth of the run.
class ProgressLine {
 public:
  /// @param end_time  longest simulated time (s).  @param quiet  shows nothing.
  ProgressLine(double end_time, bool quiet);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// The initial state is done: the time left is judged by what comes from now on.
  void begin_steps() { steps_began_ = elapsed(); }
  void show(const couple::Progress& progress);
  /// Where no line is written over, the first of each stage is shown, and one every ten seconds.
  void show(const couple::InitialProgress& progress);
  [[nodiscard]] std::string text(const couple::Progress& progress) const;
  /// A line that stays.
  void say(const std::string& line);
  /// Wall time since the start (s).
  [[nodiscard]] double elapsed() const;
  /// Takes the line that is written over away, so that something else can be printed.
  void clear();

 private:
  void write_over(const std::string& line);

  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  double end_time_;
  bool quiet_;
  bool terminal_;
  bool line_open_ = false;
  double steps_began_ = 0.0;
  double last_shown_ = 0.0;
  std::string stage_shown_;
  int tenths_shown_ = 0;
};

}  // namespace slope::tools
