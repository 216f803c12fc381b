#pragma once

#include <filesystem>

#include "paper_runs.hpp"

namespace slope::tools {

/// Writes what the runs of the paper's slopes say of the paper's claims (its sections 4.2 to 4.4) as a page of
/// Markdown: a table of the runs, then a row for each claim with the measured figures and whether they bear it out. A
/// claim for which a run is missing is named as not judged. Times, sizes and suctions are those of the runs' summaries
/// and histories; nothing in the page depends on when or where it was written.
/// @throws couple::FileError if a file cannot be read or written.
void write_paper_report(const PaperRuns& runs, const std::filesystem::path& file);

}  // namespace slope::tools
