// The steady state under rain before the start, in exponential soil above a water table: the first state of Srivastava
// and Yeh (1991), k_rw = exp(alpha psi) = q + (1 - q) exp(-alpha z) with the rain q over the conductivity.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "run_case.hpp"
#include "slope/testing/record.hpp"

namespace slope::testing {
namespace {

constexpr double alpha = 10.0;  // 1/m
constexpr double rain = 0.1;    // over the conductivity

// A column 1 m high and four particles wide, 50 particles high.
couple::Simulation rained_column(const std::string& rain_text) {
  return start_case(
      "ground.yaml",
      {"domain={lower: [0 m, 0 m], upper: [0.08 m, 1.04 m], cell_size: 0.04 m, particles_per_cell: 4}",
       "geometry.0.polygon=[[0 m, 0 m], [0.08 m, 0 m], [0.08 m, 1 m], [0 m, 1 m]]", "soils.sand.porosity=0.4",
       "soils.sand.hydraulic_conductivity=10 mm/h",
       "soils.sand.retention={model: exponential, alpha: 10 1/m, residual_saturation: 0.15, maximum_saturation: 1}",
       "soils.sand.relative_permeability={model: exponential, alpha: 10 1/m}",
       "initial.water={type: steady, water_table: 0 m}",
       "water_boundaries=[{name: outlet, at: base, total_head: 0 m, initial: true}, {name: rain, at: "
       "free_surface, initial: true, rain: {" +
           rain_text + "}}]",
       "coupling.scheme=seepage", "stop.time=10 h", "output.history_interval=1 h"});
}

// Largest difference of the pressure head from the exact one, over the range of that.
double error_of(const couple::ParticleTable& table) {
  const auto exact = [](double z) { return std::log(rain + (1.0 - rain) * std::exp(-alpha * z)) / alpha; };
  double error = 0.0;
  for (std::size_t p = 0; p < table.position.size(); ++p) {
    error = std::max(error, std::abs(table.pore_pressure[p] / 9810.0 - exact(table.position[p][1])));
  }
  return error / -exact(1.0);
}

TEST(SteadyRain, IsTheExactStateBeforeTheStart) {
  couple::Simulation simulation = rained_column("intensity: 1 mm/h");
  EXPECT_TRUE(record("steady-rain", "Steady state under rain before the start, pressure head, of its range",
                     at_most(0.005), error_of(simulation.particles()), "%"));
  run(simulation, [](const couple::ParticleTable&) {});
  EXPECT_TRUE(record("steady-rain-stays", "- after ten hours of the same rain", at_most(0.005),
                     error_of(simulation.particles()), "%"));
  const couple::WaterBudget water = simulation.summary().water;
  EXPECT_NEAR(water.infiltration, 10.0e-3 * 0.08, 1e-9);
  EXPECT_NEAR(water.outflow, water.infiltration, 1e-3 * water.infiltration);
}

// Freely drained soil conducts what falls: k_rw = exp(alpha psi) = q everywhere.
TEST(SteadyRain, DrainsFreelyBeforeTheStart) {
  couple::Simulation simulation = start_case(
      "ground.yaml",
      {"domain={lower: [0 m, 0 m], upper: [0.08 m, 1.04 m], cell_size: 0.04 m, particles_per_cell: 4}",
       "geometry.0.polygon=[[0 m, 0 m], [0.08 m, 0 m], [0.08 m, 1 m], [0 m, 1 m]]",
       "soils.sand.hydraulic_conductivity=10 mm/h",
       "soils.sand.retention={model: exponential, alpha: 10 1/m, residual_saturation: 0.15, maximum_saturation: 1}",
       "soils.sand.relative_permeability={model: exponential, alpha: 10 1/m}",
       "initial.water={type: steady, water_table: 0 m}",
       "water_boundaries=[{name: drain, at: base, free_drainage: true, initial: true}, {name: rain, at: "
       "ground_surface, "
       "flux: [[0 h, 1 mm/h], [9 h, 1 mm/h]], initial: true}]",
       "coupling.scheme=seepage", "stop.time=10 h", "output.history_interval=1 h"});
  const double exact = 9810.0 * std::log(rain) / alpha;
  for (const double pressure : simulation.particles().pore_pressure) EXPECT_NEAR(pressure, exact, 2e-3 * -exact);
  run(simulation, [](const couple::ParticleTable&) {});
  const couple::WaterBudget water = simulation.summary().water;
  EXPECT_NEAR(water.by_boundary.at("drain"), -10.0e-3 * 0.08, 1e-3 * 10.0e-3 * 0.08);
  EXPECT_NEAR(water.outflow, water.infiltration, 1e-3 * water.infiltration);
}

TEST(SteadyRain, HasTheIntensityBeforeTheStart) {
  EXPECT_LT(error_of(rained_column("hyetograph: [[0 h, 9 mm/h]], before_start: 1 mm/h").particles()), 0.005);
  EXPECT_GT(error_of(rained_column("hyetograph: [[0 h, 9 mm/h]]").particles()), 0.1) << "then it is the first one";
}

}  // namespace
}  // namespace slope::testing
