#include "slope/testing/curve.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace slope::testing {
namespace {

const Curve line{{0.0, 1.0, 3.0}, {0.0, 2.0, -4.0}};

TEST(Curve, InterpolatesLinearlyAndMeetsItsPoints) {
  EXPECT_DOUBLE_EQ(interpolate(line, 0.25), 0.5);
  EXPECT_DOUBLE_EQ(interpolate(line, 2.0), -1.0);
  for (std::size_t i = 0; i < line.x.size(); ++i) EXPECT_DOUBLE_EQ(interpolate(line, line.x[i]), line.y[i]);
}

TEST(Curve, IsNotExtrapolated) {
  EXPECT_THROW((void)interpolate(line, -0.01), std::out_of_range);
  EXPECT_THROW((void)interpolate(line, 3.01), std::out_of_range);
  EXPECT_THROW((void)interpolate(line, std::numeric_limits<double>::quiet_NaN()), std::out_of_range);
}

TEST(Curve, RelativeErrorIsTheLargestDifferenceOverTheLargestReference) {
  const Curve curve{{0.5, 2.0}, {1.1, -1.4}};  // off by 0.1 and 0.4; the reference reaches -4
  EXPECT_NEAR(max_error(curve, line), 0.4, 1e-14);
  EXPECT_NEAR(max_relative_error(curve, line), 0.1, 1e-14);
}

TEST(Curve, ANaNIsNoSmallError) {
  const Curve curve{{0.5, 2.0}, {std::numeric_limits<double>::quiet_NaN(), -1.0}};
  EXPECT_FALSE(max_relative_error(curve, line) < 1.0);
}

TEST(Curve, NothingToCompareIsAnError) {
  EXPECT_THROW((void)max_error(Curve{}, line), std::invalid_argument);
  EXPECT_THROW((void)max_relative_error(line, Curve{{0.0, 3.0}, {0.0, 0.0}}), std::invalid_argument);
}

}  // namespace
}  // namespace slope::testing
