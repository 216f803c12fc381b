#include "initial_values.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace slope::couple {

double WaterTable::height_at(double x) const {
  const auto right = std::ranges::find_if(points, [&](const Point& point) { return point[0] >= x; });
  if (right == points.end()) return points.back()[1];
  if (right == points.begin()) return points.front()[1];
  const Point& a = *(right - 1);
  const Point& b = *right;
  return a[1] + (b[1] - a[1]) * ((x - a[0]) / (b[0] - a[0]));
}

std::vector<double> initial_pressure(const Case& input, const InitialParticles& particles) {
  const double unit_weight = input.water.density * input.gravity;
  std::vector<double> pressure(particles.x.size());
  for (std::size_t p = 0; p < pressure.size(); ++p) {
    if (const auto* hydrostatic = std::get_if<HydrostaticWater>(&input.initial_water)) {
      pressure[p] = std::max(unit_weight * (hydrostatic->water_table - particles.y[p]), -hydrostatic->maximum_suction);
    } else if (const auto* table = std::get_if<WaterTable>(&input.initial_water)) {
      const double height = table->height_at(particles.x[p]);
      pressure[p] = std::max(unit_weight * (height - particles.y[p]), -table->maximum_suction);
    } else if (const auto* uniform = std::get_if<UniformWater>(&input.initial_water)) {
      pressure[p] = uniform->pressure;
    } else {
      pressure[p] = unit_weight * (std::get<SteadyWater>(input.initial_water).water_table - particles.y[p]);
    }
  }
  return pressure;
}

std::optional<double> friction_angle_of(const solid::Strength& strength) {
  return std::visit(
      [](const auto& law) -> std::optional<double> {
        if constexpr (requires { law.friction_angle; }) return law.friction_angle;
        return std::nullopt;
      },
      strength);
}

std::vector<double> k0_of_soils(const Case& input) {
  std::vector<double> k0;
  for (const Soil& soil : input.soils) {
    k0.push_back(input.k0_coefficient ? *input.k0_coefficient
                                      : 1.0 - std::sin(friction_angle_of(soil.solid.strength).value()));
  }
  return k0;
}

}  // namespace slope::couple
