#include "slope/seepage/exponential_retention.hpp"

#include <cmath>

#include "require.hpp"

namespace slope::seepage {

void ExponentialRetention::check() const {
  require_above(0.0, "alpha", alpha);
  range.check();
}

Saturation ExponentialRetention::evaluate(double suction_head) const {
  if (suction_head <= 0.0) return {range.maximum, 0.0};
  const double effective = std::exp(-alpha * suction_head);
  return range.scale(effective, -alpha * effective);
}

double ExponentialRetention::steepest() const {
  return 1.0e-6 / alpha;
}

}  // namespace slope::seepage
