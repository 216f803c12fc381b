#pragma once

#include <filesystem>

#include "tolerances.hpp"

namespace slope::testing {

/// Writes the tables that are compared of a run, as they lie in tests/reference/<case>/, into a folder:
///   history.csv     columns of the run's history
///   summary.csv     numbers of its summary.json, in one row; a column's name is the way to the number,
///                   "failure_zone.at_end.length_m", with the index in a list: "onset.position_m.0"
///   profile_60s.csv suction head over height, for each of the times that the case asks for a profile of
/// Those of history and summary are the columns that have a tolerance.
/// @throws std::exception if a file cannot be read or written or lacks a column.
void write_tables(const std::filesystem::path& run, const Tolerances& tolerances, const std::filesystem::path& folder);

}  // namespace slope::testing
