#include "slope/seepage/liakopoulos_permeability.hpp"

#include <cmath>

#include "require.hpp"

namespace slope::seepage {

void LiakopoulosPermeability::check() const {
  require_above(0.0, "coefficient", coefficient);
  require_above(0.0, "exponent", exponent);
}

double LiakopoulosPermeability::evaluate(double /*suction_head*/, double saturation) const {
  const double dryness = 1.0 - saturation;
  return 1.0 - coefficient * (exponent == 1.0 ? dryness : std::pow(dryness, exponent));
}

double LiakopoulosPermeability::slope(double /*suction_head*/, const Saturation& saturation) const {
  const double dryness = 1.0 - saturation.saturation;
  if (dryness <= 0.0) return 0.0;
  return coefficient * exponent * std::pow(dryness, exponent - 1.0) * saturation.slope;
}

}  // namespace slope::seepage
