#include "slope/solid/drucker_prager.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "slope/solid/shear_strength.hpp"

namespace slope::solid {

namespace {

struct Match {
  double eta;
  double xi;
};

// Eqs. 13 and 14: the cone that meets Mohr-Coulomb in associated plane strain.
// No friction angle exceeds a right one.
Match plane_strain_match(double angle) {
  const double friction = std::sin(std::min(angle, 0.5 * std::numbers::pi));
  const double s2 = friction * friction;
  const double root = std::sqrt(9.0 + 3.0 * s2);
  return {friction / root, 3.0 * std::sqrt(1.0 - s2) / root};
}

}  // namespace

double YieldCone::value(const SymmetricTensor& stress) const {
  return std::sqrt(second_invariant(stress)) + eta * trace(stress) - xi_c;
}

// Where it flows in plane strain, sigma_zz follows from no flow along z, and the cone is a pyramid with these angles.
double YieldCone::shear_along_slip(double normal_stress) const {
  const double root = std::sqrt(1.0 - 3.0 * eta_potential * eta_potential);
  const double share = root / (1.0 - 3.0 * eta * eta_potential);
  const double sin_friction = 3.0 * eta * share, sin_dilatancy = 3.0 * eta_potential / root;
  const double cos_dilatancy = std::sqrt(1.0 - sin_dilatancy * sin_dilatancy);
  return cos_dilatancy * (xi_c * share - normal_stress * sin_friction) / (1.0 - sin_friction * sin_dilatancy);
}

SuctionDependentCone::SuctionDependentCone(const DruckerPrager& strength) : strength_(strength) {
  const ShearStrength now = shear_strength(strength, 0.0, 0.0);
  const Match friction = plane_strain_match(now.friction_angle);
  xi_ = friction.xi;
  saturated_ = {friction.eta, plane_strain_match(now.dilatancy_angle).eta, friction.xi * now.cohesion};
}

YieldCone SuctionDependentCone::at(double suction, double plastic_strain) const {
  const bool softened = has_softened(strength_, plastic_strain);
  if (suction <= 0.0 && !softened) return saturated_;
  const ShearStrength now = shear_strength(strength_, suction, plastic_strain);
  if (strength_.friction_angle_suction_rate == 0.0 && !softened) {
    return {saturated_.eta, saturated_.eta_potential, xi_ * now.cohesion};
  }
  const Match friction = plane_strain_match(now.friction_angle);
  return {friction.eta, plane_strain_match(now.dilatancy_angle).eta, friction.xi * now.cohesion};
}

Return return_to_yield_surface(const YieldCone& cone, const Elastic& elastic, SymmetricTensor& stress) {
  const double mean = trace(stress) / 3.0;
  const double j2 = second_invariant(stress);
  const double strength = cone.xi_c - 3.0 * cone.eta * mean;
  if (strength >= 0.0 && j2 <= strength * strength) return Return::elastic;

  const double root_j2 = std::sqrt(j2);
  const double f = root_j2 - strength;
  const double shear = elastic.shear_modulus();
  const double bulk = elastic.bulk_modulus();
  const double multiplier = f / (shear + 9.0 * bulk * cone.eta * cone.eta_potential);
  const double new_mean = mean - 3.0 * bulk * cone.eta_potential * multiplier;
  // what the yield function leaves to sqrt(J_2) at the new mean stress; negative beyond the tip
  const double new_root_j2 = cone.xi_c - 3.0 * cone.eta * new_mean;
  if (new_root_j2 >= 0.0) {
    const double scale = root_j2 > 0.0 ? new_root_j2 / root_j2 : 0.0;
    stress = {(stress.xx - mean) * scale + new_mean, (stress.yy - mean) * scale + new_mean,
              (stress.zz - mean) * scale + new_mean, stress.xy * scale};
    return Return::face;
  }
  const double tip = cone.xi_c / (3.0 * cone.eta);
  stress = {tip, tip, tip, 0.0};
  return Return::apex;
}

}  // namespace slope::solid
