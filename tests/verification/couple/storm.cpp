// The quick slope under rain that it cannot take, through its slide: the water's books.

#include <gtest/gtest.h>

#include <cmath>

#include "run_case.hpp"
#include "slope/testing/record.hpp"

namespace slope::testing {
namespace {

TEST(Storm, BudgetClosesThroughTheSlide) {
  couple::Simulation simulation = start_shipped_case(
      "quick.yaml",
      {"water_boundaries=[{name: rain, at: free_surface, rain: {hyetograph: [[0 s, 400 mm/h], [20 s, 2000 "
       "mm/h], [200 s, -5 mm/d]]}}]",
       "stop.time=5 min", "stop.displacement=40 cm"});
  double largest_mismatch = 0.0;
  for (couple::Event event; !event.finished;) {
    event = simulation.advance();
    const couple::WaterBudget water = simulation.summary().water;
    if (water.rain <= 0.0) continue;
    largest_mismatch =
        std::max(largest_mismatch, std::abs(water.rain_infiltration + water.run_off - water.rain) / water.rain);
  }
  const couple::Summary summary = simulation.summary();
  const couple::WaterBudget& water = summary.water;
  EXPECT_TRUE(summary.onset_time.has_value()) << "it slides";
  EXPECT_GT(water.run_off, 0.0);
  EXPECT_GT(water.seepage, 0.0);
  const double error = std::abs(water.infiltration - water.outflow - water.storage) / water.rain;
  EXPECT_TRUE(record("storm-budget", "Rain through ponding and a slide: water budget error over the rain",
                     at_most(1e-3), error, ""));
  EXPECT_TRUE(
      record("storm-rain", "- rain less infiltration and run-off, over the rain", at_most(1e-6), largest_mismatch, ""));
}

}  // namespace
}  // namespace slope::testing
