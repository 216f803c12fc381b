// How the factor of safety of a slope by strength reduction depends on the grid.

#include <gtest/gtest.h>

#include <algorithm>

#include "known_factor.hpp"
#include "slope/testing/record.hpp"

namespace slope::testing {
namespace {

double spread(const KnownFactor& slope) {
  const auto [least, most] = std::minmax({slope.found_on(5), slope.found_on(10), slope.found_on(20)});
  return most - least;
}

TEST(SlopeFactorFine, HardlyDependsOnTheGridInFrictionalSoil) {
  EXPECT_TRUE(record("slope-factor-2", "- spread over 5, 10 and 20 cells in the height, over Bishop's", at_most(0.03),
                     spread(frictional_slope()), "%"));
}

TEST(SlopeFactorFine, HardlyDependsOnTheGridInDilatantSoil) {
  EXPECT_TRUE(record("slope-factor-4", "- spread with the dilatancy angle = friction angle", at_most(0.03),
                     spread(dilatant_slope()), "%"));
}

TEST(SlopeFactorFine, HardlyDependsOnTheGridInUndrainedSoil) {
  EXPECT_TRUE(record("slope-factor-6", "- spread in undrained clay", at_most(0.03), spread(undrained_slope()), "%"));
}

}  // namespace
}  // namespace slope::testing
