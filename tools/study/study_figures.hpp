#pragma once

#include <optional>
#include <string>
#include <vector>

#include "design.hpp"
#include "run_outcome.hpp"
#include "study.hpp"
#include "study_results.hpp"

/// From what the runs have found to what the study has.
namespace slope::tools {

/// One run; its folder is the caller's.
[[nodiscard]] StudyRow study_row(const Study& study, const std::vector<double>& sample, const RunOutcome& outcome);

/// Of the runs so far; none if the study does not say what failure is.
[[nodiscard]] std::optional<FoundFailure> found_failure(const Study& study, const std::vector<RunOutcome>& outcomes);

/// All figures of study.json.
[[nodiscard]] StudyResults study_results(const Study& study, const Samples& samples,
                                         const std::vector<RunOutcome>& outcomes);

/// What a reader wants to know, in a few lines.
[[nodiscard]] std::string study_report(const StudyResults& results);

}  // namespace slope::tools
