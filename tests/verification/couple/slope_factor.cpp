// The factor of safety of a slope by strength reduction beside that of limit equilibrium or limit analysis.

#include <gtest/gtest.h>

#include "known_factor.hpp"
#include "slope/testing/record.hpp"

namespace slope::testing {
namespace {

TEST(SlopeFactor, OfFrictionalSoilIsThatOfLimitEquilibrium) {
  EXPECT_TRUE(record("slope-factor-1", "Slope 1:1.5, factor of safety over Bishop's, 10 cells in the height",
                     near(1.0, 0.02), frictional_slope().found_on(10), ""));
}

TEST(SlopeFactor, OfDilatantSoilIsThatOfLimitEquilibrium) {
  EXPECT_TRUE(record("slope-factor-3", "- with the dilatancy angle = friction angle", near(1.0, 0.02),
                     dilatant_slope().found_on(10), ""));
}

TEST(SlopeFactor, OfUndrainedSoilIsThatOfLimitAnalysis) {
  EXPECT_TRUE(record("slope-factor-5", "- of undrained clay, over the mean of its bounds by limit analysis",
                     near(1.0, 0.02), undrained_slope().found_on(10), ""));
}

}  // namespace
}  // namespace slope::testing
