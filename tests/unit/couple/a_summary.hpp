#pragma once

#include "slope/couple/results.hpp"

namespace slope::couple::test {

/// Of a slope that failed and slid to the left, with a title of odd letters.
[[nodiscard]] RunSummary a_summary();

}  // namespace slope::couple::test
