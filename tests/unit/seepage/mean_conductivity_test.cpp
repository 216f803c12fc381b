#include "slope/seepage/mean_conductivity.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace slope::seepage {
namespace {

constexpr double saturated = 1.0e-5;

ConductivityAt gardner(double alpha, double pressure_head) {
  return {saturated * std::exp(alpha * std::min(pressure_head, 0.0)), pressure_head};
}

// The exact steady downward flux q through exponential soil: between heads psi at the top and the bottom of a length l,
// q = (K_top e^(alpha l) - K_bottom) / (e^(alpha l) - 1).
TEST(MeanConductivity, GivesTheExactFlowThroughExponentialSoil) {
  for (const double alpha : {0.5, 5.0, 50.0}) {
    for (const double length : {0.02, 0.25}) {
      for (const double top : {-0.01, -0.1, -0.3}) {
        for (const double bottom : {-0.02, -0.15, -0.6}) {
          const ConductivityAt a = gardner(alpha, top), b = gardner(alpha, bottom);
          const bool alike = std::abs(std::log(a.conductivity / b.conductivity)) < 0.11;
          const double growth = std::expm1(alpha * length);
          const double exact = (a.conductivity * (growth + 1.0) - b.conductivity) / growth;
          const double flow = mean_conductivity(a, b, length) * (top - bottom + length) / length;
          EXPECT_NEAR(flow, exact, (alike ? 5e-3 : 1e-9) * (std::abs(exact) + a.conductivity))
              << alpha << " " << top << " " << bottom;
        }
      }
    }
  }
}

TEST(MeanConductivity, IsTheSameInBothDirections) {
  for (const double drop : {-0.3, 0.0, 0.2}) {
    for (const double dry : {-0.05, -1.0, -30.0}) {
      const ConductivityAt a = gardner(4.0, -0.02), b = gardner(4.0, dry);
      const double mean = mean_conductivity(a, b, drop);
      EXPECT_NEAR(mean, mean_conductivity(b, a, -drop), 1e-12 * mean);
      EXPECT_GE(mean, b.conductivity);
      EXPECT_LE(mean, a.conductivity);
    }
  }
}

TEST(MeanConductivity, IsThatOfTheWetEndOnALongWayDownIntoDrySoil) {
  const ConductivityAt wet = gardner(40.0, 0.0), dry = gardner(40.0, -0.4);
  EXPECT_NEAR(mean_conductivity(wet, dry, 1.0) * (0.4 + 1.0), wet.conductivity, 1e-6 * wet.conductivity)
      << "gravity alone takes what the wet end conducts";
  EXPECT_NEAR(mean_conductivity(wet, dry, 0.0), (wet.conductivity - dry.conductivity) / 16.0, 1e-3 * wet.conductivity);
}

TEST(MeanConductivity, OfLikeOrEqualEndsIsTheirs) {
  EXPECT_DOUBLE_EQ(mean_conductivity({2.0, -1.0}, {2.0, -1.0}, 0.3), 2.0);
  EXPECT_DOUBLE_EQ(mean_conductivity({2.0, 5.0}, {2.0, 0.1}, -0.3), 2.0);
  // two soils, of which the one with the lower pressure conducts better: the logarithmic mean
  EXPECT_NEAR(mean_conductivity({8.0, -1.0}, {1.0, -0.5}, 0.4), 7.0 / std::log(8.0), 1e-12);
  EXPECT_TRUE(std::isfinite(mean_conductivity({1.0, -1e-12}, {1e-6, -2e-12}, 1.0))) << "bounded";
}

TEST(MeanConductivity, GoesOverToTheShortFormulaWithoutAJump) {
  for (const double drop : {-0.4, -0.02, 0.0, 0.05, 2.0}) {
    const ConductivityAt b = gardner(6.0, -0.3);
    double before = mean_conductivity(gardner(6.0, -0.26), b, drop);
    for (double psi = -0.26; psi > -0.34; psi -= 1.0e-5) {
      const double now = mean_conductivity(gardner(6.0, psi), b, drop);
      EXPECT_NEAR(now / before, 1.0, 3e-4) << psi << " " << drop;
      before = now;
    }
    // and within a quarter of a percent of the exact one
    const double exact = b.conductivity * std::exp(0.09) * 1.0;
    EXPECT_LT(mean_conductivity(gardner(6.0, -0.285), b, drop), exact * 1.003);
  }
}

TEST(MeanConductivity, HasItsSlope) {
  for (const double alpha : {0.5, 8.0}) {
    for (const double drop : {-0.3, -0.01, 0.0, 0.02, 0.5}) {
      for (const double other : {-0.03, -0.4, -1.5}) {
        for (double here = -1.2; here < -0.05; here += 0.0917) {
          const ConductivityAt b = gardner(0.7 * alpha, other);
          const double step = 1e-6;
          const auto mean = [&](double psi) { return mean_conductivity(gardner(alpha, psi), b, drop); };
          const double ratio = gardner(alpha, here).conductivity / b.conductivity;
          if (std::abs(std::log(ratio)) < 0.11) continue;  // there the slope is that of the exact formula
          const double difference = (mean(here + step) - mean(here - step)) / (2.0 * step);
          const ConductivityAt a = gardner(alpha, here);
          EXPECT_NEAR(mean_conductivity_slope(a, b, drop, alpha * a.conductivity), difference,
                      2e-4 * std::abs(difference) + 1e-6 * a.conductivity)
              << alpha << " " << drop << " " << other << " " << here;
        }
      }
    }
  }
}

}  // namespace
}  // namespace slope::seepage
