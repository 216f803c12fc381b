#pragma once

#include <cstdint>
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
  /// Goes on with an earlier file, of which it keeps the first bytes.
  /// @throws couple::FileError if the file has less, or cannot be written.
  HistoryFile(const std::filesystem::path& file, std::uintmax_t kept_bytes);
  /// @throws couple::FileError if the file cannot be written.
  void add(const std::vector<double>& row);
  /// Length of the file (bytes); all of it is on the disk after this.
  /// @throws couple::FileError if it cannot be brought there.
  [[nodiscard]] std::uintmax_t synchronise();

 private:
  void end_line();

  std::filesystem::path file_;
  std::ofstream stream_;
};

}  // namespace slope::tools
