#include "slope/testing/curve.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <string>

namespace slope::testing {

double interpolate(const Curve& curve, double x) {
  if (curve.x.empty() || curve.x.size() != curve.y.size()) throw std::invalid_argument("a curve without points");
  const double slack = 1.0e-9 * (curve.x.back() - curve.x.front());
  // Written so that a NaN is outside, too.
  if (!(x >= curve.x.front() - slack && x <= curve.x.back() + slack)) {
    throw std::out_of_range("x = " + std::to_string(x) + " lies outside the curve, " + std::to_string(curve.x.front()) +
                            " to " + std::to_string(curve.x.back()));
  }
  if (x <= curve.x.front()) return curve.y.front();
  if (x >= curve.x.back()) return curve.y.back();
  const auto above = std::upper_bound(curve.x.begin(), curve.x.end(), x);
  const auto i = static_cast<std::size_t>(std::distance(curve.x.begin(), above)) - 1;
  const double share = (x - curve.x[i]) / (curve.x[i + 1] - curve.x[i]);
  return curve.y[i] + share * (curve.y[i + 1] - curve.y[i]);
}

double max_error(const Curve& curve, const Curve& reference) {
  if (curve.x.empty() || curve.x.size() != curve.y.size()) throw std::invalid_argument("a curve without points");
  double largest = 0.0;
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    const double error = std::abs(curve.y[i] - interpolate(reference, curve.x[i]));
    if (std::isnan(error)) return error;
    largest = std::max(largest, error);
  }
  return largest;
}

double max_relative_error(const Curve& curve, const Curve& reference) {
  double scale = 0.0;
  for (const double y : reference.y) scale = std::max(scale, std::abs(y));
  if (scale == 0.0) throw std::invalid_argument("the reference is zero: no relative error");
  return max_error(curve, reference) / scale;
}

}  // namespace slope::testing
