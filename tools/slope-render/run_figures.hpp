#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "run_folder.hpp"

namespace slope::tools {

/// What a run does not tell.
inline constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// The figures of one run that reports and comparisons are made of: its summary, and what the run folder tells beside.
struct RunFigures {
  couple::Summary found;
  double onset = nothing;           ///< by the case's own criterion (s)
  double x = nothing, y = nothing;  ///< where the soil had moved most at onset (m)
  double suction_there = nothing;   ///< (Pa)
  couple::FailureZone early, last;  ///< when 10 cm have moved, and at the end; nothing where there was none
  double conductivity = nothing;    ///< of the first soil (m/s)

  /// @return nothing if the displacement (m) was not passed
  [[nodiscard]] double time_of(double displacement_passed) const;
};

/// @throws couple::FileError if the run has no summary or the particles at the onset cannot be read.
[[nodiscard]] RunFigures figures_of(const RunFolder& run);

/// Writes a table of runs, side by side, in Markdown: when what had moved, the failure zone, the suction left. A run's
/// name is the title of its case; changes of the onset are against the first run.
/// @return what of the summaries is not understood
/// @throws couple::FileError if a file cannot be read or written.
std::vector<std::string> write_comparison(const std::vector<std::filesystem::path>& folders,
                                          const std::filesystem::path& file);

}  // namespace slope::tools
