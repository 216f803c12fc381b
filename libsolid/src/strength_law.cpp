#include "slope/solid/strength_law.hpp"

namespace slope::solid {

namespace {

StrengthLaw law_of(const NoYield& none, const Elastic& /*elastic*/) {
  return none;
}
StrengthLaw law_of(const DruckerPrager& strength, const Elastic& /*elastic*/) {
  return SuctionDependentCone(strength);
}
StrengthLaw law_of(const MohrCoulomb& strength, const Elastic& /*elastic*/) {
  return SuctionDependentPyramid(strength);
}
StrengthLaw law_of(const VonMises& strength, const Elastic& /*elastic*/) {
  return SofteningCylinder(strength);
}
StrengthLaw law_of(const ModifiedCamClay& strength, const Elastic& elastic) {
  return HardeningEllipse(strength, elastic.poissons_ratio);
}

}  // namespace

bool is_law_with_state(const StrengthLaw& law) {
  bool result = false;
  with_state(law, [&result](const auto& /*law*/) { result = true; });
  return result;
}

std::size_t internal_count(const StrengthLaw& law) {
  std::size_t count = 0;
  with_state(law, [&count](const auto& found) { count = found.internal_variables.size(); });
  return count;
}

StrengthLaw make_strength_law(const Soil& soil, double cell_size) {
  return std::visit(
      [&soil, cell_size](auto peak) {
        if constexpr (requires { peak.softening; }) {
          if (peak.softening) peak.softening->range = peak.softening->range.in_cells_of(cell_size);
        }
        return law_of(peak, soil.elastic);
      },
      soil.strength);
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
