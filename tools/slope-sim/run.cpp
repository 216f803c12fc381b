#include "run.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdio>
#include <ctime>

#include "interruption.hpp"
#include "progress_line.hpp"
#include "report.hpp"
#include "run_writer.hpp"
#include "slope/couple/read_case.hpp"
#include "slope/couple/simulation.hpp"

namespace slope::tools {

namespace {

/// One run: the simulation, where its results go, and what is shown of it.
class Run {
 public:
  explicit Run(const RunOptions& options)
      : options_(options),
        simulation_(couple::read_case(options.case_file, options.overrides, &warnings_), options.threads),
        writer_(options.folder),
        progress_(simulation_.input().stop.time, options.quiet) {
    record_.version = SLOPE_VERSION;
    record_.end_reason = "running";
    record_.threads = options.threads;
  }

  ExitCode execute() {
    writer_.write_case(simulation_.input());
    log_beginning();
    try {
      if (start()) {
        while (!advance()) {
        }
      }
    } catch (const couple::SimulationError& error) {
      // that soil in free fall cannot be computed any more does not change what is known of the slope
      const bool known = !simulation_.summary().stands_before;
      return break_off("error", error.what(), known ? ExitCode::fine : ExitCode::broken_physics);
    }
    if (record_.end_reason == "interrupted") return break_off("interrupted", record_.message, ExitCode::interrupted);
    finish();
    return ExitCode::fine;
  }

 private:
  void log_beginning() {
    writer_.log(fmt::format("slope-sim {}, {:%Y-%m-%d %H:%M:%S} UTC", SLOPE_VERSION, fmt::gmtime(std::time(nullptr))));
    writer_.log(fmt::format("case {}", options_.case_file.string()));
    for (const std::string& assignment : options_.overrides) writer_.log(fmt::format("--set {}", assignment));
    writer_.log(fmt::format("{} thread{}", options_.threads, options_.threads == 1 ? "" : "s"));
    for (const couple::Problem& warning : warnings_) {
      writer_.log("warning: " + warning.text());
      progress_.say("warning: " + warning.text());
    }
  }

  /// @return whether the initial state was found, and not interrupted.
  bool start() {
    write_summary();
    progress_.say("initial state");
    const bool found = simulation_.initialise([this](const couple::InitialProgress& progress) {
      progress_.show(progress);
      return !interrupted();
    });
    if (!found) {
      record_.end_reason = "interrupted";
      record_.message = "interrupted before the start: the initial state is as far as it came";
      return false;
    }
    progress_.begin_steps();
    writer_.log(
        fmt::format("{:.1f} s: initial state of {} particles", progress_.elapsed(), simulation_.summary().particles));
    tell_of_unbalanced_start();
    writer_.begin_history(simulation_.history_columns());
    writer_.begin_budget(couple::Simulation::budget_columns());
    add_rows();
    writer_.add_snapshot(simulation_.particles(), "start");
    write_summary();
    return true;
  }

  /// The verdict on a slope that falls by itself comes before what shows how.
  void tell_of_unbalanced_start() {
    const couple::Summary summary = simulation_.summary();
    if (summary.stands_before) return;
    const std::string text =
        verdict_text(simulation_.input(), summary) +
        "; what follows is how it falls. To see what comes later, make it stronger, flatter or drier";
    writer_.log(text);
    progress_.say(text);
  }

  /// @return whether the run is over.
  bool advance() {
    if (interrupted()) {
      record_.end_reason = "interrupted";
      return true;
    }
    const couple::Event event = simulation_.advance();
    const couple::Progress progress = simulation_.progress();
    if (event.history) add_rows();
    if (event.label == "onset") note_onset();
    if (event.snapshot) {
      writer_.add_snapshot(simulation_.particles(), event.label);
      writer_.log(progress_.text(progress));
    }
    progress_.show(progress);
    return event.finished;
  }

  void add_rows() {
    writer_.add_history(simulation_.history_row());
    writer_.add_budget(simulation_.budget_row());
  }

  void note_onset() {
    const std::string text = "onset " + onset_text(simulation_.input(), simulation_.summary());
    writer_.log(text);
    progress_.say(text);
    write_summary();
  }

  void finish() {
    record_.end_reason = simulation_.summary().end_reason;
    conclude();
  }

  /// Saves the state that the run was left in.
  ExitCode break_off(const std::string& reason, const std::string& message, ExitCode code) {
    record_.end_reason = reason;
    record_.message = message;
    if (!message.empty()) {
      progress_.clear();
      std::fprintf(stderr, "slope-sim: %s\n", message.c_str());
      writer_.log(message);
    }
    if (simulation_.progress().steps > 0 || reason == "interrupted") {
      writer_.add_snapshot(simulation_.particles(), reason);
    }
    conclude();
    return code;
  }

  void conclude() {
    write_summary();
    const std::string report = report_text(simulation_.input(), simulation_.summary(), record_);
    writer_.log(report);
    if (options_.quiet) return;
    progress_.clear();
    std::fputs(report.c_str(), stdout);
    std::fprintf(stdout, "  %-15s  %s\n", "written to", writer_.folder().c_str());
  }

  void write_summary() {
    record_.wall_time = progress_.elapsed();
    writer_.write_summary(simulation_.input(), simulation_.summary(), record_);
  }

  const RunOptions& options_;
  std::vector<couple::Problem> warnings_;  // of the case
  couple::Simulation simulation_;
  RunWriter writer_;
  ProgressLine progress_;
  RunRecord record_;
};

}  // namespace

ExitCode run(const RunOptions& options) {
  catch_interruptions();
  return Run(options).execute();
}

}  // namespace slope::tools
