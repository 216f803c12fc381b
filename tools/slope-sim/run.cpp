#include "run.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdlib.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <optional>

#include "checkpoint_request.hpp"
#include "interruption.hpp"
#include "progress_line.hpp"
#include "report.hpp"
#include "run_writer.hpp"
#include "slope/couple/read_case.hpp"
#include "slope/couple/results.hpp"
#include "slope/couple/simulation.hpp"
#include "standard_streams.hpp"

namespace slope::tools {

namespace {

/// A folder that is gone at the end.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "slope-safety-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw couple::FileError(name + ": cannot be made");
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

constexpr double cost_factor = 100.0;  // times the wall time of a checkpoint that passes before the next at least

/// Of the case file or, if there is none, of the folder.
couple::Case read_case_of(const RunOptions& options, std::vector<couple::Problem>& warnings) {
  if (!options.case_file.empty()) return couple::read_case(options.case_file, options.overrides, &warnings);
  if (!std::filesystem::exists(options.folder / "checkpoint.bin")) {
    throw couple::FileError(
        fmt::format("{}: holds no run that could be resumed: there is no checkpoint.bin", options.folder.string()));
  }
  return couple::read_case(options.folder / "case.yaml");
}

/// That which begins, or goes on from a checkpoint.
couple::Simulation make_simulation(const couple::Case& input, const std::optional<couple::Checkpoint>& checkpoint,
                                   int threads) {
  if (checkpoint) couple::require_case_of(*checkpoint, RunWriter::case_in_folder(input));
  if (!checkpoint || !started(*checkpoint)) return couple::Simulation(input, threads);
  return couple::Simulation(input, checkpoint->state, threads);
}

/// One run: the simulation, where its results go, and what is shown of it.
class Run {
 public:
  explicit Run(const RunOptions& options)
      : options_(options),
        input_(read_case_of(options, warnings_)),
        writer_(usable(options.folder, input_), options.earlier),
        simulation_(make_simulation(input_, writer_.checkpoint(), options.threads)),
        progress_(input_.stop.time, options.quiet) {
    if (writer_.checkpoint()) {
      input_.path = writer_.checkpoint()->case_path;
      earlier_time_ = wall_time_of(*writer_.checkpoint());
    }
  }

  ExitCode execute() {
    try {
      return carry_out();
    } catch (const couple::FileError& error) {
      leave_word(error.what());
      throw;
    }
  }

 private:
  ExitCode carry_out() {
    log_beginning();
    const bool goes_on = writer_.checkpoint() && started(*writer_.checkpoint());
    const bool over = goes_on && is_over();
    if (over && !simulation_.asks_for_safety()) {
      if (!has_summary()) write_summary();
      progress_.say(fmt::format("{}: the run has come to its end already", writer_.folder().string()));
      return ExitCode::fine;
    }
    if (!writer_.checkpoint()) writer_.write_case(input_);
    try {
      if (goes_on ? resume() : start()) {
        while (!over && !advance()) {
        }
      }
    } catch (const couple::SimulationError& error) {
      // that soil in free fall cannot be computed any more does not change what is known of the slope
      const bool known = !simulation_.summary().stands_before;
      broken_off_ = couple::EndReason::error;
      message_ = error.what();
      return break_off(known ? ExitCode::fine : ExitCode::broken_physics);
    }
    if (broken_off_) return break_off(ExitCode::interrupted);
    conclude();
    write_checkpoint();
    return ExitCode::fine;
  }

  /// The summary tells why the run ended, if the disk takes that much.
  void leave_word(const std::string& message) {
    broken_off_ = couple::EndReason::error;
    message_ = message;
    try {
      write_summary();
    } catch (const couple::FileError&) {  // what is on disk is as far as it came
    }
  }

  void log_beginning() {
    writer_.log(fmt::format("slope-sim {}, {:%Y-%m-%d %H:%M:%S} UTC", SLOPE_VERSION, fmt::gmtime(std::time(nullptr))));
    writer_.log(fmt::format("case {}", input_.path));
    for (const std::string& assignment : options_.overrides) writer_.log(fmt::format("--set {}", assignment));
    writer_.log(fmt::format("{} thread{}", options_.threads, options_.threads == 1 ? "" : "s"));
    for (const couple::Problem& warning : warnings_) {
      writer_.log("warning: " + warning.text());
      progress_.say("warning: " + warning.text());
    }
  }

  /// Goes on where the checkpoint was written.
  bool resume() {
    writer_.resume();
    has_started_ = true;
    progress_.begin_steps();
    const std::string text = "resumed at " + progress_.text(simulation_.progress());
    writer_.log(text);
    progress_.say(text);
    write_summary();
    if (!simulation_.asks_for_safety()) return true;
    if (is_over()) return add_snapshot("end");
    return add_snapshot(simulation_.progress().steps == 0 ? "start" : "");
  }

  [[nodiscard]] bool is_over() const { return simulation_.summary().end_reason != couple::EndReason::running; }

  /// @return whether the initial state was found, and not interrupted.
  bool start() {
    write_checkpoint();
    write_summary();
    progress_.say("initial state");
    const bool found = simulation_.initialise([this](const couple::InitialProgress& progress) {
      progress_.show(progress);
      return !interrupted();
    });
    if (!found) {
      broken_off_ = couple::EndReason::interrupted;
      message_ = "interrupted before the start: the initial state is as far as it came";
      return false;
    }
    progress_.begin_steps();
    writer_.log(
        fmt::format("{:.1f} s: initial state of {} particles", progress_.elapsed(), simulation_.summary().particles));
    tell_of_unbalanced_start();
    writer_.begin_history(simulation_.history_columns());
    writer_.begin_budget(couple::Simulation::budget_columns());
    add_rows();
    has_started_ = true;
    if (!add_snapshot("start")) return false;
    write_checkpoint();
    write_summary();
    return true;
  }

  /// The verdict on a slope that falls by itself comes before what shows how.
  void tell_of_unbalanced_start() {
    const couple::Summary summary = simulation_.summary();
    if (summary.stands_before) return;
    const std::string text =
        verdict_text(input_, summary) +
        "; what follows is how it falls. To see what comes later, make it stronger, flatter or drier";
    writer_.log(text);
    progress_.say(text);
  }

  /// @return whether the run is over.
  bool advance() {
    if (interrupted()) {
      broken_off_ = couple::EndReason::interrupted;
      return true;
    }
    const couple::Event event = simulation_.advance();
    const couple::Progress progress = simulation_.progress();
    if (event.history) add_rows();
    if (event.label == "onset") note_onset();
    if (event.snapshot) {
      if (!add_snapshot(event.label)) return true;
      writer_.log(progress_.text(progress));
    }
    progress_.show(progress);
    if (!event.finished) keep_safe();
    return event.finished;
  }

  /// Writes the particles as they are, and if the factor of safety is asked for, finds it and writes how they would
  /// flow. @return whether it did; if not, it was interrupted, and a run that goes on does it then.
  bool add_snapshot(const std::string& label) {
    couple::ParticleTable table = simulation_.particles();
    if (simulation_.asks_for_safety()) {
      const auto mechanism = simulation_.find_safety([this](const couple::InitialProgress& progress) {
        progress_.show(progress);
        return !interrupted();
      });
      if (!mechanism) {
        broken_off_ = couple::EndReason::interrupted;
        return false;
      }
      note_safety();
      table.internal.push_back({"mechanism_speed", "-", mechanism->speed});
      table.internal.push_back({"mechanism_shear_strain", "-", mechanism->shear_strain});
    }
    writer_.add_snapshot(table, label);
    return true;
  }

  void note_safety() {
    const couple::FactorOfSafety found = simulation_.summary().safety.back();
    writer_.add_safety(found);
    const std::string text = "factor of safety " + safety_text(found);
    writer_.log(text);
    progress_.say(text);
  }

  /// Writes a checkpoint if it is time to, or somebody asked for it.
  void keep_safe() {
    const double since = progress_.elapsed() - last_checkpoint_;
    const bool asked = checkpoint_requested();
    if (!asked && since < std::max(options_.checkpoint_interval, cost_factor * checkpoint_cost_)) return;
    write_checkpoint();
    if (asked) writer_.log("checkpoint on request: " + progress_.text(simulation_.progress()));
  }

  void write_checkpoint() {
    const double begin = progress_.elapsed();
    writer_.write_checkpoint(input_, simulation_.state(), has_started_, earlier_time_ + begin);
    last_checkpoint_ = progress_.elapsed();
    checkpoint_cost_ = last_checkpoint_ - begin;
  }

  void add_rows() {
    writer_.add_history(simulation_.history_row());
    writer_.add_budget(simulation_.budget_row());
  }

  void note_onset() {
    const std::string text = "onset " + onset_text(input_, simulation_.summary());
    writer_.log(text);
    progress_.say(text);
    write_summary();
  }

  /// Saves the state that the run was left in.
  ExitCode break_off(ExitCode code) {
    if (has_started_) write_checkpoint();
    if (!message_.empty()) {
      progress_.clear();
      std::fprintf(stderr, "slope-sim: %s\n", message_.c_str());
      writer_.log(message_);
    }
    if (simulation_.progress().steps > 0 || broken_off_ == couple::EndReason::interrupted) {
      writer_.add_snapshot(simulation_.particles(), couple::text_of(*broken_off_));
    }
    conclude();
    return code;
  }

  void conclude() {
    const couple::RunSummary run = summary();
    writer_.write_summary(run);
    const std::string report = report_text(input_, run);
    writer_.log(report);
    if (options_.quiet) return;
    progress_.clear();
    say(options_.tells_safety ? safety_report_text(input_, run) : report);
    if (!options_.keeps_nothing) say(fmt::format("  {:<15}  {}\n", "written to", writer_.folder().string()));
  }

  /// What the run has come to by now.
  [[nodiscard]] couple::RunSummary summary() const {
    couple::RunSummary run = couple::run_summary(input_, simulation_.summary());
    if (broken_off_) run.found.end_reason = *broken_off_;
    run.message = message_;
    run.threads = static_cast<std::size_t>(options_.threads);
    run.wall_time = earlier_time_ + progress_.elapsed();
    return run;
  }

  void write_summary() { writer_.write_summary(summary()); }

  /// Whether the folder has one that is whole.
  [[nodiscard]] bool has_summary() const {
    try {
      static_cast<void>(couple::read_summary(writer_.folder() / "summary.json"));
      return true;
    } catch (const couple::FileError&) {
      return false;
    }
  }

  const RunOptions& options_;
  std::vector<couple::Problem> warnings_;  // of the case
  couple::Case input_;
  RunWriter writer_;
  couple::Simulation simulation_;
  ProgressLine progress_;
  std::optional<couple::EndReason> broken_off_;           // by what, before its end
  std::string message_;                                   // why
  bool has_started_ = false;                              // the initial state has been found
  double earlier_time_ = 0.0;                             // wall time before this program went on with the run (s)
  double last_checkpoint_ = 0.0, checkpoint_cost_ = 0.0;  // wall time when it was done, and that it took (s)
};

}  // namespace

ExitCode run(const RunOptions& options) {
  catch_interruptions();
  catch_checkpoint_requests();
  return Run(options).execute();
}

ExitCode tell_safety(RunOptions options) {
  const couple::SafetyQuestions asked = couple::read_case(options.case_file, options.overrides).safety;
  if (asked.times.empty() && asked.interval == couple::never) options.overrides.push_back("safety.times=[0 s]");
  if (asked.interval == couple::never) {
    constexpr double no_time = 1.0e-6;  // s
    const double last = asked.times.empty() ? 0.0 : std::ranges::max(asked.times);
    options.overrides.push_back(fmt::format("stop.time={} s", std::max(last, no_time)));
  }
  if (!options.folder.empty()) return run(options);
  const TemporaryFolder folder;
  options.folder = folder.path();
  options.keeps_nothing = true;
  return run(options);
}

}  // namespace slope::tools
