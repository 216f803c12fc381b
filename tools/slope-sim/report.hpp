#pragma once

#include <string>

#include "slope/couple/case.hpp"
#include "slope/couple/results.hpp"

namespace slope::tools {

/// What a reader wants to know at the end of a run, in a few lines.
[[nodiscard]] std::string report_text(const couple::Case& input, const couple::RunSummary& run);

/// "stands until the end, 40 min", "fails in the rain": what a run says of the slope, in the first line of its report.
[[nodiscard]] std::string verdict_text(const couple::Case& input, const couple::Summary& summary);

/// "1.231 at 18 h (1.228 to 1.234, 6 trials); what flows is 6.1 m2, 1.3 m deep"
[[nodiscard]] std::string safety_text(const couple::FactorOfSafety& safety);
/// A line for each time, and the least.
[[nodiscard]] std::string safety_report_text(const couple::Case& input, const couple::RunSummary& run);

/// "693 s (largest displacement above 2 cm) at x = 10.3 m, y = 5.2 m"
[[nodiscard]] std::string onset_text(const couple::Case& input, const couple::Summary& summary);

}  // namespace slope::tools
