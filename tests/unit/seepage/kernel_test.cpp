#include "slope/seepage/kernel.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace slope::seepage {
namespace {

TEST(WendlandC2, IntegratesToOne) {
  for (const double h : {0.1, 1.2, 7.0}) {
    const WendlandC2 kernel(h);
    const int n = 2000;
    const double dr = kernel.support() / n;
    double integral = 0.0;
    for (int i = 0; i < n; ++i) {
      const double r = (i + 0.5) * dr;
      integral += kernel.value(r) * 2.0 * std::numbers::pi * r * dr;
    }
    EXPECT_NEAR(integral, 1.0, 1e-6) << "h = " << h;
  }
}

TEST(WendlandC2, RadialFactorIsMinusTheSlopeOverTheRadius) {
  const WendlandC2 kernel(1.2);
  const double dr = 1.0e-6;
  for (int i = 1; i < 240; ++i) {
    const double r = 0.01 * i;
    const double slope = (kernel.value(r + dr) - kernel.value(r - dr)) / (2.0 * dr);
    EXPECT_NEAR(kernel.radial_factor(r), -slope / r, 1e-8) << "r = " << r;
  }
}

TEST(WendlandC2, EndsAtItsSupport) {
  const WendlandC2 kernel(0.5);
  EXPECT_EQ(kernel.support(), 1.0);
  EXPECT_GT(kernel.radial_factor(0.999), 0.0);
  EXPECT_EQ(kernel.radial_factor(1.0), 0.0);
  EXPECT_EQ(kernel.radial_factor(2.0), 0.0);
  EXPECT_EQ(kernel.value(1.5), 0.0);
}

}  // namespace
}  // namespace slope::seepage
