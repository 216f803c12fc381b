#include "slope/seepage/liakopoulos_retention.hpp"

#include <cmath>

#include "require.hpp"

namespace slope::seepage {

void LiakopoulosRetention::check() const {
  require_above(0.0, "coefficient", coefficient);
  require_above(1.0, "exponent", exponent);
  require(floor >= 0.0 && floor < 1.0, "floor", "at least 0 and below 1", floor);
}

Saturation LiakopoulosRetention::evaluate(double suction_head) const {
  if (suction_head <= 0.0) return {1.0, 0.0};
  const double drop = coefficient * std::pow(suction_head, exponent);
  if (1.0 - drop <= floor) return {floor, 0.0};
  return {1.0 - drop, -exponent * drop / suction_head};
}

double LiakopoulosRetention::steepest() const {
  return kink() * (1.0 - 1.0e-6);
}

double LiakopoulosRetention::kink() const {
  return std::pow((1.0 - floor) / coefficient, 1.0 / exponent);
}

}  // namespace slope::seepage
