#include "slope/seepage/van_genuchten_mualem.hpp"

#include <algorithm>
#include <cmath>

#include "require.hpp"

namespace slope::seepage {

namespace {

// F = 1 - (1 - S^(1/m))^m
double pores(double saturation, double m) {
  return 1.0 - std::pow(1.0 - std::pow(saturation, 1.0 / m), m);
}

}  // namespace

void VanGenuchtenMualem::check() const {
  require_above(1.0, "n", n);
  range.check();
  require(entry_saturation > 0.0 && entry_saturation <= 1.0, "entry_saturation", "above 0 and at most 1",
          entry_saturation);
}

double VanGenuchtenMualem::evaluate(double /*suction_head*/, double saturation) const {
  const double effective = std::clamp((saturation - range.residual) / (range.maximum - range.residual), 0.0, 1.0);
  const double m = 1.0 - 1.0 / n;
  double filled = pores(effective * entry_saturation, m);
  if (entry_saturation < 1.0) filled /= pores(entry_saturation, m);
  return std::sqrt(effective) * filled * filled;
}

// dk/dS_e = (F^2 / (2 sqrt(S_e)) + 2 sqrt(S_e) F dF/dS_e) / F(1)^2
double VanGenuchtenMualem::slope(double /*suction_head*/, const Saturation& saturation) const {
  const double span = range.maximum - range.residual;
  const double effective = (saturation.saturation - range.residual) / span;
  if (effective <= 0.0 || effective >= 1.0) return 0.0;
  const double m = 1.0 - 1.0 / n;
  const double power = std::pow(effective * entry_saturation, 1.0 / m);
  if (power >= 1.0) return 0.0;
  const double filled = 1.0 - std::pow(1.0 - power, m);
  const double filled_slope = std::pow(1.0 - power, m - 1.0) * power / effective;
  const double root = std::sqrt(effective);
  const double scale = entry_saturation < 1.0 ? 1.0 / std::pow(pores(entry_saturation, m), 2) : 1.0;
  return scale * (0.5 * filled * filled / root + 2.0 * root * filled * filled_slope) * saturation.slope / span;
}

}  // namespace slope::seepage
