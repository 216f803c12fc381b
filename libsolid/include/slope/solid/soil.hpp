#pragma once

#include <algorithm>
#include <optional>
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

/// Over which plastic strain a strength falls, linearly, from its peak to its residual value.
struct SofteningRange {
  double from = 0.0;  ///< accumulated deviatoric plastic strain (-) up to which the peak holds, >= 0
  double to = 0.0;    ///< and from which on the residual value holds, > from
  /// Cell size (m) for which `to - from` was found; with cells of another size h the soil softens over
  /// (to - from) characteristic_length / h. Zero: the same strain whatever the cell size.
  double characteristic_length = 0.0;

  /// Share of the fall that is over (-), in [0, 1].
  [[nodiscard]] double share(double plastic_strain) const {
    return std::clamp((plastic_strain - from) / (to - from), 0.0, 1.0);
  }
  /// The range for cells of that size (m).
  [[nodiscard]] SofteningRange in_cells_of(double cell_size) const {
    if (characteristic_length == 0.0) return *this;
    return {from, from + (to - from) * characteristic_length / cell_size, 0.0};
  }
};

/// Softening of cohesion and friction angle. The dilatancy angle falls to zero with them: at its residual strength the
/// soil keeps its volume. What suction adds does not soften.
struct FrictionalSoftening {
  double residual_cohesion = 0.0;        ///< (Pa), in [0, c']
  double residual_friction_angle = 0.0;  ///< (rad), in [0, phi']
  SofteningRange range;
};

/// Strength by cohesion and friction angle, both stronger with suction (paper, Eqs. 15, 16). Suction below zero counts
/// as zero. `Shape` only tells the laws apart.
template <class Shape>
struct FrictionalStrength {
  double cohesion = 0.0;                     ///< c' (Pa), >= 0: cohesion at zero suction
  double friction_angle = 0.0;               ///< phi' (rad), in [0, pi/2): friction angle at zero suction
  double dilatancy_angle = 0.0;              ///< psi (rad), in [0, phi']
  double maximum_cohesion_increase = 0.0;    ///< Delta c_max (Pa), >= 0
  double cohesion_suction_rate = 0.0;        ///< B (-), >= 0
  double friction_angle_suction_rate = 0.0;  ///< A (rad): increase of phi per atmosphere of suction
  std::optional<FrictionalSoftening> softening = std::nullopt;  ///< none: the strength is that of the peak for ever
  /// F (-), > 0, for strength reduction: whatever c and phi are by suction and plastic strain, the soil has c / F and
  /// atan(tan(phi) / F); psi is no more than that.
  double reduction = 1.0;
};

/// Drucker-Prager strength matched to Mohr-Coulomb in plane strain (paper, Eqs. 11-14).
using DruckerPrager = FrictionalStrength<struct DruckerPragerCone>;

/// Mohr-Coulomb strength: the largest ratio of shear to normal stress decides, whatever the intermediate stress.
using MohrCoulomb = FrictionalStrength<struct MohrCoulombPyramid>;

/// Softening of the undrained shear strength.
struct UndrainedSoftening {
  double residual_undrained_strength = 0.0;  ///< (Pa), in [0, s_u]
  SofteningRange range;
};

/// Von Mises strength, for clay that is too fast loaded to drain: it depends neither on the mean stress nor on suction,
/// and plastic strain keeps the volume.
struct VonMises {
  double undrained_strength = 0.0;  ///< s_u (Pa), > 0: the largest shear stress in plane strain
  std::optional<UndrainedSoftening> softening = std::nullopt;
  double reduction = 1.0;  ///< F (-), > 0: the soil has s_u / F
};

/// Modified Cam-clay (Roscoe and Burland 1968), for clay whose stiffness and strength come from the stress that it has
/// borne. What the soil is like before the start is said by one of the last three.
struct ModifiedCamClay {
  double critical_state_ratio = 0.0;  ///< M (-), > 0: q / p' at the critical state
  double lambda = 0.0;                ///< slope of the normal compression line in v over ln p' (-), > kappa
  double kappa = 0.0;                 ///< slope of the swelling lines (-), > 0
  double minimum_mean_stress = 0.0;   ///< (Pa), > 0: stiffness and p_c are never smaller than at this p'
  std::optional<double> overconsolidation_ratio = std::nullopt;    ///< p_c over that of the present stress (-), >= 1
  std::optional<double> pre_overburden_pressure = std::nullopt;    ///< p_c less that of the present stress (Pa), >= 0
  std::optional<double> preconsolidation_pressure = std::nullopt;  ///< p_c (Pa), > 0; that of the stress if larger
};

using Strength = std::variant<NoYield, DruckerPrager, MohrCoulomb, VonMises, ModifiedCamClay>;

/// What the soil skeleton of one material is made of.
struct Soil {
  Elastic elastic;  ///< of a law with a stiffness of its own only Poisson's ratio counts
  Strength strength;
  double grain_density = 0.0;  ///< rho_s (kg/m3), > 0
};

}  // namespace slope::solid
