#include "slope/seepage/exponential_permeability.hpp"

#include <cmath>

#include "require.hpp"

namespace slope::seepage {

void ExponentialPermeability::check() const {
  require_above(0.0, "alpha", alpha);
}

double ExponentialPermeability::evaluate(double suction_head, double /*saturation*/) const {
  return suction_head <= 0.0 ? 1.0 : std::exp(-alpha * suction_head);
}

double ExponentialPermeability::slope(double suction_head, const Saturation& /*saturation*/) const {
  return suction_head <= 0.0 ? 0.0 : -alpha * std::exp(-alpha * suction_head);
}

}  // namespace slope::seepage
