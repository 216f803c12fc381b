#include "run_outcome.hpp"

#include "slope/couple/results.hpp"

namespace slope::tools {

RunOutcome outcome_of(const std::filesystem::path& folder) {
  RunOutcome outcome;
  const std::filesystem::path file = folder / "summary.json";
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return outcome;
  try {
    const couple::RunSummary summary = couple::read_summary(file);
    if (couple::is_complete(summary.found.end_reason)) outcome.state = RunState::finished;
    if (summary.found.end_reason == couple::EndReason::error) outcome.state = RunState::broke_off;
    outcome.verdict = summary.found.verdict;
    outcome.summary = couple::summary_document(summary);
  } catch (const couple::FileError&) {
    return {};  // damaged: the run is done again
  }
  return outcome;
}

}  // namespace slope::tools
