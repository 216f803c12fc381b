#pragma once

#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>
#include <vector>

#include "history_file.hpp"
#include "particle_file.hpp"
#include "slope/couple/case.hpp"
#include "slope/couple/simulation.hpp"
#include "summary_json.hpp"

namespace slope::tools {

/// The output folder of a run: case.yaml, log.txt, history.csv, budget.csv, summary.json, particles_*.vtp and
/// particles.pvd. Every function throws couple::FileError if the disk does not take what it gives.
class RunWriter {
 public:
  /// Makes the folder. One that holds an earlier run is used again, and the files of that run are removed; one that
  /// holds anything else is refused.
  explicit RunWriter(std::filesystem::path folder);

  /// The case with all defaults, and a copy of its reference file, so that the folder stands on its own.
  void write_case(couple::Case input);
  void begin_history(const std::vector<couple::HistoryColumn>& columns);
  void add_history(const std::vector<double>& row);
  void begin_budget(const std::vector<couple::HistoryColumn>& columns);
  void add_budget(const std::vector<double>& row);
  void add_snapshot(const couple::ParticleTable& particles, std::string_view label);
  void write_summary(const couple::Case& input, const couple::Summary& summary, const RunRecord& record);
  /// A line, or several, of log.txt.
  void log(std::string_view lines);

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
  std::ofstream log_;
  std::optional<ParticleFileSeries> particles_;
  std::optional<HistoryFile> history_, budget_;
};

}  // namespace slope::tools
