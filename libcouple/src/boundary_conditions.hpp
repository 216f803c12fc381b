#pragma once

#include <vector>

#include "actions.hpp"
#include "mixture.hpp"
#include "slope/couple/case.hpp"
#include "slope/couple/geometry.hpp"

namespace slope::couple {

/// The case's water boundaries, tractions and earthquake, tied to the particles that they were given at the start.
class BoundaryConditions {
 public:
  BoundaryConditions(const Case& input, const InitialParticles& particles);

  /// Sets what acts at a time (s); pressures ramp from those of the start.
  void apply(double time, const Mixture& mixture, Actions& actions) const;
  /// What holds before the start: the conditions marked `initial`, at their full value.
  void apply_initial(const Mixture& mixture, Actions& actions) const;
  /// Pressures from which ramps start.
  void remember_pressures(std::span<const double> pressure) {
    first_pressure_.assign(pressure.begin(), pressure.end());
  }

  /// Times at which a condition begins or ends its ramp, ascending (s).
  [[nodiscard]] const std::vector<double>& change_times() const { return change_times_; }
  /// Names of the water boundaries, by the index under which the water counts them.
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }

 private:
  void add_water(std::size_t boundary, double share, const Mixture& mixture, Actions& actions) const;

  std::vector<WaterBoundary> water_;
  std::vector<Traction> tractions_;
  Seismic seismic_;
  double gravity_;
  std::vector<std::vector<std::size_t>> water_particles_, traction_particles_;
  std::vector<std::string> names_;
  std::vector<double> change_times_;
  std::vector<double> first_pressure_;
  std::vector<double> face_distance_;
  double spacing_;
};

}  // namespace slope::couple
