#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "csv_table.hpp"
#include "particle_file.hpp"
#include "slope/couple/case.hpp"

namespace slope::tools {

/// What slope-sim left in an output folder.
struct RunFolder {
  std::filesystem::path path;
  couple::Case input;
  std::vector<Snapshot> snapshots;  ///< at least one
  CsvTable history;                 ///< columns "name [unit]", the first is the time (s)
  std::optional<double> onset;      ///< of failure (s)
};

/// Reads case.yaml, particles.pvd, history.csv and, where the run came to its end, summary.json.
/// @throws couple::FileError if one is missing or cannot be read, couple::InputError if case.yaml is no case.
[[nodiscard]] RunFolder read_run_folder(const std::filesystem::path& path);

/// The snapshot nearest to a time.
[[nodiscard]] const Snapshot& nearest_snapshot(const std::vector<Snapshot>& snapshots, double time);

}  // namespace slope::tools
