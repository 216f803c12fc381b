// Standing water: its weight and its pressure in the pores leave the effective stress alone.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "run_case.hpp"
#include "slope/testing/record.hpp"

namespace slope::testing {
namespace {

constexpr double unit_weight = 9810.0;

// Saturated level ground, 2 m high, that lets water through, under a lake whose level rises from 2.5 m to 6.5 m.
std::vector<std::string> flooded(const std::string& level) {
  return {"initial.water={type: hydrostatic, water_table: 2.5 m}",
          "coupling={skeleton: deformable, mixture_density: by_saturation}",
          "soils.sand.strength={model: elastic}",
          "soils.sand.hydraulic_conductivity=1e-4 m/s",
          "water_boundaries=[{name: lake, at: free_surface, initial: true, reservoir: {level: " + level + "}}]",
          "stop.time=60 s",
          "output.history_interval=10 s"};
}

TEST(Reservoir, LeavesTheEffectiveStressOfSubmergedGroundAlone) {
  couple::Simulation simulation = start_case("ground.yaml", flooded("[[5 s, 2.5 m], [45 s, 6.5 m]]"));
  const couple::ParticleTable before = simulation.particles();
  run(simulation, [](const couple::ParticleTable&) {});
  const couple::ParticleTable after = simulation.particles();
  const double added = unit_weight * 4.0;
  double stress = 0.0, pressure = 0.0;
  for (std::size_t p = 0; p < before.position.size(); ++p) {
    pressure = std::max(pressure, std::abs(after.pore_pressure[p] - before.pore_pressure[p] - added));
    if (before.position[p][1] > 1.75) continue;
    stress = std::max({stress, std::abs(after.stress_effective[p].yy - before.stress_effective[p].yy),
                       std::abs(after.stress_effective[p].xx - before.stress_effective[p].xx)});
  }
  EXPECT_TRUE(record("reservoir-effective-stress",
                     "Lake rising by 4 m on submerged ground: change of the effective stress below the topmost cell, "
                     "over the added pressure",
                     at_most(0.01), stress / added, "%"));
  EXPECT_TRUE(record("reservoir-pore-pressure", "- pore pressure 15 s later, error over the added pressure",
                     at_most(0.01), pressure / added, "%"));
}

TEST(Reservoir, WeighsInTheInitialStress) {
  double stress = 0.0;
  const couple::Simulation shallow = start_case("ground.yaml", flooded("2.5 m"));
  auto deeper = flooded("12.5 m");
  deeper[0] = "initial.water={type: hydrostatic, water_table: 12.5 m}";
  const couple::Simulation deep = start_case("ground.yaml", deeper);
  const couple::ParticleTable a = shallow.particles(), b = deep.particles();
  for (std::size_t p = 0; p < a.position.size(); ++p) {
    stress = std::max(stress, std::abs(a.stress_effective[p].yy - b.stress_effective[p].yy));
    EXPECT_NEAR(b.pore_pressure[p] - a.pore_pressure[p], 10.0 * unit_weight, 1.0);
  }
  EXPECT_LT(stress, 1e-4 * 10.0 * unit_weight);
}

TEST(Reservoir, KeepsASubmergedBlockStill) {
  couple::Simulation simulation = start_case("ground.yaml", [] {
    auto overrides = flooded("[[5 s, 2.5 m], [45 s, 6.5 m]]");
    overrides.emplace_back(
        "geometry.0.polygon=[[0 m, 0 m], [4 m, 0 m], [4 m, 0.5 m], [3 m, 0.5 m], [3 m, 1.5 m], "
        "[1.5 m, 1.5 m], [1 m, 0.5 m], [0 m, 0.5 m]]");
    return overrides;
  }());
  run(simulation, [](const couple::ParticleTable&) {});
  EXPECT_TRUE(record("reservoir-block", "- block on it, largest displacement", at_most(0.1),
                     1e3 * simulation.summary().largest_displacement, "mm"));
}

// A block on rollers, 4 m high and long, with water on both sides: its centre begins to move as the two triangles of
// pressure push it.
TEST(Reservoir, PushesABlockByTheDifferenceOfTwoLevels) {
  const double left = 3.0, right = 1.0;
  couple::Simulation simulation = start_case(
      "ground.yaml",
      {"domain={lower: [0 m, 0 m], upper: [10 m, 5 m], cell_size: 0.25 m, particles_per_cell: 4}",
       "geometry.0.polygon=[[3 m, 0 m], [7 m, 0 m], [7 m, 4 m], [3 m, 4 m]]", "soils.sand.strength={model: elastic}",
       "water_boundaries=[{name: lake, at: free_surface, to: 4.5 m, reservoir: {level: 3 m}}, {name: pond, at: "
       "free_surface, from: 5.5 m, reservoir: {level: 1 m}}]",
       "clock.adaptive=false", "stop.time=0.05 s"});
  run(simulation, [](const couple::ParticleTable&) {});
  double velocity = 0.0;
  const couple::ParticleTable table = simulation.particles();
  for (const couple::Point& v : table.velocity) velocity += v[0] / static_cast<double>(table.velocity.size());
  const double mass = 16.0 * (0.65 * 2700.0 + 0.35 * 1000.0);
  const double exact = 0.5 * unit_weight * (left * left - right * right) / mass * 0.05;
  EXPECT_TRUE(record("reservoir-two-levels",
                     "Block between two reservoirs: speed that the difference of their levels gives "
                     "it, over the exact one",
                     near(1.0, 0.005), velocity / exact, ""));
}

// What bears the stress ratio is the buoyant weight.
TEST(Reservoir, LeavesTheRatioOfAK0StressAlone) {
  auto overrides = flooded("6.5 m");
  overrides[0] = "initial={water: {type: hydrostatic, water_table: 6.5 m}, stress: k0, k0_coefficient: 0.6}";
  const couple::ParticleTable table = start_case("ground.yaml", overrides).particles();
  double error = 0.0;
  for (std::size_t p = 0; p < table.position.size(); ++p) {
    const double y = table.position[p][1];
    if (y < 0.5 || y > 1.5)
      continue;  // the cells at the base and the surface bear less exactly, with or without a lake
    const double vertical = -table.stress_effective[p].yy, depth = 2.0 - y;
    EXPECT_NEAR(vertical, 0.65 * (2700.0 - 1000.0) * 9.81 * depth, 0.02 * 0.65 * 1700.0 * 9.81 * 2.0);
    error = std::max(error, std::abs(-table.stress_effective[p].xx / vertical / 0.6 - 1.0));
  }
  EXPECT_TRUE(record("reservoir-k0", "Level ground under a lake, K0 = 0.6: error of the stress ratio", at_most(1e-3),
                     error, ""));
}

// A dam between two reservoirs, 5 m high and 6 m long, in soil with a capillary fringe of 5 cm: Charny's discharge, and
// what the fringe adds (see dam_test.cpp).
TEST(Reservoir, SteadyFlowThroughADamHoldsBeforeTheStart) {
  const double upstream = 4.0, downstream = 1.0, length = 6.0, conductivity = 1e-4, alpha = 20.0;
  couple::Simulation simulation = start_case(
      "ground.yaml",
      {"domain={lower: [0 m, 0 m], upper: [10 m, 6 m], cell_size: 0.25 m, particles_per_cell: 4}",
       "geometry.0.polygon=[[2 m, 0 m], [8 m, 0 m], [8 m, 5 m], [2 m, 5 m]]",
       "soils.sand.hydraulic_conductivity=1e-4 m/s",
       "soils.sand.retention={model: exponential, alpha: 20 1/m, residual_saturation: 0.1, maximum_saturation: 1}",
       "soils.sand.relative_permeability={model: exponential, alpha: 20 1/m}",
       "initial.water={type: steady, water_table: 3 m}", "coupling.scheme=seepage",
       "water_boundaries=[{name: lake, at: free_surface, to: 4 m, initial: true, reservoir: {level: 4 m}}, {name: "
       "pond, at: "
       "free_surface, from: 6 m, initial: true, reservoir: {level: 1 m}}]",
       "stop.time=1 h", "output.history_interval=1 h"});
  const couple::ParticleTable table = simulation.particles();
  double exit_height = downstream;
  for (std::size_t p = 0; p < table.position.size(); ++p) {
    if (table.position[p][0] > 7.9 && table.pore_pressure[p] > 0.0) {
      exit_height = std::max(exit_height, table.position[p][1] + 0.0625);
    }
  }
  EXPECT_GT(exit_height, downstream + 0.1) << "there is an exit face";
  run(simulation, [](const couple::ParticleTable&) {});
  const couple::WaterBudget water = simulation.summary().water;
  EXPECT_NEAR(water.infiltration, water.by_boundary.at("lake"), 1e-9 * water.infiltration);
  EXPECT_LT(std::abs(water.storage), 1e-4 * water.infiltration) << "steady";
  const double fringe = conductivity * (upstream - exit_height) / (alpha * length);
  const double exact = conductivity * (upstream * upstream - downstream * downstream) / (2.0 * length);
  EXPECT_TRUE(
      record("reservoir-dam",
             "Dam between two reservoirs, steady before the start: discharge without the fringe's, over K (h1^2 - "
             "h2^2) / 2L",
             near(1.0, 0.02), (water.infiltration / 3600.0 - fringe) / exact, ""));
}

}  // namespace
}  // namespace slope::testing
