#pragma once

#include <variant>

namespace slope::solid {

/// Isotropic linear elasticity of the soil skeleton.
struct Elastic {
  double youngs_modulus = 0.0;  ///< E (Pa), > 0
  double poissons_ratio = 0.0;  ///< nu (-), in (-1, 0.5)

  [[nodiscard]] double shear_modulus() const { return youngs_modulus / (2.0 * (1.0 + poissons_ratio)); }
  [[nodiscard]] double bulk_modulus() const { return youngs_modulus / (3.0 * (1.0 - 2.0 * poissons_ratio)); }
  /// Constrained (oedometric) modulus M = K + 4G/3 (Pa).
  [[nodiscard]] double constrained_modulus() const { return bulk_modulus() + 4.0 / 3.0 * shear_modulus(); }
};

/// The soil never yields.
struct NoYield {};

/// Drucker-Prager strength matched to Mohr-Coulomb in plane strain, with suction-dependent cohesion
/// and friction angle (paper, Eqs. 11-16). Suction below zero counts as zero.
struct DruckerPrager {
  double cohesion = 0.0;                     ///< c' (Pa), >= 0: cohesion at zero suction
  double friction_angle = 0.0;               ///< phi' (rad), in [0, pi/2): friction angle at zero suction
  double dilatancy_angle = 0.0;              ///< psi (rad), in [0, phi']
  double maximum_cohesion_increase = 0.0;    ///< Delta c_max (Pa), >= 0
  double cohesion_suction_rate = 0.0;        ///< B (-), >= 0
  double friction_angle_suction_rate = 0.0;  ///< A (rad): increase of phi per atmosphere of suction
};

/// What the soil skeleton of one material is made of.
struct Soil {
  Elastic elastic;
  std::variant<NoYield, DruckerPrager> strength;
  double grain_density = 0.0;  ///< rho_s (kg/m3), > 0
};

}  // namespace slope::solid
