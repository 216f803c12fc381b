#pragma once

#include <filesystem>
#include <string>

#include "slope/couple/case.hpp"
#include "slope/couple/simulation.hpp"

namespace slope::tools {

/// What the program knows of a run beside what the simulation does.
struct RunRecord {
  std::string version;
  std::string end_reason;  ///< that of the simulation's summary, or "interrupted" or "error"
  std::string message;     ///< of the error; empty if there was none
  double wall_time = 0.0;  ///< (s)
  int threads = 1;
};

/// The content of summary.json. Names carry their unit; what did not happen is null.
[[nodiscard]] std::string summary_json(const couple::Case& input, const couple::Summary& summary,
                                       const RunRecord& record);

}  // namespace slope::tools
