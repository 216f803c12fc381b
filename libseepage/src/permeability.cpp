#include "slope/seepage/permeability.hpp"

#include <algorithm>
#include <cmath>

namespace slope::seepage {

double HillelPower::evaluate(double /*suction_head*/, double saturation) const {
  return exponent == 2.0 ? saturation * saturation : std::pow(saturation, exponent);
}

double LiakopoulosPermeability::evaluate(double /*suction_head*/, double saturation) const {
  const double dryness = 1.0 - saturation;
  return 1.0 - coefficient * (exponent == 1.0 ? dryness : std::pow(dryness, exponent));
}

double ExponentialPermeability::evaluate(double suction_head, double /*saturation*/) const {
  return suction_head <= 0.0 ? 1.0 : std::exp(-alpha * suction_head);
}

double VanGenuchtenMualem::evaluate(double /*suction_head*/, double saturation) const {
  const double effective = std::clamp((saturation - range.residual) / (range.maximum - range.residual), 0.0, 1.0);
  const double m = 1.0 - 1.0 / n;
  const double pores = 1.0 - std::pow(1.0 - std::pow(effective, 1.0 / m), m);
  return std::sqrt(effective) * pores * pores;
}

double RelativePermeability::evaluate(double suction_head, double saturation) const {
  const double value = std::visit([&](const auto& l) { return l.evaluate(suction_head, saturation); }, law);
  return std::max(value, floor);
}

}  // namespace slope::seepage
