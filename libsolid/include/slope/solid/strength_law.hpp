#pragma once

#include <cstddef>
#include <type_traits>
#include <variant>

#include "slope/solid/drucker_prager.hpp"
#include "slope/solid/modified_cam_clay.hpp"
#include "slope/solid/mohr_coulomb.hpp"
#include "slope/solid/von_mises.hpp"

namespace slope::solid {

/// A strength with all that does not change worked out. There are two kinds: a `LawWithState`; and a law for linear
/// elastic soil that remembers nothing but its plastic strain, with `at(suction, plastic_strain)`, a yield surface for
/// which there is a `return_to_yield_surface`, and which can be `isochoric()`.
using StrengthLaw =
    std::variant<NoYield, SuctionDependentCone, SuctionDependentPyramid, SofteningCylinder, HardeningEllipse>;

/// Calls visit(law) if the law is a LawWithState.
template <class Visit>
void with_state(const StrengthLaw& any, const Visit& visit) {
  std::visit(
      [&visit](const auto& law) {
        if constexpr (LawWithState<std::decay_t<decltype(law)>>) visit(law);
      },
      any);
}

[[nodiscard]] bool is_law_with_state(const StrengthLaw& law);

/// How many internal variables it has.
[[nodiscard]] std::size_t internal_count(const StrengthLaw& law);

/// @param cell_size  of the grid (m), > 0: softening may depend on it
[[nodiscard]] StrengthLaw make_strength_law(const Soil& soil, double cell_size);

/// Whether soil of this strength changes its volume where it shears.
[[nodiscard]] bool dilates(const Strength& strength);

}  // namespace slope::solid
