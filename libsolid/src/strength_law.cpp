#include "slope/solid/strength_law.hpp"

#include <type_traits>

namespace slope::solid {

namespace {

StrengthLaw law_of(const NoYield& none) {
  return none;
}
StrengthLaw law_of(const DruckerPrager& strength) {
  return SuctionDependentCone(strength);
}
StrengthLaw law_of(const MohrCoulomb& strength) {
  return SuctionDependentPyramid(strength);
}
StrengthLaw law_of(const VonMises& strength) {
  return SofteningCylinder(strength);
}

}  // namespace

StrengthLaw make_strength_law(const Strength& strength, double cell_size) {
  return std::visit(
      [cell_size](auto peak) {
        if constexpr (!std::is_same_v<decltype(peak), NoYield>) {
          if (peak.softening) peak.softening->range = peak.softening->range.in_cells_of(cell_size);
        }
        return law_of(peak);
      },
      strength);
}

bool dilates(const Strength& strength) {
  return std::visit(
      [](const auto& peak) {
        if constexpr (requires { peak.dilatancy_angle; }) return peak.dilatancy_angle > 0.0;
        return false;
      },
      strength);
}

}  // namespace slope::solid
