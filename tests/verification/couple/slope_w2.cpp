// The slope of the paper under rain (case W2): it stands before the rain, fails from the toe upwards, and the figures
// that must not depend on how fast the clock runs do not.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "run_case.hpp"
#include "slope/testing/record.hpp"

namespace slope::testing {
namespace {

const std::string to_onset = "stop.displacement=3 cm";

couple::Summary run_to_end(couple::Simulation simulation) {
  run(simulation, [](const couple::ParticleTable&) {});
  return simulation.summary();
}

double onset(const std::vector<std::string>& overrides) {
  return run_to_end(start_shipped_case("paper/slope-w2.yaml", overrides)).onset_time.value();
}

TEST(SlopeW2, StandsBeforeTheRain) {
  couple::Simulation simulation = start_shipped_case(
      "paper/slope-w2.yaml", {"water_boundaries.rain.start=11 s", "stop.time=10 s", "clock.adaptive=false"});
  EXPECT_TRUE(record("slope-w2-1", "Slope W2 before the rain: largest flux of the head operator over k",
                     at_most(1.0e-9), simulation.summary().initial_head_flux, ""));
  const couple::Summary still = run_to_end(std::move(simulation));
  EXPECT_TRUE(record("slope-w2-2", "- largest displacement in 10 s of dynamics", at_most(0.1),
                     still.largest_displacement * 1000.0, "mm"));
}

TEST(SlopeW2, FailsFromTheToeUpwards) {
  couple::Simulation simulation = start_shipped_case("paper/slope-w2.yaml");
  run(simulation, [](const couple::ParticleTable&) {});
  const couple::Summary summary = simulation.summary();
  ASSERT_TRUE(summary.onset_time && summary.zone_at_onset && summary.zone_at_10_cm);
  // the toe is at a height of 5 m, the crest at 12 m
  EXPECT_LT(summary.onset_position[1], 7.0);
  EXPECT_LT(summary.zone_at_10_cm->lowest, 5.5);
  EXPECT_GT(summary.zone_at_10_cm->highest, summary.zone_at_onset->highest + 1.0);
  EXPECT_GT(summary.zone_at_end.highest, summary.zone_at_10_cm->highest + 1.0);
  EXPECT_TRUE(record("slope-w2-3", "Slope W2 through the slide: water balance error over the infiltration",
                     at_most(1.0e-4), std::abs(summary.water.relative_balance_error), ""));
  EXPECT_TRUE(record("slope-w2-4", "- alternating part of the pore pressure (checkerboard measure)", at_most(0.01),
                     summary.pressure_checkerboard, ""));
  const couple::ParticleTable end = simulation.particles();
  EXPECT_EQ(end.position.size(), summary.particles);
  for (std::size_t p = 0; p < end.position.size(); ++p) {
    ASSERT_TRUE(std::isfinite(end.position[p][0] + end.pore_pressure[p] + end.stress_effective[p].xx)) << p;
  }
}

TEST(SlopeW2, OnsetScalesWithTheConductivity) {
  const double middle = onset({to_onset});
  const double less_permeable =
      onset({to_onset, "soils.sandy_clay.hydraulic_conductivity=5e-6 m/s", "water_boundaries.rain.ramp=10 s"});
  EXPECT_TRUE(record("slope-w2-6", "- 2 cm onset times k, with k halved, change", at_most(0.03),
                     std::abs(0.5 * less_permeable / middle - 1.0), "%"));
}

}  // namespace
}  // namespace slope::testing
