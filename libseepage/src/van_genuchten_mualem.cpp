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

// dk/dS_e = F^2 / (2 sqrt(S_e)) + 2 sqrt(S_e) F dF/dS_e,  F = 1 - (1 - S_e^(1/m))^m
double VanGenuchtenMualem::slope(double /*suction_head*/, const Saturation& saturation) const {
  const double span = range.maximum - range.residual;
  const double effective = (saturation.saturation - range.residual) / span;
  if (effective <= 0.0 || effective >= 1.0) return 0.0;
  const double m = 1.0 - 1.0 / n;
  const double filled = std::pow(effective, 1.0 / m);
  if (filled >= 1.0) return 0.0;
  const double pores = 1.0 - std::pow(1.0 - filled, m);
  const double pores_slope = std::pow(1.0 - filled, m - 1.0) * filled / effective;
  const double root = std::sqrt(effective);
  return (0.5 * pores * pores / root + 2.0 * root * pores * pores_slope) * saturation.slope / span;
}

}  // namespace slope::seepage
