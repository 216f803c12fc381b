#pragma once

#include <functional>
#include <optional>

#include "actions.hpp"
#include "clock_control.hpp"
#include "mixture.hpp"
#include "slope/couple/simulation.hpp"

namespace slope::couple {

/// Unbalanced over gravity forces, left by the search for balance, above which the slope does not stand (-).
inline constexpr double unbalanced_limit = 1.0e-4;

/// At which the stress before the start is taken as found; the search for a factor of safety asks for less.
inline constexpr double balanced = 1.0e-6, nearly_balanced = 0.1 * unbalanced_limit;

/// What is asked for the length of each step of the soil (s): where the stiffness varies, it does.
using TimeStep = std::function<double()>;

enum class Yields { no, yes };

/// Damped motion of the soil at fixed positions, under the water as it is, until the forces balance. It is looked at
/// when it has gone on for twenty first periods, and each time this has doubled: it goes on while what is unbalanced
/// has fallen by enough. Soil that stands by a hair comes to rest slowly; soil that flows does not, and keeps the force
/// that its flow under the damping needs.
/// @param wanted  unbalanced over the gravity forces at which it ends (-), > 0; @param go_on  is asked now and then
/// @return the unbalanced over the gravity forces that are left (-); none: it was not to go on
[[nodiscard]] std::optional<double> find_balance(Mixture& mixture, const Actions& actions, const SlopeScale& scale,
                                                 const TimeStep& time_step, Yields yields, double wanted,
                                                 const InitialObserver& go_on);

}  // namespace slope::couple
