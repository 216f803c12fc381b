#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace slope::testing {

/// How far a value may be from its reference: absolute + relative * |reference|.
struct Tolerance {
  double absolute = 0.0;
  double relative = 0.0;

  [[nodiscard]] double at(double reference) const;
};

/// How far a column may be from its reference.
struct ColumnTolerance {
  std::string column;
  Tolerance tolerance;
};

/// How closely a table is compared.
struct TableTolerances {
  /// The column along which the others are curves; it has to end where the reference ends, and a curve may be early or
  /// late by its tolerance. Without it the tables are compared row by row.
  std::optional<ColumnTolerance> along;
  std::vector<ColumnTolerance> columns;

  /// All that are compared, the one along which they run first.
  [[nodiscard]] std::vector<std::string> names() const;
};

/// What is compared of a case, and how closely.
struct Tolerances {
  std::map<std::string, TableTolerances> tables;  ///< by their files
  double picture_threshold = 0.0;                 ///< of PictureDifference::largest
  std::vector<std::string> pictures;              ///< files
};

/// Reads tests/reference/<case>/tolerances.yaml.
/// @throws std::runtime_error naming the file if it cannot be read or lacks something.
[[nodiscard]] Tolerances read_tolerances(const std::filesystem::path& file);

}  // namespace slope::testing
