// A slope whose factor of safety by a circular search is 1.4 stands; with its strength divided by 1.5 it falls. An
// embankment whose factor by published limit equilibrium is below one falls.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

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
  EXPECT_EQ(summary.end_reason, couple::EndReason::time);
  EXPECT_EQ(summary.verdict, couple::Verdict::stands);
  EXPECT_EQ(summary.slide_at_end.run_out, 0.0);
  EXPECT_TRUE(record("bracket-2", "- it stands: largest displacement in 4 s of dynamics", at_most(0.1),
                     1e3 * summary.largest_displacement, "mm"));
  EXPECT_LT(summary.largest_displacement - settling, 0.2 * summary.largest_displacement) << "comes to rest";
}

// Where the ground, column by column, first stands half a spacing above the level of the toe (m).
double front_of_ground(const couple::ParticleTable& table, double level, double spacing) {
  double front = std::numeric_limits<double>::infinity();
  for (double x = 0.0; x < 14.0; x += 0.01) {
    double height = 0.0;
    for (const couple::Point& at : table.position) {
      if (std::abs(at[0] - x) <= 0.5 * spacing) height = std::max(height, at[1] + 0.5 * spacing);
    }
    if (height > level + 0.5 * spacing) front = std::min(front, x);
  }
  return front;
}

TEST(Bracket, FallsUntilItRestsAndTellsHowFarItRan) {
  std::vector<std::string> overrides = strength_over(1.7);
  overrides.emplace_back("stop={time: 60 s, at_rest: true}");
  overrides.emplace_back("output={history_interval: 1 s}");
  couple::Simulation simulation = start_case("bracket.yaml", overrides);
  constexpr double level = 1.5, spacing = 0.125;
  run(simulation, [](const couple::ParticleTable&) {});
  const couple::Summary summary = simulation.summary();
  EXPECT_EQ(summary.verdict, couple::Verdict::does_not_stand);
  EXPECT_EQ(summary.end_reason, couple::EndReason::at_rest);
  ASSERT_TRUE(summary.slide_at_end.run_out.has_value());
  const double advance = 4.0 - front_of_ground(simulation.particles(), level, spacing);
  EXPECT_GT(advance, 4.0 * spacing);
  EXPECT_TRUE(record("bracket-4", "- by 1.7: advance of its ground line beyond the toe, column by column",
                     near(advance, spacing), *summary.slide_at_end.run_out, "m"));
  EXPECT_EQ(summary.slide_at_end.direction, -1.0);
  EXPECT_EQ(summary.slide_at_end.toe, (couple::Point{4.0, 1.5}));
  EXPECT_NEAR(summary.slide_at_end.largest_horizontal_displacement, advance, 0.5);
  EXPECT_GT(summary.slide_at_end.area, 3.0);
}

TEST(Bracket, FallsWithItsStrengthDividedBy15) {
  couple::Simulation simulation = start_case("bracket.yaml", strength_over(1.5));
  EXPECT_NEAR(factor_of_safety(simulation), 1.4 / 1.5, 0.005);
  run(simulation, [](const couple::ParticleTable&) {});
  const couple::Summary summary = simulation.summary();
  ASSERT_TRUE(summary.onset_time.has_value());
  EXPECT_EQ(summary.end_reason, couple::EndReason::displacement) << "the slide goes on to 30 cm";
  EXPECT_EQ(summary.verdict, couple::Verdict::does_not_stand);
  EXPECT_EQ(summary.runaway_onset, 0.0);
  EXPECT_TRUE(record("bracket-3",
                     "- with c and tan(phi) divided by 1.5 (factor 0.93) it falls: time to a displacement of 30 cm",
                     at_most(4.0), summary.time, "s"));
}

// With a factor of 1.008 a slope comes to rest slowly; what is left when the search for its stress ends, moves it
// later.
TEST(RoadCut, IsInBalanceBeforeItsRain) {
  const couple::Simulation simulation = start_shipped_case("rain/road-cut.yaml");
  EXPECT_TRUE(record("bracket-5", "Road cut, factor 1.008: forces out of balance before its rain, over the weight",
                     at_most(1.0), 1e6 * simulation.summary().initial_unbalanced_ratio, "1e-6"));
}

TEST(Swelling, IsNoFailure) {
  couple::Simulation simulation = start_case("swelling.yaml");
  run(simulation, [](const couple::ParticleTable&) {});
  const couple::Summary summary = simulation.summary();
  EXPECT_GT(summary.largest_displacement, summary.onset_criterion);
  EXPECT_TRUE(summary.displacement_onset.has_value());
  EXPECT_FALSE(summary.runaway_onset.has_value());
  EXPECT_EQ(summary.zone_at_end.area, 0.0);
  EXPECT_EQ(summary.verdict, couple::Verdict::moves);
}

// Clay that flows at constant volume under an embankment, with three cells in its depth.
TEST(RoadEmbankment, FailsWithAFactorOfSafetyOf091OnCoarseCells) {
  couple::Simulation simulation = start_case("road_embankment.yaml");
  run(simulation, [](const couple::ParticleTable&) {});
  const couple::Summary summary = simulation.summary();
  EXPECT_EQ(summary.end_reason, couple::EndReason::displacement);
  EXPECT_TRUE(record("embankment-1", "Road embankment on soft clay, factor 0.91 by Spencer, 5 ft cells: time to 5 cm",
                     at_most(8.0), summary.time, "s"));
}

}  // namespace
}  // namespace slope::testing
