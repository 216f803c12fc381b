#pragma once

#include "slope/solid/return.hpp"
#include "slope/solid/soil.hpp"
#include "slope/solid/tensor.hpp"

namespace slope::solid {

/// Coefficients of the yield function f = (sigma_1 - sigma_3) + (sigma_1 + sigma_3) sin(phi) - 2 c cos(phi) at one
/// state, sigma_1 >= sigma_2 >= sigma_3 the principal effective stresses, tension positive. The plastic potential has
/// sin(psi) for sin(phi).
struct YieldPyramid {
  double sin_friction = 0.0;    ///< (-), in [0, 1]
  double sin_dilatancy = 0.0;   ///< (-), in [0, 1); zero: no plastic volume change
  double c_cos_friction = 0.0;  ///< (Pa)

  /// f (Pa); <= 0 inside.
  [[nodiscard]] double value(const SymmetricTensor& stress) const;
  /// The largest shear stress along a plane on which soil slides that neither stretches nor shrinks along it (Pa); c +
  /// sigma tan(phi) if the flow is associated, c cos(phi) + sigma sin(phi) if it keeps the volume (Davis 1968).
  /// @param normal_stress  effective, on the plane (Pa), tension positive
  [[nodiscard]] double shear_along_slip(double normal_stress) const;
  /// The same surface, with a flow that keeps the volume.
  [[nodiscard]] YieldPyramid isochoric() const { return {sin_friction, 0.0, c_cos_friction}; }
};

/// The pyramid as a function of suction (paper, Eqs. 15, 16) and plastic strain; a suction below zero counts as zero.
class SuctionDependentPyramid {
 public:
  explicit SuctionDependentPyramid(const MohrCoulomb& strength);
  /// @param suction  s (Pa), any sign
  /// @param plastic_strain  accumulated, deviatoric (-), >= 0
  [[nodiscard]] YieldPyramid at(double suction, double plastic_strain = 0.0) const;

 private:
  MohrCoulomb strength_;
  YieldPyramid saturated_;  // at zero suction
  double cos_friction_;     // of phi'
};

/// Brings a trial stress back to the yield surface, exactly for these planes: along the flow direction onto the plane
/// of the largest and the smallest principal stress; where that would change their order, by the flow of two planes
/// onto the edge that is met first; where the edge would be overshot, onto the tip, c cot(phi) in all directions, as
/// for Drucker-Prager. The principal directions stay, sigma_zz is one of them. After Koiter (1953); in closed form,
/// because on an edge the mean stress alone tells the rest.
/// @param stress  trial effective stress in, admissible stress out (Pa)
Return return_to_yield_surface(const YieldPyramid& pyramid, const Elastic& elastic, SymmetricTensor& stress);

}  // namespace slope::solid
