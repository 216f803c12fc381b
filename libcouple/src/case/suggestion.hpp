#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace slope::couple {

/// The candidate that the word is probably a misspelling of; none if no candidate is close.
[[nodiscard]] std::optional<std::string> closest_word(std::string_view word,
                                                      const std::vector<std::string>& candidates);

/// ', did you mean "…"?' or else '; choose one of: …'.
[[nodiscard]] std::string suggestion(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace slope::couple
