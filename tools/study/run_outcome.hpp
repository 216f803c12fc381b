#pragma once

#include <filesystem>

#include "slope/couple/document.hpp"
#include "slope/couple/summary.hpp"

namespace slope::tools {

/// What has become of a run of a study.
enum class RunState {
  unfinished,  ///< not begun, at work, interrupted or killed
  broke_off,   ///< the physics broke, or a file could not be written
  finished,
};

struct RunOutcome {
  RunState state = RunState::unfinished;
  couple::Verdict verdict = couple::Verdict::undecided;
  couple::Document summary;
};

/// Of the run in a folder, by its summary.
[[nodiscard]] RunOutcome outcome_of(const std::filesystem::path& folder);

}  // namespace slope::tools
