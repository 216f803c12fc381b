#pragma once

#include <array>
#include <span>

#include "slope/solid/law_with_state.hpp"
#include "slope/solid/soil.hpp"
#include "slope/solid/tensor.hpp"

namespace slope::solid {

/// Modified Cam-clay (Roscoe and Burland 1968; Wood 1990, chapter 5) for any strain increment in plane strain. With the
/// mean effective stress p = -tr(sigma') / 3, positive in compression, and q = sqrt(3 J_2) (Pa):
///
///     yield and flow   f = q^2 / M^2 + p (p - p_c) <= 0, associated
///     swelling         dv = -kappa dp / p, v = 1 / (1 - n): the bulk modulus is K = v p / kappa
///     shear            G = 3 K (1 - 2 nu) / (2 (1 + nu)), Poisson's ratio constant
///     hardening        dv^p = -(lambda - kappa) dp_c / p_c
///
/// Where p is below a minimum mean stress p_min, K stays v p_min / kappa, and p_c never falls below p_min; so soil at a
/// free surface keeps a stiffness and a strength, and p may reach zero. The ellipse ends there: no tension is borne.
/// Suction acts through the effective stress alone, which holds the share S_r of it (Bishop); there is no cohesion.
///
/// Integrated by backward Euler (Borja and Lee 1990), with the secant of K over the step. What the specific volume
/// loses for good is the only unknown left; its equation changes sign once between bounds that are known, so that it is
/// always found. On isotropic paths the result is exact. Increments are taken in parts of a strain of 1e-3 at most.
///
/// The circular section gives soil in plane strain another friction angle than in triaxial compression.
class HardeningEllipse {
 public:
  static constexpr std::array<InternalVariable, 1> internal_variables{{{"preconsolidation_pressure", "Pa"}}};

  /// @param poissons_ratio  nu (-), in (-1, 0.5)
  HardeningEllipse(const ModifiedCamClay& strength, double poissons_ratio);

  /// f over p_c^2 (-): <= 0 inside, zero on the surface.
  [[nodiscard]] double value(const SymmetricTensor& stress, std::span<const double> internal) const;

  /// p_c = max(R p_e + d, p_0): with the overconsolidation ratio R, the pre-overburden pressure d, the preconsolidation
  /// pressure p_0 (1, 0 and 0 unless given), and p_e = p + q^2 / (M^2 p) of the ellipse through the stress. In p_e, p
  /// is p_min at least and q is M p at most: elastic stress beyond the critical state is no memory of the soil.
  void initial(const SymmetricTensor& stress, std::span<double> internal) const;

  /// E and nu of small strains (Pa, -).
  /// @param specific_volume  v (-), >= 1
  [[nodiscard]] Elastic stiffness(const SymmetricTensor& stress, double specific_volume) const;

  /// @param internal  p_c (Pa)
  /// @param stress  effective stress, in and out (Pa); not a number if the increment is larger than 1
  /// @return deviatoric plastic strain of the step (-), >= 0
  double update(const StrainStep& step, std::span<double> internal, SymmetricTensor& stress) const;

 private:
  struct Part;
  [[nodiscard]] double scaled(double mean_stress) const;
  [[nodiscard]] double unscaled(double scaled) const;
  [[nodiscard]] double after(double mean_stress, double swelling) const;
  [[nodiscard]] double secant(double mean_stress, double swelling) const;

  ModifiedCamClay strength_;
  double poissons_ratio_;
  double shear_over_bulk_;  // G / K
};

}  // namespace slope::solid
