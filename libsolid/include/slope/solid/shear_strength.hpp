#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "slope/solid/soil.hpp"

namespace slope::solid {

/// Standard atmosphere P_atm (Pa), the scale of suction in Eqs. 15 and 16.
inline constexpr double atmospheric_pressure = 101325.0;

/// What is left of a frictional strength, and what suction adds, in one state of the soil.
struct ShearStrength {
  double cohesion = 0.0;         ///< c (Pa)
  double friction_angle = 0.0;   ///< phi (rad)
  double dilatancy_angle = 0.0;  ///< psi (rad)
};

/// Whether the strength is below its peak.
/// @param plastic_strain  accumulated, deviatoric (-), >= 0
template <class Shape>
[[nodiscard]] bool has_softened(const FrictionalStrength<Shape>& strength, double plastic_strain) {
  return strength.softening && plastic_strain > strength.softening->range.from;
}

/// Eqs. 15 and 16 on top of c' and phi', which fall with plastic strain; a suction below zero counts as zero. All of it
/// is divided by the strength's reduction.
template <class Shape>
[[nodiscard]] ShearStrength shear_strength(const FrictionalStrength<Shape>& strength, double suction,
                                           double plastic_strain) {
  const double s = std::max(suction, 0.0) / atmospheric_pressure;
  ShearStrength now{strength.cohesion, strength.friction_angle, strength.dilatancy_angle};
  if (has_softened(strength, plastic_strain)) {
    const FrictionalSoftening& softening = *strength.softening;
    const double share = softening.range.share(plastic_strain);
    now.cohesion += share * (softening.residual_cohesion - now.cohesion);
    now.friction_angle += share * (softening.residual_friction_angle - now.friction_angle);
    now.dilatancy_angle -= share * now.dilatancy_angle;
  }
  now.cohesion -= strength.maximum_cohesion_increase * std::expm1(-strength.cohesion_suction_rate * s);
  now.friction_angle += strength.friction_angle_suction_rate * s;
  if (strength.reduction != 1.0) {
    now.cohesion /= strength.reduction;
    now.friction_angle = std::atan(std::tan(std::min(now.friction_angle, 0.5 * std::numbers::pi)) / strength.reduction);
    now.dilatancy_angle = std::min(now.dilatancy_angle, now.friction_angle);
  }
  return now;
}

}  // namespace slope::solid
