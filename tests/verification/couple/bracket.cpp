// A slope whose factor of safety by a circular search is 1.4 stands; with its strength divided by 1.5 it falls. An
// embankment whose factor by published limit equilibrium is below one falls.

#include <gtest/gtest.h>

#include "dry_slope.hpp"
#include "run_case.hpp"
#include "slope/testing/record.hpp"

namespace slope::testing {
namespace {

TEST(Bracket, StandsWithAFactorOfSafetyOf14) {
  couple::Simulation simulation = start_case("bracket.yaml", strength_over(1.0));
  EXPECT_TRUE(record("bracket-1", "Slope 1:1.5, Mohr-Coulomb: factor of safety by Bishop's circular search",
                     near(1.4, 0.005), factor_of_safety(simulation), ""));
  EXPECT_LT(simulation.summary().initial_unbalanced_ratio, 1.0e-5);
  double settling = 0.0;  // displacement of the last second
  run(simulation, [&](const couple::ParticleTable& table) {
    if (table.time < 3.5) settling = simulation.summary().largest_displacement;
  });
  const couple::Summary summary = simulation.summary();
  EXPECT_EQ(summary.end_reason, "time");
  EXPECT_TRUE(record("bracket-2", "- it stands: largest displacement in 4 s of dynamics", at_most(0.1),
                     1e3 * summary.largest_displacement, "mm"));
  EXPECT_LT(summary.largest_displacement - settling, 0.2 * summary.largest_displacement) << "comes to rest";
}

TEST(Bracket, FallsWithItsStrengthDividedBy15) {
  couple::Simulation simulation = start_case("bracket.yaml", strength_over(1.5));
  EXPECT_NEAR(factor_of_safety(simulation), 1.4 / 1.5, 0.005);
  run(simulation, [](const couple::ParticleTable&) {});
  const couple::Summary summary = simulation.summary();
  ASSERT_TRUE(summary.onset_time.has_value());
  EXPECT_EQ(summary.end_reason, "displacement") << "the slide goes on to 30 cm";
  EXPECT_TRUE(record("bracket-3",
                     "- with c and tan(phi) divided by 1.5 (factor 0.93) it falls: time to a displacement of 30 cm",
                     at_most(4.0), summary.time, "s"));
}

// Clay that flows at constant volume under an embankment, with three cells in its depth.
TEST(RoadEmbankment, FailsWithAFactorOfSafetyOf091OnCoarseCells) {
  couple::Simulation simulation = start_case("road_embankment.yaml");
  run(simulation, [](const couple::ParticleTable&) {});
  const couple::Summary summary = simulation.summary();
  EXPECT_EQ(summary.end_reason, "displacement");
  EXPECT_TRUE(record("bracket-4", "Road embankment on soft clay, factor 0.91 by Spencer, 5 ft cells: time to 5 cm",
                     at_most(8.0), summary.time, "s"));
}

}  // namespace
}  // namespace slope::testing
