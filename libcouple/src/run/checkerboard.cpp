#include "checkerboard.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace slope::couple {

double pressure_checkerboard(const seepage::HeadOperator& head_operator, const seepage::Skeleton& skeleton,
                             std::span<const double> pressure) {
  const std::size_t n = pressure.size();
  std::vector<double> gx(n), gy(n);
  head_operator.gradient(pressure, skeleton, gx, gy);
  const seepage::Neighbours& neighbours = head_operator.neighbours();
  const std::span<const double> conductance = head_operator.conductance();
  double squares = 0.0;
  for (std::size_t p = 0; p < n; ++p) {
    double sum = 0.0, weights = 0.0;
    for (std::size_t s = neighbours.start[p]; s < neighbours.start[p + 1]; ++s) {
      const std::size_t q = neighbours.index[s];
      const double expected =
          0.5 * ((gx[p] + gx[q]) * (skeleton.x[p] - skeleton.x[q]) + (gy[p] + gy[q]) * (skeleton.y[p] - skeleton.y[q]));
      sum += conductance[s] * (pressure[p] - pressure[q] - expected);
      weights += conductance[s];
    }
    if (weights > 0.0) squares += (sum / weights) * (sum / weights);
  }
  const auto [low, high] = std::ranges::minmax(pressure);
  return high > low ? std::sqrt(squares / static_cast<double>(n)) / (high - low) : 0.0;
}

}  // namespace slope::couple
