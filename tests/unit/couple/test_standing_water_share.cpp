#include <gtest/gtest.h>

#include "case/standing_water_share.hpp"

namespace slope::couple {
namespace {

WaterBoundary reservoir(double from, double to) {
  WaterBoundary boundary;
  boundary.where = {Place::free_surface, from, to};
  boundary.condition = Reservoir{};
  return boundary;
}

TEST(StandingWaterShare, OfOneReservoirIsAllOfIt) {
  const std::vector<WaterBoundary> one{WaterBoundary{}, reservoir(3.0, 5.0)};
  const StandingWaterShare share(one);
  for (const double x : {-9.0, 4.0, 99.0}) EXPECT_EQ(share.of(1, x).value, 1.0);
  EXPECT_EQ(share.of(0, 4.0).value, 0.0) << "no reservoir";
  EXPECT_EQ(share.gap_after(1), never);
}

TEST(StandingWaterShare, AddsUpToOneBetweenReservoirsInAnyOrder) {
  const std::vector<WaterBoundary> three{reservoir(20.0, never), reservoir(-never, 4.0), reservoir(8.0, 16.0)};
  const StandingWaterShare share(three);
  EXPECT_EQ(share.gap_after(1), 4.0);
  EXPECT_EQ(share.gap_after(2), 4.0);
  EXPECT_EQ(share.of(2, 12.0).value, 1.0);
  EXPECT_EQ(share.of(2, 7.0).value, 0.75);
  EXPECT_EQ(share.of(2, 17.0).value, 0.75);
  for (double x = -1.1; x < 25.0; x += 0.25) {
    double value = 0.0, slope = 0.0;
    for (std::size_t b = 0; b < 3; ++b) {
      const auto part = share.of(b, x);
      value += part.value;
      slope += part.slope;
      const double ahead = share.of(b, x + 1e-6).value;
      EXPECT_NEAR(ahead - part.value, 1e-6 * part.slope, 1e-12) << b << " at " << x;
    }
    EXPECT_NEAR(value, 1.0, 1e-15);
    EXPECT_NEAR(slope, 0.0, 1e-15);
  }
}

}  // namespace
}  // namespace slope::couple
