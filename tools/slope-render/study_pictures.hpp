#pragma once

#include <filesystem>
#include <vector>

#include "losses.hpp"

namespace slope::tools {

/// Whether a folder is that of a study that has come to its end, rather than of a run.
[[nodiscard]] bool holds_study(const std::filesystem::path& folder);

/// Draws each result of a study: <name>_distribution.png, a histogram with the empirical distribution below it;
/// <name>_tornado.png, the rank correlations of the parameters, the largest above; and <name>_indices.png, Sobol's, if
/// the study has them.
/// @return what was written
/// @throws couple::FileError if the study's results cannot be read
[[nodiscard]] std::vector<std::filesystem::path> write_study_pictures(const std::filesystem::path& study,
                                                                      const std::filesystem::path& folder, int width,
                                                                      Losses& losses);

}  // namespace slope::tools
