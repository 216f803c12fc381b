#include "slope/seepage/van_genuchten_mualem.hpp"

#include <algorithm>
#include <cmath>

namespace slope::seepage {

double VanGenuchtenMualem::evaluate(double /*suction_head*/, double saturation) const {
  const double effective = std::clamp((saturation - range.residual) / (range.maximum - range.residual), 0.0, 1.0);
  const double m = 1.0 - 1.0 / n;
  const double pores = 1.0 - std::pow(1.0 - std::pow(effective, 1.0 / m), m);
  return std::sqrt(effective) * pores * pores;
}

}  // namespace slope::seepage
