#include "slope/seepage/hillel_permeability.hpp"

#include <cmath>

#include "require.hpp"

namespace slope::seepage {

void HillelPower::check() const {
  require_above(0.0, "exponent", exponent);
}

double HillelPower::evaluate(double /*suction_head*/, double saturation) const {
  return exponent == 2.0 ? saturation * saturation : std::pow(saturation, exponent);
}

double HillelPower::slope(double /*suction_head*/, const Saturation& saturation) const {
  return exponent * std::pow(saturation.saturation, exponent - 1.0) * saturation.slope;
}

}  // namespace slope::seepage
