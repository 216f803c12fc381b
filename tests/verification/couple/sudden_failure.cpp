// A brittle slope in a cloudburst goes from creep to a metre within two seconds, in soil that is partly saturated: what
// is sheared and squeezed goes in and out of saturation within single steps.

#include <gtest/gtest.h>

#include <cmath>

#include "run_case.hpp"

namespace slope::testing {
namespace {

TEST(SuddenFailure, OfPartlySaturatedSoilKeepsItsWater) {
  couple::Simulation simulation =
      start_shipped_case("rain/brittle.yaml", {"water_boundaries.rain.rain.intensity=150 mm/h"});
  run(simulation, [](const couple::ParticleTable&) {});
  const couple::Summary summary = simulation.summary();
  EXPECT_EQ(summary.end_reason, couple::EndReason::displacement) << "it slides by a metre";
  ASSERT_TRUE(summary.onset_time.has_value());
  EXPECT_LT(summary.time - *summary.onset_time, 10.0);
  EXPECT_LT(summary.zone_at_end.largest_suction, 20.0e3) << "no more than before, and no spikes";
  EXPECT_LT(std::abs(summary.water.relative_balance_error), 1e-5);
}

}  // namespace
}  // namespace slope::testing
