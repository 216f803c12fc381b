#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "run_folder.hpp"

namespace slope::tools {

/// The cases of the paper, by the stems of their case files.
inline constexpr std::array<std::string_view, 7> paper_cases{"liakopoulos", "slope-w1", "slope-w2", "slope-w3",
                                                             "slope-h1",    "slope-h2", "slope-h3"};

/// The runs of the paper's cases that are there.
struct PaperRuns {
  std::map<std::string, RunFolder, std::less<>> runs;        ///< by the case's name; each came to its end
  std::map<std::string, std::string, std::less<>> unusable;  ///< why a case's run is not among them
};

/// Which of the paper's cases a run is of: the one whose name its folder has, or else the stem of the case file that
/// its summary names; empty if it is none of them.
[[nodiscard]] std::string paper_case_of(const RunFolder& run);

/// Reads run folders.
/// @throws std::invalid_argument if one is of none of the paper's cases or two are of the same; what read_run_folder()
///   throws.
[[nodiscard]] PaperRuns read_paper_runs(const std::vector<std::filesystem::path>& folders);

}  // namespace slope::tools
