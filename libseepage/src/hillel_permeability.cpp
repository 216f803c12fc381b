#include "slope/seepage/hillel_permeability.hpp"

#include <cmath>

namespace slope::seepage {

double HillelPower::evaluate(double /*suction_head*/, double saturation) const {
  return exponent == 2.0 ? saturation * saturation : std::pow(saturation, exponent);
}

}  // namespace slope::seepage
