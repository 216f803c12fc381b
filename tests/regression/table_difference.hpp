#pragma once

#include <string>
#include <vector>

#include "slope/testing/table.hpp"
#include "tolerances.hpp"

namespace slope::testing {

/// Where a column is farthest from its reference, measured by its tolerance.
struct Deviation {
  std::string column;
  double along = 0.0;      ///< place on the curve, or the row's number from 0
  double value = 0.0;      ///< nearest to the reference that the tolerance along the curve lets one choose
  double reference = 0.0;  ///< there
  double share = 0.0;      ///< difference over tolerance: more than 1, or NaN, is too far
};

/// The worst of each column that is compared; that along which the others are curves comes first, with its ends.
/// @throws std::out_of_range if a column is missing; std::runtime_error if tables without such a column differ in
/// length
///         or one is empty.
[[nodiscard]] std::vector<Deviation> deviations(const Table& actual, const Table& reference,
                                                const TableTolerances& tolerances);

/// Those that are too far, a line for each; empty: the table has come close enough.
[[nodiscard]] std::string complaints(const std::vector<Deviation>& deviations);

}  // namespace slope::testing
