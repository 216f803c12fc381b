#pragma once

#include <vector>

#include "actions.hpp"
#include "mixture.hpp"
#include "slope/seepage/coupled_step.hpp"

namespace slope::couple {

/// The default scheme: one loop, one clock, the soil explicit, the water implicit, and the volume change that links
/// them inside the pressure step, so that stiff water is stable at the soil's own time step.
class SemiImplicitScheme {
 public:
  [[nodiscard]] static double stable_step(const Mixture& mixture, double courant_number) {
    return mixture.soil.stable_step(courant_number, mixture.water_mass());
  }

  /// The water's time may run ahead of the soil's by any factor.
  [[nodiscard]] static double largest_clock_factor(const Mixture& /*mixture*/, double /*courant_number*/) {
    return never;
  }

  explicit SemiImplicitScheme(double pressure_tolerance) : pressure_tolerance_(pressure_tolerance) {}

  /// One step.
  /// @param time_step  dt of the soil (s); @param clock_factor  Theta: the water's time advances by Theta dt
  seepage::SolveReport step(Mixture& mixture, const Actions& actions, double time_step, double clock_factor);

 private:
  double pressure_tolerance_;
  std::vector<double> strain_;
  seepage::CoupledStep water_step_;
};

}  // namespace slope::couple
