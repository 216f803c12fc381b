#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "balance.hpp"
#include "boundary_conditions.hpp"
#include "clock_control.hpp"
#include "mixture.hpp"
#include "slope/couple/simulation.hpp"

namespace slope::couple {

/// Lets the water flow in the unmoved soil until it is steady under the conditions that hold before the start.
/// @param go_on  is asked after each step. @return whether it got to the end
/// @throws SimulationError if it does not come to rest; it names the particle that changes most
[[nodiscard]] bool find_steady_flow(Mixture& mixture, BoundaryConditions& conditions, const InitialObserver& go_on);

/// Builds the self-weight stress at fixed positions, first elastic, then with the soil's strength, by damped motion;
/// the pore pressure stays as it is. What strength laws remember is that of the elastic stress, changed by yielding.
/// @param go_on  is asked now and then
/// @return the unbalanced over the gravity forces that are left (-); none: it was not to go on
[[nodiscard]] std::optional<double> find_self_weight_stress(Mixture& mixture, const Actions& actions,
                                                            const SlopeScale& scale, const TimeStep& time_step,
                                                            const InitialObserver& go_on);

/// The same from a vertical effective stress by the weight of the soil above each particle, less the pore pressure, and
/// horizontal ones in the ratio of each soil; on a slope, balance and strength then change it.
/// @param k0  by soil (-), > 0
/// @param spacing  of the particles at the start (m)
[[nodiscard]] std::optional<double> find_k0_stress(Mixture& mixture, const Actions& actions, const SlopeScale& scale,
                                                   const TimeStep& time_step, double spacing,
                                                   std::span<const double> k0, const InitialObserver& go_on);

/// The stress under a body acceleration (m/s2) that acts from the start on, after that of the weight alone: as if it
/// had grown slowly. Soil that it moves has the stress of its steady motion. @return false if it was not to go on
[[nodiscard]] bool add_standing_acceleration(Mixture& mixture, Actions actions, std::array<double, 2> acceleration,
                                             const SlopeScale& scale, const TimeStep& time_step,
                                             const InitialObserver& go_on);

}  // namespace slope::couple
