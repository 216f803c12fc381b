#pragma once

#include <filesystem>

#include "slope/couple/results.hpp"

namespace slope::tools::test {

/// What slope-sim would say of a slope that failed at some time (s) and came to its end at 640 s.
[[nodiscard]] couple::RunSummary summary_of_a_slide(double onset);
void write_summary(const std::filesystem::path& folder, const couple::RunSummary& summary);

/// What slope-sim would leave of a slope that failed by sliding by `slide` (m), with histories at A1 to C2 and a
/// summary that tells a failure zone of 12.3 m x 6.8 m.
void write_slope_run(const std::filesystem::path& folder, double slide = 0.9);

/// What slope-sim would leave of the Liakopoulos column.
void write_column_run(const std::filesystem::path& folder);

}  // namespace slope::tools::test
