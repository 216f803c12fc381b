// How the factor of safety of a slope by strength reduction depends on the grid.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "known_factor.hpp"
#include "run_case.hpp"
#include "slope/testing/circular_search.hpp"
#include "slope/testing/record.hpp"
#include "weak_seam.hpp"

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

// Firm ground below the toe: no circle goes into it. Without friction a circle's factor of safety is an upper bound.
TEST(SlopeFactorFine, OfClayOverFirmGroundIsThatOfCirclesAboveIt) {
  const double found = found_factor(start_case("deep_clay.yaml", {"soils.lower.strength.undrained_strength=125 kPa"}));
  const auto constant = [](double value) { return [value](double, double) { return value; }; };
  const SlipCircle circle = critical_circle({.toe = {20.0, 10.0}, .crest = {40.0, 20.0}, .base = 10.0},
                                            {20.0e3, constant(0.0), constant(50.0e3), constant(0.0)});
  EXPECT_TRUE(record("known-slope-8", "- over clay that is 2.5 times as strong, over the circles'", near(1.0, 0.02),
                     found / circle.factor_of_safety, ""));
}

TEST(SlopeFactorFine, OfAWedgeOnASoftSeamFourCellsThick) {
  EXPECT_TRUE(record("weak-seam-1", "Wedge on a seam a third as strong, 4 cells thick, over the exact one",
                     near(1.0, 0.02), WeakSeam{.thickness = 2.0, .cell_size = 0.5}.found(), ""));
}

TEST(SlopeFactorFine, OfAWedgeOnASoftSeamOneCellThick) {
  EXPECT_TRUE(record("weak-seam-2", "- 1 cell thick", near(1.0, 0.02),
                     WeakSeam{.thickness = 1.0, .cell_size = 1.0}.found(), ""));
}

// The ground drops away at both ends, so that the slide has none to push against.
TEST(SlopeFactorFine, OfAFreeWedgeOnASoftSeamOneCellThick) {
  EXPECT_TRUE(record("weak-seam-3", "- 1 cell thick, 10 cells high, with free ends", near(1.0, 0.02),
                     WeakSeam{.thickness = 0.5, .cell_size = 0.5, .stands_free = true}.found(), ""));
}

TEST(SlopeFactorFine, OfAFreeWedgeOnASoftSeamInRock) {
  constexpr double rock = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(record("weak-seam-4", "- between soil that never yields", near(1.0, 0.02),
                     WeakSeam{.thickness = 0.5, .cell_size = 0.5, .times_as_strong = rock, .stands_free = true}.found(),
                     ""));
}

}  // namespace
}  // namespace slope::testing
