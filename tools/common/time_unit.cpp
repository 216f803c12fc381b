#include "time_unit.hpp"

#include <fmt/format.h>

#include <cmath>

namespace slope::tools {

namespace {

constexpr double hour = 3600.0, day = 24.0 * hour;

}  // namespace

TimeUnit time_unit(double longest) {
  if (longest < 3.0 * hour) return {};
  return longest < 5.0 * day ? TimeUnit{hour, "h"} : TimeUnit{day, "d"};
}

std::string time_text(double seconds, const TimeUnit& unit) {
  const double digits = unit.seconds < hour ? 10.0 : unit.seconds < day ? 1.0e3 : 1.0e4;
  return fmt::format("{} {}", std::round(digits * seconds / unit.seconds) / digits, unit.name);
}

std::string time_text(double seconds) {
  return time_text(seconds, time_unit(seconds));
}

}  // namespace slope::tools
