// The vertical cut on twice as many cells.

#include <gtest/gtest.h>

#include <algorithm>

#include "slope/testing/record.hpp"
#include "vertical_cut.hpp"

namespace slope::testing {
namespace {

TEST(VerticalCutFine, FallsOnSixteenCells) {
  double latest = 0.0;
  for (const double nu : poissons_ratios) {
    const couple::Summary summary = cut(0.91, 16, nu);
    EXPECT_EQ(summary.end_reason, couple::EndReason::displacement) << nu;
    latest = std::max(latest, summary.time);
  }
  EXPECT_TRUE(
      record("cut-falls-4", "- 16 cells, 0.91: time to 30 cm, the longest of all nu", at_most(4.0), latest, "s"));
}

TEST(VerticalCutFine, StandsOnSixteenCells) {
  EXPECT_TRUE(record("cut-stands-2", "- 16 cells, 1.05 stands: displacement in 6 s, the largest of all nu",
                     at_most(1.0), 1e3 * displacement(1.05, 16).most, "mm"));
}

}  // namespace
}  // namespace slope::testing
