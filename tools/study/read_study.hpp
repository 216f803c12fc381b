#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "slope/couple/read_case.hpp"
#include "study.hpp"

namespace slope::tools {

/// Whether a file is meant for a study rather than for a case, by its keys.
[[nodiscard]] bool is_study(const std::filesystem::path& file);

/// Reads and checks a study file, and the case that it names.
/// @throws couple::InputError naming every problem of both; couple::FileError if a file cannot be read.
[[nodiscard]] StudyInput read_study(const std::filesystem::path& file);

/// The study with every default written out; two studies with the same text have the same samples and results.
[[nodiscard]] std::string resolved_yaml(const StudyInput& input);

/// The part of such a text that a study which goes on has to keep: all but how many samples of Monte Carlo it takes at
/// most, and how narrow the interval has to be.
[[nodiscard]] std::string lasting_part(const std::string& resolved);

/// JSON Schema (draft 2020-12) of study files.
[[nodiscard]] std::string study_schema();

}  // namespace slope::tools
