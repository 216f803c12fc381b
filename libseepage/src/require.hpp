#pragma once

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace slope::seepage {

/// @throws std::invalid_argument that names the field, its range and the value
inline void require(bool holds, const std::string& field, const std::string& range, double value) {
  if (holds) return;
  std::ostringstream text;
  text << field << " must be " << range << ", got " << value;
  throw std::invalid_argument(text.str());
}

inline void require_above(double limit, const std::string& field, double value) {
  std::ostringstream range;
  range << "above " << limit;
  require(value > limit && std::isfinite(value), field, range.str(), value);
}

inline void require_at_least(double limit, const std::string& field, double value) {
  std::ostringstream range;
  range << "at least " << limit;
  require(value >= limit && std::isfinite(value), field, range.str(), value);
}

}  // namespace slope::seepage
