#pragma once

#include "results/result_format.hpp"

namespace slope::couple {

/// The whole of summary.json.
[[nodiscard]] ResultFormat<RunSummary> summary_format();

inline constexpr const char* summary_program = "slope-sim";  ///< under the key "program", by which a summary is known

}  // namespace slope::couple
