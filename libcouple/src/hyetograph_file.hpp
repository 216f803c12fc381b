#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "slope/couple/case.hpp"

namespace slope::couple {

/// Reads a CSV file of rain: a header that names time and intensity with their units, such as
/// "time_h,intensity_mm_per_h" (time in s, min, h or d; intensity in mm or m per s, h or d), then a row for each
/// time from which an intensity holds. Lines that begin with '#' are comments.
/// @return the steps in SI units, or what is wrong with the file ("storm.csv:3: ...")
[[nodiscard]] std::variant<std::vector<RainStep>, std::string> read_hyetograph(const std::filesystem::path& file);

}  // namespace slope::couple
