#pragma once

#include "slope/solid/return.hpp"
#include "slope/solid/soil.hpp"
#include "slope/solid/tensor.hpp"

namespace slope::solid {

/// Coefficients of the yield function f = sqrt(J_2) + eta I_1 - xi c (paper, Eq. 11) at one suction.
struct YieldCone {
  double eta = 0.0;            ///< (-), Eq. 13 at phi
  double eta_potential = 0.0;  ///< (-), Eq. 13 at the dilatancy angle psi; zero: no plastic volume change
  double xi_c = 0.0;           ///< xi c (Pa), Eqs. 14 and 15

  /// f (Pa); <= 0 inside. I_1 is the trace of the effective stress, tension positive.
  [[nodiscard]] double value(const SymmetricTensor& stress) const;
  /// The largest shear stress along a plane on which soil slides that neither stretches nor shrinks along it (Pa); c +
  /// sigma tan(phi) if the flow is associated, c cos(phi) + sigma sin(phi) if it keeps the volume (Davis 1968).
  /// @param normal_stress  effective, on the plane (Pa), tension positive
  [[nodiscard]] double shear_along_slip(double normal_stress) const;
  /// The same surface, with a flow that keeps the volume.
  [[nodiscard]] YieldCone isochoric() const { return {eta, 0.0, xi_c}; }
};

/// The cone as a function of suction (paper, Eqs. 13-16) and plastic strain; a suction below zero counts as zero.
/// The plastic potential is g = sqrt(J_2) + eta(psi) I_1, so that psi = phi is associated; Eq. 12 as printed is not.
class SuctionDependentCone {
 public:
  explicit SuctionDependentCone(const DruckerPrager& strength);
  /// @param suction  s (Pa), any sign
  /// @param plastic_strain  accumulated, deviatoric (-), >= 0
  [[nodiscard]] YieldCone at(double suction, double plastic_strain = 0.0) const;

 private:
  DruckerPrager strength_;
  YieldCone saturated_;  // at zero suction
  double xi_;            // Eq. 14 at phi'
};

/// Brings a trial stress back to the yield surface, exactly for this linear cone: along the flow direction onto its
/// flank, or onto its tip where the flank would be overshot. On return, cone.value(stress) is zero to rounding if the
/// trial stress was outside.
/// @param stress  trial effective stress in, admissible stress out (Pa)
Return return_to_yield_surface(const YieldCone& cone, const Elastic& elastic, SymmetricTensor& stress);

}  // namespace slope::solid
