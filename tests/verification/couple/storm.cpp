// The water's books of the quick slope.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "run_case.hpp"
#include "slope/testing/record.hpp"

namespace slope::testing {
namespace {

// A shower that begins the slide, two hours of drying, a cloudburst that ponds and takes the slide on, and drying until
// the soil has its suction back.
TEST(Storm, BudgetClosesThroughInfiltrationPondingDryingAndTheSlide) {
  couple::Simulation simulation = start_shipped_case(
      "quick.yaml",
      {"water_boundaries=[{name: rain, at: free_surface, rain: {hyetograph: [[0 h, 100 mm/h], [0.05 h, -20 "
       "mm/d], [2 h, 1200 mm/h], [2.03 h, -20 mm/d]], evaporation_limit: 60 kPa}}]",
       "stop={time: 4 h}", "output.history_interval=2 min"});
  double largest_mismatch = 0.0, largest_error = 0.0;
  for (couple::Event event; !event.finished;) {
    event = simulation.advance();
    const couple::WaterBudget water = simulation.summary().water;
    if (water.rain <= 0.0) continue;
    largest_mismatch =
        std::max(largest_mismatch, std::abs(water.rain_infiltration + water.run_off - water.rain) / water.rain);
    largest_error = std::max(largest_error, std::abs(water.infiltration - water.outflow - water.storage) / water.rain);
  }
  const couple::Summary summary = simulation.summary();
  const couple::WaterBudget& water = summary.water;
  EXPECT_TRUE(summary.onset_time.has_value());
  EXPECT_GT(summary.largest_displacement, 0.2) << "it slides";
  EXPECT_GT(summary.zone_at_end.largest_suction, 30e3) << "it dries";
  EXPECT_GT(water.run_off, 0.1 * water.rain);
  EXPECT_GT(water.seepage, 0.1 * water.infiltration);
  EXPECT_GT(water.evaporation, 0.1 * water.infiltration);
  EXPECT_TRUE(record("storm-budget",
                     "Rain, drying, ponding, slide, drying: largest water balance error over the rain until then",
                     at_most(1e-3), largest_error, ""));
  EXPECT_TRUE(
      record("storm-rain", "- rain less infiltration and run-off, over the rain", at_most(1e-6), largest_mismatch, ""));
}

}  // namespace
}  // namespace slope::testing
