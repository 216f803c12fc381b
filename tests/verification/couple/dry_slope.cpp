#include "dry_slope.hpp"

#include <cmath>
#include <numbers>

#include "slope/testing/circular_search.hpp"

namespace slope::testing {

namespace {

constexpr double cohesion = 4.69e3, friction_angle = 25.0 * std::numbers::pi / 180.0;  // of the cases

}  // namespace

std::vector<std::string> strength_over(double factor) {
  const double reduced_angle = std::atan(std::tan(friction_angle) / factor) * 180.0 / std::numbers::pi;
  return {"soils.loam.strength.cohesion=" + std::to_string(cohesion / factor) + " Pa",
          "soils.loam.strength.friction_angle=" + std::to_string(reduced_angle) + " deg"};
}

double factor_of_safety(const couple::Simulation& simulation) {
  const couple::Soil& soil = simulation.input().soils.front();
  const std::vector<couple::Point>& corners = simulation.input().regions.front().polygon;
  const auto& strength = std::get<solid::MohrCoulomb>(soil.solid.strength);
  const double density =
      (1.0 - soil.porosity) * soil.solid.grain_density + soil.porosity * simulation.input().water.density;
  return critical_circle({.toe = corners[4], .crest = corners[3], .base = corners[0][1]},
                         {.unit_weight = density * simulation.input().gravity,
                          .friction_angle = [&](double, double) { return strength.friction_angle; },
                          .cohesion = [&](double, double) { return strength.cohesion; },
                          .pore_stress = [](double, double) { return 0.0; }})
      .factor_of_safety;
}

}  // namespace slope::testing
