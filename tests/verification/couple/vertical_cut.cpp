// A vertical cut in undrained clay: soil that flows at constant volume, so that what locks on a coarse grid shows. By
// limit analysis it falls below a factor 3.78 s_u / (gamma H) of one, whatever Poisson's ratio.

#include <gtest/gtest.h>

#include <algorithm>

#include "slope/testing/record.hpp"
#include "vertical_cut.hpp"

namespace slope::testing {
namespace {

TEST(VerticalCut, FallsOnEightCells) {
  double latest = 0.0;
  for (const double nu : {0.0, 0.33, 0.45}) {
    const couple::Summary summary = cut(0.875, 8, nu);
    EXPECT_EQ(summary.end_reason, couple::EndReason::displacement) << nu;
    latest = std::max(latest, summary.time);
  }
  EXPECT_TRUE(record("cut-falls-1", "Vertical cut, 8 cells, 3.78 s_u / (gamma H) = 0.875: time to 30 cm, nu 0 to 0.45",
                     at_most(4.0), latest, "s"));
  EXPECT_TRUE(record("cut-falls-2", "- nu 0.49: displacement in 6 s", at_least(25.0),
                     1e2 * cut(0.875, 8, 0.49).largest_displacement, "cm"));
}

TEST(VerticalCut, FailsCloseToOneOnEightCells) {
  EXPECT_TRUE(record("cut-falls-3", "- 0.91: displacement in 6 s, the least of nu 0, 0.33, 0.45 and 0.49",
                     at_least(5.0), 1e2 * displacement(0.91, 8).least, "cm"));
}

TEST(VerticalCut, StandsOnEightCells) {
  EXPECT_TRUE(record("cut-stands-1", "- 1.05 stands: displacement in 6 s, the largest of all nu", at_most(1.0),
                     1e3 * displacement(1.05, 8).most, "mm"));
}

}  // namespace
}  // namespace slope::testing
