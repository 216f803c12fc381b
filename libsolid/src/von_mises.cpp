#include "slope/solid/von_mises.hpp"

#include <cmath>

namespace slope::solid {

double YieldCylinder::value(const SymmetricTensor& stress) const {
  return std::sqrt(second_invariant(stress)) - undrained_strength;
}

double YieldCylinder::shear_along_slip(double /*normal_stress*/) const {
  return undrained_strength;
}

YieldCylinder SofteningCylinder::at(double /*suction*/, double plastic_strain) const {
  const double peak = strength_.undrained_strength;
  if (!strength_.softening) return {peak / strength_.reduction};
  const UndrainedSoftening& softening = *strength_.softening;
  const double now = peak + softening.range.share(plastic_strain) * (softening.residual_undrained_strength - peak);
  return {now / strength_.reduction};
}

Return return_to_yield_surface(const YieldCylinder& cylinder, const Elastic& /*elastic*/, SymmetricTensor& stress) {
  const double j2 = second_invariant(stress);
  if (j2 <= cylinder.undrained_strength * cylinder.undrained_strength) return Return::elastic;
  const double scale = cylinder.undrained_strength / std::sqrt(j2);
  const double mean = trace(stress) / 3.0;
  stress = {(stress.xx - mean) * scale + mean, (stress.yy - mean) * scale + mean, (stress.zz - mean) * scale + mean,
            stress.xy * scale};
  return Return::face;
}

}  // namespace slope::solid
