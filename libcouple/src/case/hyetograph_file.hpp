#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "slope/couple/case.hpp"

namespace slope::couple {

/// A table of rain, with what is odd about it.
struct RainTable {
  struct Note {
    int line = 0;  ///< of the file
    std::string message;
  };

  std::vector<RainStep> steps;  ///< each from its time on
  std::vector<Note> warnings;
};

/// Reads a CSV file of rain: a header that names time and intensity with their units, such as
/// "time_h,intensity_mm_per_h" (time in s, min, h or d; intensity in mm or m per s, h or d), then a row for each
/// time from which an intensity holds. Lines that begin with '#' are comments. A cell that is empty or holds a word or
/// a code for a missing value, such as NA or -999, is refused: what fell then has to be said. Of a table with even
/// steps, gaps over which rain is held are odd.
/// @return the steps in SI units, or what is wrong with the file ("storm.csv:3: ...")
[[nodiscard]] std::variant<RainTable, std::string> read_hyetograph(const std::filesystem::path& file);

/// How long the last row of a table lasts: the step that is most frequent between its rows (s); never for one row.
[[nodiscard]] double usual_step(const std::vector<RainStep>& steps);

/// What is odd about an intensity (m/s): more than any rain, or than any air evaporates; none if nothing is.
[[nodiscard]] std::optional<std::string> doubt_about(double intensity);

}  // namespace slope::couple
