#pragma once

#include <array>
#include <filesystem>
#include <vector>

namespace slope::tools {

/// The points of the one poly-line of a VTK PolyData file (.vtp), from left to right: x and y as in a case (m).
/// @throws couple::FileError if the file cannot be read; couple::InputError if it does not hold one poly-line that runs
///         from left to right or back.
[[nodiscard]] std::vector<std::array<double, 2>> read_poly_line(const std::filesystem::path& file);

/// Writes a line as the table that a case reads: columns x_m and y_m.
/// @throws couple::FileError if it cannot be written.
void write_profile(const std::filesystem::path& file, const std::vector<std::array<double, 2>>& line);

}  // namespace slope::tools
