#pragma once

#include <optional>
#include <vector>

#include "slope/couple/case.hpp"
#include "slope/couple/geometry.hpp"

// What a case says of the state before the start, in numbers.

namespace slope::couple {

/// Pore pressure of each particle before anything flows (Pa).
[[nodiscard]] std::vector<double> initial_pressure(const Case& input, const InitialParticles& particles);

/// phi' at zero suction (rad); none if the strength has no friction.
[[nodiscard]] std::optional<double> friction_angle_of(const solid::Strength& strength);
/// Horizontal over vertical effective stress of each soil (-): the case's, or 1 - sin(phi') (Jaky 1944).
[[nodiscard]] std::vector<double> k0_of_soils(const Case& input);

}  // namespace slope::couple
