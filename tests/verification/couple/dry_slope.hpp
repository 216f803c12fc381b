#pragma once

#include <string>
#include <vector>

#include "slope/couple/simulation.hpp"

namespace slope::testing {

/// What divides the strength of the loam in bracket.yaml and slope_factor.yaml by a factor.
[[nodiscard]] std::vector<std::string> strength_over(double factor);

/// By Bishop's method, with the geometry and the strength that the simulation has.
[[nodiscard]] double factor_of_safety(const couple::Simulation& simulation);

}  // namespace slope::testing
