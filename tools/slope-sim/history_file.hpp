#pragma once

#include <filesystem>
#include <fstream>
#include <vector>

#include "slope/couple/simulation.hpp"

namespace slope::tools {

/// The histories of a run as CSV: a header "name [unit]", then a row per time, on disk as soon as it is written.
class HistoryFile {
 public:
  /// @throws couple::FileError if the file cannot be written.
  HistoryFile(const std::filesystem::path& file, const std::vector<couple::HistoryColumn>& columns);
  /// @throws couple::FileError if the file cannot be written.
  void add(const std::vector<double>& row);

 private:
  void end_line();

  std::filesystem::path file_;
  std::ofstream stream_;
};

}  // namespace slope::tools
