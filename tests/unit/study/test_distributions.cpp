// Distributions against closed forms of their moments and quantiles.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "distributions.hpp"

namespace slope::tools::test {
namespace {

constexpr double z95 = 1.6448536269514722;  // of which 95 % of a standard normal distribution lies below

template <class Law>
Law located(double mean, double standard_deviation) {
  Law law;
  law.mean = mean, law.standard_deviation = standard_deviation;
  return law;
}

template <class Law>
Law between_quantiles(double low, double high) {
  Law law;
  law.quantiles = {{0.05, low}, {0.95, high}};
  return law;
}

void expect_moments(const Distribution& distribution, double expected_mean, double expected_deviation) {
  EXPECT_NEAR(mean(distribution), expected_mean, 1.0e-6 * std::abs(expected_mean));
  EXPECT_NEAR(standard_deviation(distribution), expected_deviation, 1.0e-6 * expected_deviation);
}

TEST(Distributions, NormalHasItsMomentsAndQuantiles) {
  const Normal law = located<Normal>(25.0, 2.0);
  expect_moments(law, 25.0, 2.0);
  EXPECT_NEAR(quantile(law, 0.95), 25.0 + 2.0 * z95, 1.0e-9);
  EXPECT_NEAR(quantile(law, 0.5), 25.0, 1.0e-9);
}

TEST(Distributions, LognormalHasItsMomentsAndQuantiles) {
  Lognormal law;
  law.mean = 5.0e3, law.coefficient_of_variation = 0.3;
  expect_moments(law, 5.0e3, 1.5e3);
  const double variance = std::log(1.0 + 0.3 * 0.3), place = std::log(5.0e3) - 0.5 * variance;
  EXPECT_NEAR(quantile(law, 0.05), std::exp(place - z95 * std::sqrt(variance)), 1.0e-6);
}

TEST(Distributions, UniformHasItsMomentsAndQuantiles) {
  Uniform ends;
  ends.minimum = 2.0, ends.maximum = 8.0;
  expect_moments(ends, 5.0, 6.0 / std::sqrt(12.0));
  EXPECT_NEAR(quantile(ends, 0.25), 3.5, 1.0e-9);
  EXPECT_NEAR(quantile(located<Uniform>(5.0, 6.0 / std::sqrt(12.0)), 0.25), 3.5, 1.0e-9);
  EXPECT_NEAR(quantile(between_quantiles<Uniform>(2.3, 7.7), 0.25), 3.5, 1.0e-9);
}

TEST(Distributions, TriangularHasItsMomentsAndQuantiles) {
  const Triangular law{1.0, 2.0, 6.0};
  expect_moments(law, 3.0, std::sqrt((1.0 + 4.0 + 36.0 - 2.0 - 6.0 - 12.0) / 18.0));
  EXPECT_NEAR(quantile(law, 0.2), 2.0, 1.0e-9);  // (mode - minimum) / (maximum - minimum)
}

TEST(Distributions, BetaHasItsMomentsAndIsUniformWhereItMustBe) {
  Beta law = located<Beta>(0.4, 0.05);
  law.minimum = 0.3, law.maximum = 0.6;
  expect_moments(law, 0.4, 0.05);
  Beta flat = located<Beta>(5.0, 6.0 / std::sqrt(12.0));
  flat.minimum = 2.0, flat.maximum = 8.0;
  EXPECT_NEAR(quantile(flat, 0.1), 2.6, 1.0e-6);
}

TEST(Distributions, TwoQuantilesAreMetAgain) {
  for (const Distribution& law :
       {Distribution{between_quantiles<Normal>(20.0, 30.0)}, Distribution{between_quantiles<Lognormal>(20.0, 30.0)}}) {
    EXPECT_NEAR(quantile(law, 0.05), 20.0, 1.0e-8);
    EXPECT_NEAR(quantile(law, 0.95), 30.0, 1.0e-8);
  }
  EXPECT_NEAR(mean(between_quantiles<Normal>(20.0, 30.0)), 25.0, 1.0e-8);
  EXPECT_NEAR(quantile(between_quantiles<Lognormal>(20.0, 30.0), 0.5), std::sqrt(600.0), 1.0e-8);
}

// What is left of a normal distribution above its mean is the half-normal distribution.
TEST(Distributions, AreCutOffAtTheirLimits) {
  Normal half = located<Normal>(3.0, 2.0);
  half.minimum = 3.0;
  expect_moments(half, 3.0 + 2.0 * std::sqrt(2.0 / std::numbers::pi), 2.0 * std::sqrt(1.0 - 2.0 / std::numbers::pi));
  EXPECT_GE(quantile(half, 1.0e-9), 3.0);
  Lognormal below = located<Lognormal>(5.0, 1.5);
  below.maximum = 6.0;
  EXPECT_LE(quantile(below, 1.0 - 1.0e-9), 6.0);
  EXPECT_LT(mean(below), 5.0);
}

TEST(Distributions, SayWhatMakesThemImpossible) {
  const auto has = [](const Distribution& law, const std::string& part) {
    EXPECT_NE(fault_of(law).find(part), std::string::npos) << fault_of(law);
  };
  EXPECT_EQ(fault_of(located<Normal>(5.0, 1.0)), "");
  has(located<Lognormal>(-5.0, 1.0), "lies above 0");
  has(between_quantiles<Normal>(3.0, 2.0), "larger probability and the larger value");
  Normal ratio;
  ratio.mean = 0.0, ratio.coefficient_of_variation = 0.3;
  has(ratio, "says nothing of a mean of 0");
  Normal far = located<Normal>(5.0, 1.0);
  far.minimum = 10.0;
  has(far, "of the distribution lies between its limits");
  far.maximum = 9.0;
  has(far, "minimum must be below the maximum");
  has(Triangular{1.0, 7.0, 6.0}, "mode must lie between");
  Beta wide = located<Beta>(0.4, 0.2);
  wide.minimum = 0.3, wide.maximum = 0.6;
  has(wide, "it must be below 1");
  wide.mean = 0.7;
  has(wide, "mean must lie between");
}

}  // namespace
}  // namespace slope::tools::test
