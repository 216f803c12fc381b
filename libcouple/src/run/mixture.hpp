#pragma once

#include <span>
#include <utility>
#include <vector>

#include "slope/couple/case.hpp"
#include "slope/couple/geometry.hpp"
#include "slope/couple/state.hpp"
#include "slope/seepage/pore_flow.hpp"
#include "slope/solid/material_point_method.hpp"

namespace slope::couple {

/// The walls at which the water sees its mirror image: those that are not free.
[[nodiscard]] seepage::MirrorWalls mirror_walls(const Case& input);

/// One set of particles with both solvers on it: what each of them sees of the other. Index p is the same material
/// point in both.
class Mixture {
 public:
  Mixture(const Case& input, const InitialParticles& particles, std::span<const double> pressure, int threads);

  solid::MaterialPointMethod soil;
  seepage::PoreFlow water;

  /// What the water sees of the soil. A rigid skeleton keeps its first volumes and porosities.
  [[nodiscard]] seepage::Skeleton skeleton() const;
  /// What the soil sees of the water as it is now; the view holds until the next call.
  [[nodiscard]] solid::PoreState pore_state();
  /// Mass of the water that moves with the soil (kg/m), one per particle, from porosity, saturation and volume as they
  /// are now.
  [[nodiscard]] std::vector<double> water_mass() const;
  /// Multiplies the soil's velocities by a factor in (0, 1].
  void slow_down(double factor);
  [[nodiscard]] bool rigid() const { return rigid_; }
  /// That of the mixture itself; the solvers have theirs.
  [[nodiscard]] const MixtureState& state() const { return state_; }
  void set_state(MixtureState state) { state_ = std::move(state); }

 private:
  void weigh_water(std::vector<double>& mass) const;

  bool rigid_;
  bool saturated_density_;
  MixtureState state_;
  std::vector<double> water_mass_;  // what pore_state() shows
};

}  // namespace slope::couple
