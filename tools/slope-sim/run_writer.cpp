#include "run_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <string>
#include <utility>

#include "slope/couple/read_case.hpp"
#include "text_file.hpp"

namespace slope::tools {

namespace {

namespace fs = std::filesystem;

constexpr std::array run_files{"case.yaml",     "log.txt",           "history.csv",    "budget.csv",
                               "safety.csv",    "summary.json",      "checkpoint.bin", "summary.json.tmp",
                               "case.yaml.tmp", "checkpoint.bin.tmp"};
constexpr std::string_view log_mark = "slope-sim ";  // with which every log begins

// Notes of a checkpoint.
constexpr const char* note_started = "started";
constexpr const char* note_history = "history bytes";
constexpr const char* note_budget = "budget bytes";
constexpr const char* note_safety = "safety bytes";
constexpr const char* note_particles = "particle files";
constexpr const char* note_wall_time = "wall time (s)";

bool is_particle_file(const fs::path& file) {
  const std::string name = file.filename().string();
  return name.starts_with("particles") && (name.ends_with(".vtp") || name.ends_with(".pvd") || name.ends_with(".part"));
}

bool is_run_file(const fs::path& file) {
  return std::ranges::find(run_files, file.filename().string()) != run_files.end() || is_particle_file(file);
}

/// A run begins its log before anything else, with its name. One that was killed at once has left it empty.
bool holds_run(const fs::path& folder) {
  if (!fs::is_regular_file(folder / "log.txt")) return false;
  std::ifstream log(folder / "log.txt", std::ios::binary);
  std::string beginning(log_mark.size(), ' ');
  log.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  return log.gcount() == 0 || beginning == log_mark;
}

/// The reference of the figures, as the case names it.
fs::path reference_of(const couple::Case& input) {
  return fs::path(input.path).parent_path() / input.figures.profile_reference;
}

/// What it is called in the folder of the run: not as one of our own files.
std::string reference_name(const couple::Case& input) {
  const fs::path name = fs::path(input.figures.profile_reference).filename();
  return (is_run_file(name) ? "reference_" : "") + name.string();
}

void remove_run(const fs::path& folder) {
  for (const char* name : run_files) fs::remove(folder / name);
  std::vector<fs::path> particle_files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (is_particle_file(entry.path())) particle_files.push_back(entry.path());
  }
  for (const fs::path& file : particle_files) fs::remove(file);
}

/// @return whether there is an earlier run to go on with
bool prepare(const fs::path& folder, EarlierRun earlier) {
  if (fs::is_empty(folder)) return false;
  if (!holds_run(folder)) {
    throw couple::FileError(
        fmt::format("{}: holds something else than a run of slope-sim; choose another folder", folder.string()));
  }
  if (earlier == EarlierRun::refuse) {
    throw couple::FileError(
        fmt::format("{}: holds an earlier run; --resume goes on with it, --overwrite replaces it", folder.string()));
  }
  if (earlier == EarlierRun::resume && fs::exists(folder / "checkpoint.bin")) return true;
  remove_run(folder);
  return false;
}

double note(const couple::Checkpoint& checkpoint, const char* name) {
  const auto found = checkpoint.notes.find(name);
  if (found == checkpoint.notes.end())
    throw couple::FileError(fmt::format("the checkpoint does not tell \"{}\"", name));
  return found->second;
}

}  // namespace

fs::path usable(const fs::path& folder, const couple::Case& input) {
  std::error_code error;
  if (input.figures.profile_reference.empty()) return folder;
  const fs::path reference = fs::canonical(reference_of(input), error);
  if (!error && is_run_file(reference) && fs::equivalent(reference.parent_path(), folder, error)) {
    throw couple::FileError(
        fmt::format("{}: would be replaced by the run's own; choose another output folder, or give "
                    "the reference of the figures another name",
                    reference.string()));
  }
  return folder;
}

bool started(const couple::Checkpoint& checkpoint) {
  return note(checkpoint, note_started) != 0.0;
}

double wall_time_of(const couple::Checkpoint& checkpoint) {
  return note(checkpoint, note_wall_time);
}

RunWriter::RunWriter(fs::path folder, EarlierRun earlier) : folder_(std::move(folder)) {
  bool goes_on = false;
  try {
    fs::create_directories(folder_);
    lock_.emplace(folder_);
    goes_on = prepare(folder_, earlier);
  } catch (const fs::filesystem_error& error) {
    throw couple::FileError(
        fmt::format("{}: cannot be used as output folder: {}", folder_.string(), error.code().message()));
  }
  if (goes_on) checkpoint_ = couple::read_checkpoint(folder_ / "checkpoint.bin");
  errno = 0;
  log_.open(folder_ / "log.txt", goes_on ? std::ios::app : std::ios::trunc);
  if (!log_)
    throw couple::FileError(fmt::format("{}: cannot be written: {}", (folder_ / "log.txt").string(), system_message()));
  if (!goes_on) particles_.emplace(folder_);
  if (goes_on && !started(*checkpoint_)) particles_.emplace(folder_, 0);
}

couple::Case RunWriter::case_in_folder(couple::Case input) {
  input.figures.profile_reference = reference_name(input);
  return input;
}

void RunWriter::write_case(const couple::Case& input) {
  if (!input.figures.profile_reference.empty()) {
    const fs::path source = reference_of(input);
    const fs::path copy = folder_ / reference_name(input);
    std::error_code error;
    if (!fs::equivalent(source, copy, error)) {
      fs::copy_file(source, copy, fs::copy_options::overwrite_existing, error);
      if (error)
        throw couple::FileError(
            fmt::format("{}: cannot be copied to {}: {}", source.string(), folder_.string(), error.message()));
    }
  }
  write_at_once(folder_ / "case.yaml", couple::resolved_yaml(case_in_folder(input)));
}

void RunWriter::resume() {
  const auto count = [this](const char* name) { return static_cast<std::size_t>(note(checkpoint_.value(), name)); };
  particles_.emplace(folder_, count(note_particles));
  synchronised_ = particles_->written().size();
  history_.emplace(folder_ / "history.csv", count(note_history));
  budget_.emplace(folder_ / "budget.csv", count(note_budget));
  if (count(note_safety) > 0) safety_.emplace(folder_ / "safety.csv", count(note_safety));
}

void RunWriter::write_checkpoint(const couple::Case& input, couple::SimulationState state, bool started,
                                 double wall_time) {
  // what a checkpoint counts on has to be on the disk before it is
  const std::vector<Snapshot>& snapshots = particles_.value().written();
  if (synchronised_ < snapshots.size()) synchronise_file(folder_ / particle_collection);
  for (; synchronised_ < snapshots.size(); ++synchronised_) synchronise_file(snapshots[synchronised_].file);
  const auto length = [](std::optional<HistoryFile>& file) {
    return file ? static_cast<double>(file->synchronise()) : 0.0;
  };
  couple::Checkpoint checkpoint;
  checkpoint.case_path = input.path;
  checkpoint.case_text = couple::resolved_yaml(case_in_folder(input));
  checkpoint.notes = {{note_started, started ? 1.0 : 0.0},
                      {note_history, length(history_)},
                      {note_budget, length(budget_)},
                      {note_safety, length(safety_)},
                      {note_particles, static_cast<double>(snapshots.size())},
                      {note_wall_time, wall_time}};
  checkpoint.state = std::move(state);
  couple::write_checkpoint(folder_ / "checkpoint.bin", checkpoint);
}

void RunWriter::begin_history(const std::vector<couple::HistoryColumn>& columns) {
  history_.emplace(folder_ / "history.csv", columns);
}

void RunWriter::add_history(const std::vector<double>& row) {
  history_.value().add(row);
}

void RunWriter::begin_budget(const std::vector<couple::HistoryColumn>& columns) {
  budget_.emplace(folder_ / "budget.csv", columns);
}

void RunWriter::add_budget(const std::vector<double>& row) {
  budget_.value().add(row);
}

void RunWriter::add_safety(const couple::FactorOfSafety& found) {
  if (!safety_) {
    safety_.emplace(folder_ / "safety.csv", std::vector<couple::HistoryColumn>{{"time", "s"},
                                                                               {"factor of safety", "-"},
                                                                               {"lower", "-"},
                                                                               {"upper", "-"},
                                                                               {"trials", "-"},
                                                                               {"area", "m2"},
                                                                               {"depth", "m"}});
  }
  safety_->add({found.time, found.factor, found.lower, found.upper.value_or(couple::never),
                static_cast<double>(found.trials), found.area, found.depth});
}

void RunWriter::add_snapshot(const couple::ParticleTable& particles, std::string_view label) {
  particles_.value().write(particles, label);
}

void RunWriter::write_summary(const couple::RunSummary& summary) {
  write_at_once(folder_ / "summary.json", couple::summary_json(summary));
}

void RunWriter::log(std::string_view lines) {
  errno = 0;
  log_ << lines << '\n' << std::flush;
  if (!log_)
    throw couple::FileError(fmt::format("{}: cannot be written: {}", (folder_ / "log.txt").string(), system_message()));
}

}  // namespace slope::tools
