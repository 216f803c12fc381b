#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "history_chart.hpp"
#include "profile_chart.hpp"
#include "run_folder.hpp"

namespace slope::tools {

/// The cumulative amounts of water that occur (m3 per metre of width), see couple::water_amounts; of those that are the
/// same one. Empty if no water moved.
[[nodiscard]] std::vector<Curve> budget_curves(const CsvTable& budget);
/// Whether a table has any of the water's amounts.
[[nodiscard]] bool has_amounts(const CsvTable& budget);

/// The history's columns "<point> <quantity> [unit]" as curves named after their points.
[[nodiscard]] std::vector<Curve> history_curves(const CsvTable& history, const std::string& quantity);

/// The onset by the criterion that the case did not choose, for a chart; none if there was none.
[[nodiscard]] std::optional<TimeMark> other_onset(const RunFolder& run);

void scale_curves(std::vector<Curve>& curves, double factor);

/// Metres, centimetres or millimetres, whichever gives handy numbers: how many of them are a metre, and their name.
[[nodiscard]] std::pair<double, std::string> length_unit(const std::vector<Curve>& curves);

/// The suction profiles that the case asks for, with their reference. Particles that cannot be drawn are noted.
/// @throws couple::FileError if a file cannot be read.
[[nodiscard]] std::vector<TimedProfile> timed_profiles(const RunFolder& run, Losses& losses);

}  // namespace slope::tools
