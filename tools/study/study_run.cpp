#include "study_run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <set>

#include "design.hpp"
#include "dotted_keys.hpp"
#include "folder_lock.hpp"
#include "interruption.hpp"
#include "read_study.hpp"
#include "run_outcome.hpp"
#include "slope/couple/results.hpp"
#include "slope/couple/text_file.hpp"
#include "standard_streams.hpp"
#include "study_figures.hpp"
#include "text_file.hpp"

namespace slope::tools {

namespace {

namespace fs = std::filesystem;

constexpr const char* study_name = "study.yaml";
constexpr const char* case_name = "case.yaml";
constexpr std::size_t most_bytes = 4'000'000;

/// Refuses a folder that holds something else, or another study.
void require(bool same, const fs::path& file, const char* what) {
  if (same) return;
  throw couple::FileError(fmt::format(
      "{}: {} has changed since the study in this folder was begun; choose another folder, or remove this one",
      file.string(), what));
}

/// The folder of a study, in which no other is at work.
class StudyFolder {
 public:
  StudyFolder(const fs::path& folder, const StudyInput& input) : path_(made(folder)), lock_(path_) {
    const std::string study = resolved_yaml(input), base = couple::resolved_yaml(input.base);
    const fs::path study_file = path_ / study_name, case_file = path_ / case_name;
    const auto content = [](const fs::path& file) { return couple::read_text_file(file, most_bytes); };
    if (fs::exists(study_file)) {
      require(lasting_part(content(study_file)) == lasting_part(study), study_file, "the study");
      if (fs::exists(case_file)) require(content(case_file) == base, case_file, "the case");
    } else {
      require_empty();
    }
    write_at_once(study_file, study);
    write_at_once(case_file, base);
  }

  [[nodiscard]] const fs::path& path() const { return path_; }
  [[nodiscard]] static std::string run_name(std::size_t sample) { return fmt::format("runs/{:04}", sample + 1); }

 private:
  static fs::path made(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw couple::FileError(fmt::format("{}: cannot be made: {}", folder.string(), error.message()));
    return fs::canonical(folder);
  }

  void require_empty() const {
    for (const fs::directory_entry& entry : fs::directory_iterator(path_)) {
      if (entry.path().stem() == study_name) continue;  // of a study that was killed at once
      throw couple::FileError(
          fmt::format("{}: holds something else than a study of slope-sim; choose another folder", path_.string()));
    }
  }

  fs::path path_;
  FolderLock lock_;
};

class StudyRun {
 public:
  explicit StudyRun(const StudyOptions& options)
      : options_(options),
        input_(read_study(options.file)),
        folder_(options.folder, input_),
        samples_(samples_of(input_.study)) {}

  ExitCode execute() {
    for (std::size_t first = 0; first < samples_.size() && !is_sure_enough(first);) {
      const std::size_t end = std::min(first + batch(), samples_.size());
      const std::vector<std::size_t> pending = pending_of(first, end);
      if (options_.lists && !pending.empty()) {
        for (const std::size_t sample : pending) say(command_of(sample) + '\n');
        return ExitCode::fine;
      }
      if (!pending.empty()) {
        run(pending);
        if (interrupted()) return tell_unfinished(pending, "interrupted");
        const std::vector<std::size_t> left = unfinished_of(pending);
        if (!left.empty()) return tell_unfinished(left, "these runs did not come to their end");
      }
      take_outcomes(first, end);
      first = end;
    }
    if (!options_.lists) conclude();
    return ExitCode::fine;
  }

 private:
  [[nodiscard]] std::size_t batch() const {
    const auto* design = std::get_if<MonteCarlo>(&input_.study.design);
    return design != nullptr ? static_cast<std::size_t>(design->batch) : samples_.size();
  }

  /// Whether no more samples are needed.
  [[nodiscard]] bool is_sure_enough(std::size_t taken) const {
    const auto* design = std::get_if<MonteCarlo>(&input_.study.design);
    if (design == nullptr || !design->interval_width || taken == 0) return false;
    const auto failure = found_failure(input_.study, outcomes_);
    return failure->runs > 0 && failure->probability.upper - failure->probability.lower <= *design->interval_width;
  }

  [[nodiscard]] fs::path path_of(std::size_t sample) const { return folder_.path() / StudyFolder::run_name(sample); }

  /// Runs of a batch that are not finished. What broke off is tried again, save by who runs the list.
  [[nodiscard]] std::vector<std::size_t> pending_of(std::size_t first, std::size_t end) const {
    std::vector<std::size_t> pending;
    for (std::size_t sample = first; sample < end; ++sample) {
      const RunState state = outcome_of(path_of(sample)).state;
      if (state == RunState::unfinished || (state == RunState::broke_off && !options_.lists)) pending.push_back(sample);
    }
    require_valid(pending);
    return pending;
  }

  [[nodiscard]] std::vector<std::size_t> unfinished_of(std::vector<std::size_t> samples) const {
    std::erase_if(samples,
                  [this](std::size_t sample) { return outcome_of(path_of(sample)).state != RunState::unfinished; });
    return samples;
  }

  /// Before anything is run, the case has to take the values of each sample together.
  void require_valid(const std::vector<std::size_t>& samples) const {
    std::vector<couple::Problem> problems;
    for (const std::size_t sample : samples) {
      try {
        static_cast<void>(couple::read_case(input_.case_file, overrides_of(sample)));
      } catch (const couple::InputError& error) {
        for (const couple::Problem& problem : error.problems()) {
          problems.push_back({input_.file.string(), 0, "parameters",
                              fmt::format("sample {} ({}): {}: {}", sample + 1, fmt::join(assignments_of(sample), ", "),
                                          problem.key, problem.message)});
        }
      }
    }
    constexpr std::size_t most_told = 20;
    if (problems.size() > most_told) {
      const std::size_t more = problems.size() - most_told;
      problems.resize(most_told);
      problems.push_back({input_.file.string(), 0, "parameters", fmt::format("and {} more like these", more)});
    }
    if (!problems.empty()) throw couple::InputError(problems);
  }

  [[nodiscard]] std::vector<std::string> assignments_of(std::size_t sample) const {
    std::vector<std::string> all;
    for (std::size_t j = 0; j < input_.study.parameters.size(); ++j) {
      all.push_back(assignment(input_.study.parameters[j], samples_[sample][j]));
    }
    return all;
  }

  /// Also the times of factors of safety that are asked for, beside those of the case.
  [[nodiscard]] std::vector<std::string> overrides_of(std::size_t sample) const {
    std::vector<std::string> all = assignments_of(sample);
    std::set<double> times;
    for (const Question& question : input_.study.questions) {
      if (question.at) times.insert(*question.at);
    }
    if (times.empty()) return all;
    times.insert(input_.base.safety.times.begin(), input_.base.safety.times.end());
    std::string list;
    for (const double time : times) list += fmt::format("{}{} s", list.empty() ? "" : ", ", time);
    all.push_back("safety.times=[" + list + "]");
    return all;
  }

  /// Of one run, for a shell.
  [[nodiscard]] std::string command_of(std::size_t sample) const {
    const char* command = asks_safety_alone(input_.study) ? "safety" : "run";
    std::string text = fmt::format("{} {} {}", quoted(options_.program.string()), command,
                                   quoted(fs::canonical(input_.case_file).string()));
    for (const std::string& override_text : overrides_of(sample)) text += " --set " + quoted(override_text);
    return text + fmt::format(" -o {} --resume --quiet", quoted(path_of(sample).string()));
  }

  void run(const std::vector<std::size_t>& pending) {
    std::vector<fs::path> folders;
    std::string lines;
    for (const std::size_t sample : pending) {
      folders.push_back(path_of(sample));
      lines += command_of(sample) + '\n';
    }
    wait_for_others(folders);
    const fs::path list = folder_.path() / "jobs.txt";
    write_at_once(list, lines);
    const bool shows = !options_.quiet && isatty(STDERR_FILENO) != 0;
    std::vector<std::size_t> left = pending;
    run_jobs(list, options_.jobs, [&] {
      if (!shows) return;
      left = unfinished_of(left);
      std::fputs(fmt::format("\r{} of {} runs", pending.size() - left.size(), pending.size()).c_str(), stderr);
    });
    wait_for_others(folders);
    if (shows) std::fputs("\r\033[K", stderr);
    std::error_code ignored;
    fs::remove(list, ignored);
  }

  ExitCode tell_unfinished(const std::vector<std::size_t>& samples, const char* why) const {
    const std::vector<std::size_t> left = unfinished_of(samples);
    std::vector<std::string> names;
    for (const std::size_t sample : left) names.push_back(StudyFolder::run_name(sample));
    constexpr std::size_t most_told = 10;
    const std::string more = names.size() > most_told ? fmt::format(" and {} more", names.size() - most_told) : "";
    if (names.size() > most_told) names.resize(most_told);
    std::fputs(
        fmt::format("slope-sim: {}: {}{}; the same command goes on with the study\n", why,
                    names.empty() ? "every run of this batch is finished" : fmt::format("{}", fmt::join(names, ", ")),
                    more)
            .c_str(),
        stderr);
    return ExitCode::interrupted;
  }

  void take_outcomes(std::size_t first, std::size_t end) {
    for (std::size_t sample = first; sample < end; ++sample) outcomes_.push_back(outcome_of(path_of(sample)));
  }

  void conclude() const {
    const Samples taken(samples_.begin(), samples_.begin() + static_cast<std::ptrdiff_t>(outcomes_.size()));
    const StudyResults results = study_results(input_.study, taken, outcomes_);
    std::vector<StudyRow> rows;
    for (std::size_t i = 0; i < taken.size(); ++i) {
      rows.push_back(study_row(input_.study, taken[i], outcomes_[i]));
      rows.back().folder = StudyFolder::run_name(i);
    }
    write_at_once(folder_.path() / "study.csv", study_csv(results, rows));
    write_at_once(folder_.path() / "study.json", study_json(results));
    if (options_.quiet) return;
    say(study_report(results));
    say(fmt::format("  {:<15}  {}\n", "written to", options_.folder.string()));
  }

  const StudyOptions& options_;
  StudyInput input_;
  StudyFolder folder_;
  Samples samples_;
  std::vector<RunOutcome> outcomes_;
};

}  // namespace

ExitCode run_study(const StudyOptions& options) {
  catch_interruptions();
  return StudyRun(options).execute();
}

}  // namespace slope::tools
