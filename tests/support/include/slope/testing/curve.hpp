#pragma once

#include <vector>

namespace slope::testing {

/// y over x. A curve that is interpolated has its x in ascending order.
struct Curve {
  std::vector<double> x;
  std::vector<double> y;
};

/// Linear interpolation at x.
/// @throws std::out_of_range where x lies outside the curve by more than 1e-9 of its length: nothing is extrapolated.
[[nodiscard]] double interpolate(const Curve& curve, double x);

/// The largest difference over the points of `curve` from the interpolated `reference`, divided by the largest
/// absolute reference value.
/// @throws std::invalid_argument if a curve is empty or the reference is zero; std::out_of_range as interpolate().
[[nodiscard]] double max_relative_error(const Curve& curve, const Curve& reference);

/// The same difference, not divided.
[[nodiscard]] double max_error(const Curve& curve, const Curve& reference);

}  // namespace slope::testing
