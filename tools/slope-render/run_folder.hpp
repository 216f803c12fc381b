#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "csv_table.hpp"
#include "losses.hpp"
#include "particle_file.hpp"
#include "slope/couple/case.hpp"
#include "slope/couple/results.hpp"

namespace slope::tools {

/// What slope-sim left in an output folder.
struct RunFolder {
  std::filesystem::path path;
  couple::Case input;               ///< its path is empty if it is lost
  std::vector<Snapshot> snapshots;  ///< at least one, unless they are lost
  CsvTable history;                 ///< columns "name [unit]", the first is the time (s); empty if it is lost
  CsvTable budget;                  ///< of the water, as the history; empty if the folder has none or it is lost
  std::optional<couple::RunSummary> summary;  ///< none: the folder has none, or it is lost
  std::optional<double> onset;     ///< of failure, by the criterion that the case chose (s); without a summary that of
                                   ///< the snapshot
  std::vector<std::string> notes;  ///< what of another version's summary is not understood
};

/// Reads case.yaml, particles.pvd, history.csv and, if they are there, budget.csv and summary.json.
/// @throws couple::FileError if one is missing or cannot be read, couple::InputError if case.yaml is no case.
[[nodiscard]] RunFolder read_run_folder(const std::filesystem::path& path);

/// The same of a folder that may be damaged: what cannot be read is noted, and values that cannot be drawn are NaN.
/// Where the collection is lost, the particle files are searched for.
/// @throws couple::FileError if there is no folder.
[[nodiscard]] RunFolder read_run_folder(const std::filesystem::path& path, Losses& losses);

/// Creates a folder for pictures, if need be.
/// @throws couple::FileError if that is impossible.
void make_folder(const std::filesystem::path& folder);

/// The snapshot nearest to a time.
[[nodiscard]] const Snapshot& nearest_snapshot(const std::vector<Snapshot>& snapshots, double time);

}  // namespace slope::tools
