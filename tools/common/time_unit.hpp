#pragma once

#include <string>

namespace slope::tools {

/// What times are told in.
struct TimeUnit {
  double seconds = 1.0;
  std::string name = "s";
};

/// The unit in which times up to the longest (s) read well: s below three hours, h below five days, d beyond.
[[nodiscard]] TimeUnit time_unit(double longest);

/// A time (s) in a unit, to a tenth of a second, a thousandth of an hour or a ten-thousandth of a day.
[[nodiscard]] std::string time_text(double seconds, const TimeUnit& unit);
/// In its own unit: "459.1 s", "22.808 h", "5.25 d".
[[nodiscard]] std::string time_text(double seconds);

}  // namespace slope::tools
