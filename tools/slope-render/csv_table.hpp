#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace slope::tools {

/// A table of numbers with a header row.
struct CsvTable {
  std::vector<std::string> names;
  std::vector<std::vector<double>> columns;  ///< as many as names, all equally long
};

/// Reads a CSV file. Lines that begin with '#' are comments, but for the last one before the numbers if no header
/// stands there without '#'. A last row that is incomplete, as a killed run leaves it, is left out.
/// @throws couple::FileError if the file cannot be read or is no such table.
[[nodiscard]] CsvTable read_csv(const std::filesystem::path& file);

}  // namespace slope::tools
