#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace slope::testing {

/// A CSV file of numbers. Lines that begin with '#' are comments; the column names stand in the first line without '#'
/// or, where that line holds numbers already, in the last comment line.
class Table {
 public:
  /// @throws std::runtime_error naming file and line if the file cannot be read or a row does not fit.
  explicit Table(const std::filesystem::path& file);

  /// @throws std::out_of_range naming the columns there are.
  [[nodiscard]] const std::vector<double>& column(std::string_view name) const;
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  [[nodiscard]] std::size_t rows() const { return columns_.empty() ? 0 : columns_.front().size(); }

 private:
  std::filesystem::path file_;
  std::vector<std::string> names_;
  std::vector<std::vector<double>> columns_;
};

/// A file below tests/reference/, e.g. reference("terzaghi/terzaghi_U.csv").
[[nodiscard]] Table reference(const std::filesystem::path& file);

}  // namespace slope::testing
