#pragma once

#include <vector>

#include "boundary_conditions.hpp"
#include "clock_control.hpp"
#include "mixture.hpp"

namespace slope::couple {

/// Pore pressure of each particle before anything flows (Pa).
[[nodiscard]] std::vector<double> initial_pressure(const Case& input, const InitialParticles& particles);

/// Lets the water flow in the unmoved soil until it is steady under the conditions that hold before the start.
/// @throws SimulationError if it does not come to rest
void find_steady_flow(Mixture& mixture, BoundaryConditions& conditions);

/// Builds the self-weight stress at fixed positions, first elastic, then with the soil's strength, by damped motion;
/// the pore pressure stays as it is. @return the unbalanced over the gravity forces that are left (-)
double find_self_weight_stress(Mixture& mixture, const Actions& actions, const SlopeScale& scale, double time_step);

}  // namespace slope::couple
