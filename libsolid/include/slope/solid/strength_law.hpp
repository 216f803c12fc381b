#pragma once

#include <variant>

#include "slope/solid/drucker_prager.hpp"
#include "slope/solid/mohr_coulomb.hpp"
#include "slope/solid/von_mises.hpp"

namespace slope::solid {

/// A strength with all that does not change worked out. Every law that yields has `at(suction, plastic_strain)`, a
/// yield surface, for which there is a `return_to_yield_surface`, and which can be `isochoric()`.
using StrengthLaw = std::variant<NoYield, SuctionDependentCone, SuctionDependentPyramid, SofteningCylinder>;

/// @param cell_size  of the grid (m), > 0: softening may depend on it
[[nodiscard]] StrengthLaw make_strength_law(const Strength& strength, double cell_size);

/// Whether soil of this strength changes its volume where it shears.
[[nodiscard]] bool dilates(const Strength& strength);

}  // namespace slope::solid
