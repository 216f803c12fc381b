#include "slope/seepage/van_genuchten_retention.hpp"

#include <algorithm>
#include <cmath>

#include "require.hpp"

namespace slope::seepage {

void VanGenuchten::check() const {
  require_above(0.0, "alpha", alpha);
  require_above(1.0, "n", n);
  require_at_least(0.0, "air_entry", air_entry);
  range.check();
}

double VanGenuchten::entry_saturation() const {
  return air_entry > 0.0 ? std::pow(1.0 + std::pow(alpha * air_entry, n), 1.0 / n - 1.0) : 1.0;
}

Saturation VanGenuchten::evaluate(double suction_head) const {
  if (suction_head <= air_entry) return {range.maximum, 0.0};
  const double m = 1.0 - 1.0 / n;
  const double x = std::exp(n * std::log(alpha * suction_head));
  const double effective = std::exp(-m * std::log1p(x)) / entry_saturation();
  return range.scale(effective, -m * n * effective / ((1.0 + 1.0 / x) * suction_head));
}

double VanGenuchten::steepest() const {
  const double inflection = std::pow(1.0 - 1.0 / n, 1.0 / n) / alpha;
  return std::max(inflection, air_entry * (1.0 + 1.0e-6));
}

}  // namespace slope::seepage
