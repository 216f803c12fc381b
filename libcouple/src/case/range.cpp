#include "range.hpp"

#include <fmt/format.h>

#include <cmath>

namespace slope::couple {

bool Range::holds(double value) const {
  return (lower_included ? value >= lower : value > lower) && (upper_included ? value <= upper : value < upper);
}

std::string Range::text(Dimension dimension) const {
  std::string out;
  if (std::isfinite(lower))
    out = fmt::format("{} {}", lower_included ? "at least" : "above", quantity_text(lower, dimension));
  if (std::isfinite(upper)) {
    if (!out.empty()) out += " and ";
    out += fmt::format("{} {}", upper_included ? "at most" : "below", quantity_text(upper, dimension));
  }
  return out;
}

}  // namespace slope::couple
