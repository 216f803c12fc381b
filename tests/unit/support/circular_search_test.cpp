#include "slope/testing/circular_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slope::testing {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

SlopeSoil::Field constant(double value) {
  return [value](double, double) { return value; };
}

// The paper's slope: 7 m at 1:1.8 over 5 m, saturated weight, c' = 1 kPa, phi' = 25 deg.
const SlopeSection paper_slope{.toe = {10.0, 5.0}, .crest = {22.6, 12.0}, .base = 0.0};
constexpr double paper_weight = (0.65 * 2700.0 + 0.35 * 1000.0) * 9.81;

TEST(CircularSearch, AgreesWithAnotherSearchOnThePapersSlopeWithoutPorePressure) {
  const SlipCircle circle =
      critical_circle(paper_slope, {paper_weight, constant(25.0 * degree), constant(1.0e3), constant(0.0)});
  EXPECT_NEAR(circle.factor_of_safety, 1.011, 0.005);
}

// Case W2: water table at 3 m, suction above it as cohesion (Eq. 15) and as effective stress S_r s (van Genuchten,
// alpha = 0.05 1/m, n = 3).
TEST(CircularSearch, AgreesWithAnotherSearchOnThePapersSlopeBeforeTheRain) {
  const auto suction = [](double y) { return 9810.0 * (y - 3.0); };
  const SlipCircle circle = critical_circle(
      paper_slope,
      {paper_weight, constant(25.0 * degree),
       [&](double, double y) { return 1.0e3 - 1.0e5 * std::expm1(-0.07 * std::max(suction(y), 0.0) / 101325.0); },
       [&](double, double y) {
         const double head = std::max(y - 3.0, 0.0);
         return -std::pow(1.0 + std::pow(0.05 * head, 3.0), -2.0 / 3.0) * suction(y);
       }});
  EXPECT_NEAR(circle.factor_of_safety, 2.00, 0.02);
}

// Taylor (1937): without friction a slope of 60 deg stands up to gamma H = c / 0.191, one of 75 deg to c / 0.219.
TEST(CircularSearch, FindsTaylorsStabilityNumbers) {
  const double height = 10.0, unit_weight = 20.0e3;
  for (const auto& [angle, number] : {std::pair(60.0, 0.191), std::pair(75.0, 0.219)}) {
    const SlopeSection section{{0.0, 0.0}, {height / std::tan(angle * degree), height}, -20.0};
    const SlipCircle circle =
        critical_circle(section, {unit_weight, constant(0.0), constant(number * unit_weight * height), constant(0.0)});
    EXPECT_NEAR(circle.factor_of_safety, 1.0, 0.01) << angle;
  }
}

TEST(CircularSearch, OfSoilWithoutCohesionEndsAtTheInfiniteSlope) {
  const SlopeSection section{{0.0, 0.0}, {10.0, 5.0}, -5.0};
  const double dry = std::tan(32.0 * degree) / 0.5;
  const SlipCircle circle = critical_circle(section, {20.0e3, constant(32.0 * degree), constant(0.0), constant(0.0)});
  EXPECT_GE(circle.factor_of_safety, dry - 1e-6);
  EXPECT_LT(circle.factor_of_safety, 1.03 * dry);
}

// Water over the crest leaves a slope of soil that weighs less by it, and pulls a dry one down no further.
TEST(CircularSearch, BuoysUpWhatLiesInWater) {
  const SlopeSection section{{0.0, 0.0}, {20.0, 10.0}, 0.0};
  SlopeSoil soil{20.0e3, constant(20.0 * degree), constant(10.0e3), constant(0.0)};
  const double dry = critical_circle(section, soil).factor_of_safety;
  EXPECT_NEAR(dry, 1.380, 0.01);  // Bishop and Morgenstern (1960)
  soil.water_level = 0.0;
  EXPECT_EQ(critical_circle(section, soil).factor_of_safety, dry);
  soil.water_level = 12.0;
  const SlopeSoil light{20.0e3 - 9810.0, constant(20.0 * degree), constant(10.0e3), constant(0.0)};
  EXPECT_NEAR(critical_circle(section, soil).factor_of_safety, critical_circle(section, light).factor_of_safety, 1e-9);
}

TEST(CircularSearch, SeesTheStrengthOfEachPlace) {
  const SlopeSection section{{0.0, 0.0}, {20.0, 10.0}, -10.0};
  const auto clay = [](double below) {
    return SlopeSoil{20.0e3, constant(0.0), [below](double, double y) { return y < 0.0 ? below : 50.0e3; },
                     constant(0.0)};
  };
  EXPECT_NEAR(critical_circle(section, clay(50.0e3)).factor_of_safety, 1.47, 0.015);  // Taylor (1937)
  SlopeSection on_rock = section;
  on_rock.base = 0.0;
  const double over_rock = critical_circle(on_rock, clay(50.0e3)).factor_of_safety;
  EXPECT_NEAR(critical_circle(section, clay(500.0e3)).factor_of_safety, over_rock, 0.005);
}

TEST(CircularSearch, LeavesTheFirmGroundWhole) {
  SlopeSection section{{0.0, 0.0}, {15.0, 5.0}, -10.0};  // without friction circles go deep
  const SlopeSoil clay{20.0e3, constant(0.0), constant(20.0e3), constant(0.0)};
  const double deep = critical_circle(section, clay).factor_of_safety;
  section.base = -1.0;
  const SlipCircle circle = critical_circle(section, clay);
  EXPECT_GE(circle.centre[1] - circle.radius, -1.0);
  EXPECT_GT(circle.factor_of_safety, 1.05 * deep);
}

}  // namespace
}  // namespace slope::testing
