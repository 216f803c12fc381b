// Pressures, heads and fluxes at inclined ground act on the line as it is drawn: states that are known exactly.

#include <gtest/gtest.h>

#include <cmath>

#include "run_case.hpp"
#include "slope/testing/record.hpp"

namespace slope::testing {
namespace {

// A saturated layer under ground that rises by 2 in 3, with one condition there; the water alone.
couple::Simulation layer(const std::string& initial, const std::string& boundaries) {
  return start_case("ground.yaml",
                    {"domain={lower: [0 m, 0 m], upper: [6 m, 8 m], cell_size: 0.5 m, particles_per_cell: 4}",
                     "geometry.0.polygon=[[0 m, 0 m], [6 m, 0 m], [6 m, 7.1 m], [0 m, 3.1 m]]",
                     "soils.sand.hydraulic_conductivity=1e-4 m/s", "initial.water=" + initial,
                     "water_boundaries=[" + boundaries + "]", "coupling.scheme=seepage", "stop.time=2 h",
                     "output.history_interval=10 min"});
}

TEST(InclinedGround, UnderAHeldHeadIsAtRest) {
  couple::Simulation simulation =
      layer("{type: hydrostatic, water_table: 7.5 m}", "{name: lake, at: ground_surface, total_head: 7.5 m}");
  run(simulation, [](const couple::ParticleTable&) {});
  EXPECT_TRUE(record("inclined-1", "Inclined ground (2 in 3) under a held head: flow at rest, over k", at_most(1e-9),
                     simulation.summary().initial_head_flux, ""));
  EXPECT_NEAR(simulation.summary().water.infiltration, 0.0, 1e-12);
}

TEST(InclinedGround, TakesAFluxPerMetreOfItsOwnLength) {
  couple::Simulation simulation = layer("{type: uniform, pressure: -2 kPa}",
                                        "{name: rain, at: ground_surface, flux: 1e-7 m/s}, {name: drain, at: base, "
                                        "free_drainage: true}");
  run(simulation, [](const couple::ParticleTable&) {});
  const double exact = 1.0e-7 * 7200.0 * std::hypot(6.0, 4.0);
  EXPECT_TRUE(record("inclined-2", "- under a flux: inflow over flux times the length of the ground", near(1.0, 1.0e-6),
                     simulation.summary().water.by_boundary.at("rain") / exact, ""));
}

}  // namespace
}  // namespace slope::testing
