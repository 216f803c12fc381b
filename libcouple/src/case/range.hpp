#pragma once

#include <limits>
#include <string>

#include "units.hpp"

namespace slope::couple {

/// The values that a quantity may have, in SI units.
struct Range {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  bool lower_included = false;
  bool upper_included = false;

  [[nodiscard]] bool holds(double value) const;
  /// "above 0 Pa", "at least 0 m and below 90 deg", …; empty if every value is allowed.
  [[nodiscard]] std::string text(Dimension dimension) const;
};

[[nodiscard]] inline Range any_value() {
  return {};
}
[[nodiscard]] inline Range above(double lower) {
  return {.lower = lower};
}
[[nodiscard]] inline Range at_least(double lower) {
  return {.lower = lower, .lower_included = true};
}
/// Between the limits, without them.
[[nodiscard]] inline Range between(double lower, double upper) {
  return {.lower = lower, .upper = upper};
}
/// From the lower limit to the upper, both included.
[[nodiscard]] inline Range from_to(double lower, double upper) {
  return {lower, upper, true, true};
}
/// From the lower limit, included, to below the upper.
[[nodiscard]] inline Range from_to_below(double lower, double upper) {
  return {lower, upper, true, false};
}
/// Above the lower limit, up to the upper, included.
[[nodiscard]] inline Range above_to(double lower, double upper) {
  return {lower, upper, false, true};
}

}  // namespace slope::couple
