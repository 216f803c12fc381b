#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "paper_runs.hpp"

namespace slope::tools {

/// What became of the paper's figures.
struct PaperFigures {
  std::vector<std::filesystem::path> written;
  std::vector<std::string> left_out;  ///< "fig10: no run of slope-w1", one for each figure that was not drawn
};

/// Draws the content of the paper's Figs. 4 and 6 to 18 as fig04.png, fig06.png, ... A figure for which a run is
/// missing or lacks what it shows is left out.
/// @param folder  for the pictures; created if need be.
/// @throws couple::FileError if a file cannot be read or written.
[[nodiscard]] PaperFigures write_paper_figures(const PaperRuns& runs, const std::filesystem::path& folder, int width);

}  // namespace slope::tools
