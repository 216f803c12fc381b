#pragma once

#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "run_folder.hpp"

namespace slope::tools {

/// What a run does not tell.
inline constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// A failure zone, as slope-sim's summary gives it.
struct ZoneFigures {
  double length = nothing;   ///< (m)
  double height = nothing;   ///< (m)
  double area = nothing;     ///< (m2)
  double highest = nothing;  ///< y of its highest point (m)
  double suction = nothing;  ///< largest that is left in the slope (Pa)
};

/// The figures of one run that reports and comparisons are made of.
struct RunFigures {
  double onset = nothing;                       ///< by the case's own criterion (s)
  double runaway = nothing;                     ///< when the motion ran away (s)
  double run_out = nothing;                     ///< advance beyond the first toe, at the end (m)
  double horizontal = nothing;                  ///< largest horizontal displacement at the end (m)
  double slid = nothing;                        ///< area that slid, at the end (m2)
  std::string verdict;                          ///< empty: the summary does not tell
  std::map<double, double> displacement_times;  ///< time (s) at which a displacement (m) was passed
  double x = nothing, y = nothing;              ///< where the soil had moved most at onset (m)
  double suction_there = nothing;               ///< (Pa)
  ZoneFigures early;                            ///< when 10 cm have moved
  ZoneFigures last;                             ///< at the end
  double conductivity = nothing;                ///< of the first soil (m/s)
  double displacement = nothing;                ///< largest at the end (m)
  double end = nothing;                         ///< (s)
  double budget = nothing;                      ///< error of the water budget (-)

  /// @return nothing if the displacement (m) was not passed
  [[nodiscard]] double time_of(double displacement_passed) const;
};

/// Reads summary.json and the particles at the onset.
/// @throws couple::FileError if a file cannot be read.
[[nodiscard]] RunFigures figures_of(const RunFolder& run);

/// Writes a table of runs, side by side, in Markdown: when what had moved, the failure zone, the suction left. A run's
/// name is the title of its case; changes of the onset are against the first run.
/// @throws couple::FileError if a file cannot be read or written.
void write_comparison(const std::vector<std::filesystem::path>& folders, const std::filesystem::path& file);

}  // namespace slope::tools
