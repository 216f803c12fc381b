#pragma once

#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>
#include <vector>

#include "folder_lock.hpp"
#include "history_file.hpp"
#include "particle_file.hpp"
#include "slope/couple/case.hpp"
#include "slope/couple/checkpoint.hpp"
#include "slope/couple/results.hpp"
#include "slope/couple/simulation.hpp"

namespace slope::tools {

/// What becomes of an earlier run that lies in the output folder.
enum class EarlierRun { refuse, overwrite, resume };

/// An output folder, unless the run would put a file of its own in the place of one that its case needs.
/// @throws couple::FileError if it would.
[[nodiscard]] std::filesystem::path usable(const std::filesystem::path& folder, const couple::Case& input);

/// The output folder of a run: case.yaml, log.txt, history.csv, budget.csv, safety.csv, summary.json, particles_*.vtp,
/// particles.pvd and checkpoint.bin. Every function throws couple::FileError if the disk does not take what it gives.
class RunWriter {
 public:
  /// Makes the folder, and keeps other runs out of it. One that holds anything else than an earlier run is refused. An
  /// earlier run that is to be resumed, and has written a checkpoint, is left as it is; else its files are removed.
  RunWriter(std::filesystem::path folder, EarlierRun earlier);

  /// The checkpoint to go on from; none: the run begins.
  [[nodiscard]] const std::optional<couple::Checkpoint>& checkpoint() const { return checkpoint_; }
  /// The case as it lies in the folder.
  [[nodiscard]] static couple::Case case_in_folder(couple::Case input);

  /// The case with all defaults, and a copy of its reference file, so that the folder stands on its own.
  void write_case(const couple::Case& input);
  void begin_history(const std::vector<couple::HistoryColumn>& columns);
  void begin_budget(const std::vector<couple::HistoryColumn>& columns);
  /// Goes on with the files of the earlier run up to its checkpoint, and removes what came later.
  void resume();
  void add_history(const std::vector<double>& row);
  void add_budget(const std::vector<double>& row);
  /// Of a case that asks for it, in safety.csv.
  void add_safety(const couple::FactorOfSafety& found);
  void add_snapshot(const couple::ParticleTable& particles, std::string_view label);
  void write_summary(const couple::RunSummary& summary);
  /// @param started  whether the initial state has been found; if not, the run has to begin anew
  /// @param wall_time  that the run has taken (s)
  void write_checkpoint(const couple::Case& input, couple::SimulationState state, bool started, double wall_time);
  /// A line, or several, of log.txt.
  void log(std::string_view lines);

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
  std::optional<FolderLock> lock_;
  std::optional<couple::Checkpoint> checkpoint_;
  std::ofstream log_;
  std::optional<ParticleFileSeries> particles_;
  std::optional<HistoryFile> history_, budget_, safety_;
  std::size_t synchronised_ = 0;  // particle files that are on the disk
};

/// Whether the initial state had been found at a checkpoint, and the wall time that the run had taken until then (s).
[[nodiscard]] bool started(const couple::Checkpoint& checkpoint);
[[nodiscard]] double wall_time_of(const couple::Checkpoint& checkpoint);

}  // namespace slope::tools
