#pragma once

#include <string>

#include "case/format.hpp"
#include "dotted_keys.hpp"
#include "study.hpp"

/// The study format: every key with its meaning, its unit, its range, and whether it is required.
namespace slope::tools {

/// @param numbers  of the case that the study is of; null: any key, and values of any unit
[[nodiscard]] couple::Format<Study> study_format(const CaseNumbers* numbers);

/// The path of the case, which has to be known before the rest can be read.
inline constexpr const char* case_key = "case";

}  // namespace slope::tools
