#include "slope/seepage/mean_conductivity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "slope/seepage/conductivity_curve.hpp"

namespace slope::seepage {
namespace {

constexpr double saturated = 1.0e-5;

PotentialAt gardner(double alpha, double pressure_head) {
  const double conductivity = saturated * std::exp(alpha * std::min(pressure_head, 0.0));
  return {conductivity, pressure_head, conductivity / alpha + saturated * std::max(pressure_head, 0.0)};
}

// The exact steady downward flux q through exponential soil: between heads psi at the top and the bottom of a length l,
// q = (K_top e^(alpha l) - K_bottom) / (e^(alpha l) - 1).
TEST(MeanConductivity, GivesTheExactFlowThroughExponentialSoil) {
  for (const double alpha : {0.5, 5.0, 50.0}) {
    for (const double length : {0.02, 0.25}) {
      for (const double top : {-0.01, -0.1, -0.3}) {
        for (const double bottom : {-0.02, -0.15, -0.6}) {
          const PotentialAt a = gardner(alpha, top), b = gardner(alpha, bottom);
          const double growth = std::expm1(alpha * length);
          const double exact = (a.conductivity * (growth + 1.0) - b.conductivity) / growth;
          const double flow = kirchhoff_mean(a, b, length) * (top - bottom + length) / length;
          EXPECT_NEAR(flow, exact, 1e-9 * (std::abs(exact) + a.conductivity)) << alpha << " " << top << " " << bottom;
        }
      }
    }
  }
}

TEST(MeanConductivity, IsTheSameInBothDirections) {
  for (const double drop : {-0.3, 0.0, 0.2}) {
    for (const double dry : {-0.05, -1.0, -30.0}) {
      const PotentialAt a = gardner(4.0, -0.02), b = gardner(4.0, dry);
      const double mean = kirchhoff_mean(a, b, drop);
      EXPECT_NEAR(mean, kirchhoff_mean(b, a, -drop), 1e-12 * mean);
      EXPECT_GE(mean, b.conductivity);
      EXPECT_LE(mean, a.conductivity);
    }
  }
}

TEST(MeanConductivity, IsThatOfTheWetEndOnALongWayDownIntoDrySoil) {
  const PotentialAt wet = gardner(40.0, 0.0), dry = gardner(40.0, -0.4);
  EXPECT_NEAR(kirchhoff_mean(wet, dry, 1.0) * (0.4 + 1.0), wet.conductivity, 1e-6 * wet.conductivity)
      << "gravity alone takes what the wet end conducts";
  EXPECT_NEAR(kirchhoff_mean(wet, dry, 0.0), (wet.conductivity - dry.conductivity) / 16.0, 1e-3 * wet.conductivity);
  EXPECT_NEAR(kirchhoff_mean(wet, dry, -2.0), dry.conductivity, 1e-6 * wet.conductivity) << "the other way up";
}

TEST(MeanConductivity, OfLikeOrEqualEndsIsTheirs) {
  EXPECT_DOUBLE_EQ(kirchhoff_mean({2.0, -1.0, 3.0}, {2.0, -1.0, 3.0}, 0.3), 2.0);
  EXPECT_DOUBLE_EQ(kirchhoff_mean({2.0, 5.0, 10.0}, {2.0, 0.1, 0.2}, -0.3), 2.0);
  for (const double drop : {-0.3, 0.0, 0.3})  // one from the law, the other from its table
    EXPECT_DOUBLE_EQ(kirchhoff_mean({2.0, -3.0, 10.0}, {2.0002, -3.0, 10.0}, drop), 2.0001);
  EXPECT_NEAR(logarithmic_mean(8.0, 1.0), 7.0 / std::log(8.0), 1e-15);
  EXPECT_NEAR(logarithmic_mean(1.001, 1.0), 0.001 / std::log1p(0.001), 1e-12);
  EXPECT_DOUBLE_EQ(logarithmic_mean(3.0, 3.0), 3.0);
}

// From a ponded face into loam at 15 m of suction the exponential between the ends is 26 times the soil's own integral.
TEST(MeanConductivity, FollowsTheCurveOfTheSoilFromWetToDry) {
  Soil loam;
  const SaturationRange range{0.1814, 1.0};
  loam.retention = VanGenuchten{.alpha = 3.6, .n = 1.56, .range = range};
  loam.relative_permeability.law = VanGenuchtenMualem{.n = 1.56, .range = range};
  loam.hydraulic_conductivity = saturated;
  const ConductivityCurve curve(loam);
  const auto at = [&](double pressure_head) {
    const ConductivityCurve::Value value = curve.at(pressure_head);
    return PotentialAt{value.conductivity, pressure_head, value.potential};
  };
  for (const double dry : {-0.2, -1.0, -15.0}) {
    // the integral from the laws themselves, by the trapezium rule in the logarithm of the suction
    double integral = 0.0, before = 0.0;
    constexpr int steps = 40000;
    for (int i = 0; i <= steps; ++i) {
      const double h = 1.0e-9 * std::pow(-dry / 1.0e-9, static_cast<double>(i) / steps);
      const double now = h * saturated * loam.relative_permeability.evaluate(h, evaluate(loam.retention, h).saturation);
      if (i > 0) integral += 0.5 * (now + before) * std::log(-dry / 1.0e-9) / steps;
      before = now;
    }
    EXPECT_NEAR(kirchhoff_mean(at(0.0), at(dry), 0.0) * -dry / integral, 1.0, 1e-4) << dry;
  }
  const PotentialAt wet = at(0.0), dry = at(-15.0);
  EXPECT_GT(logarithmic_mean(wet.conductivity, dry.conductivity) / kirchhoff_mean(wet, dry, 0.0), 10.0);
}

// Liakopoulos' law passes zero at a suction head of 1.03 m here, and falls within a part of a millimetre to its floor.
TEST(MeanConductivity, IsPositiveWhereTheLawComesToItsFloor) {
  Soil soil;
  soil.retention = ExponentialRetention{.alpha = 1.443385, .range = {0.1769641, 1.0}};
  soil.relative_permeability.law = LiakopoulosPermeability{.coefficient = 1.801, .exponent = 1.344};
  soil.hydraulic_conductivity = saturated;
  const ConductivityCurve curve(soil);
  const auto at = [&](double suction_head) {
    const ConductivityCurve::Value value = curve.at(-suction_head);
    return PotentialAt{value.conductivity, -suction_head, value.potential};
  };
  for (double h = 0.9; h < 1.3; h += 0.001) {
    const PotentialAt wet = at(h), drier = at(h + 0.0005), dry = at(200.0);
    EXPECT_GE(wet.conductivity, drier.conductivity) << h;
    EXPECT_GT(wet.potential, drier.potential) << h;
    for (const double drop : {-0.3, 0.0, 0.3}) {
      EXPECT_GT(kirchhoff_mean(wet, drier, drop), 0.0) << h << " " << drop;
      EXPECT_GT(kirchhoff_mean(wet, dry, drop), 0.0) << h << " " << drop;
    }
  }
}

TEST(MeanConductivity, HasItsSlope) {
  for (const double alpha : {0.5, 8.0}) {
    for (const double drop : {-0.3, -0.01, 0.0, 0.02, 0.5}) {
      for (const double other : {-0.03, -0.4, -1.5}) {
        for (double here = -1.2; here < -0.05; here += 0.0917) {
          const PotentialAt b = gardner(alpha, other), a = gardner(alpha, here);
          const double step = 1e-6;
          const auto mean = [&](double psi) { return kirchhoff_mean(gardner(alpha, psi), b, drop); };
          const double difference = (mean(here + step) - mean(here - step)) / (2.0 * step);
          EXPECT_NEAR(kirchhoff_mean_slope(a, b, drop, alpha * a.conductivity), difference,
                      2e-4 * std::abs(difference) + 1e-6 * a.conductivity)
              << alpha << " " << drop << " " << other << " " << here;
        }
      }
    }
  }
}

}  // namespace
}  // namespace slope::seepage
