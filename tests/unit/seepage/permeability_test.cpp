#include "slope/seepage/permeability.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "slope/seepage/retention.hpp"

namespace slope::seepage {
namespace {

TEST(HillelPermeability, IsAPowerOfTheSaturation) {
  for (double s = 0.0; s <= 1.0; s += 0.001) {
    EXPECT_DOUBLE_EQ(HillelPower{.exponent = 2.0}.evaluate(0.0, s), s * s);
    EXPECT_DOUBLE_EQ(HillelPower{.exponent = 3.5}.evaluate(0.0, s), std::pow(s, 3.5));
  }
}

TEST(LiakopoulosRelativePermeability, IsThePapersFormula) {
  EXPECT_DOUBLE_EQ(LiakopoulosPermeability{}.evaluate(0.0, 1.0), 1.0);
  for (double s = 0.0; s <= 1.0; s += 0.001) {
    EXPECT_NEAR(LiakopoulosPermeability{}.evaluate(0.0, s), 1.0 - 2.207 * (1.0 - s), 1e-15);
    EXPECT_NEAR((LiakopoulosPermeability{.coefficient = 2.207, .exponent = 1.0121}.evaluate(0.0, s)),
                1.0 - 2.207 * std::pow(1.0 - s, 1.0121), 1e-15);
  }
}

TEST(ExponentialRelativePermeability, FallsByAFactorOfEPerInverseAlpha) {
  const ExponentialPermeability law{.alpha = 0.5};
  EXPECT_EQ(law.evaluate(-1.0, 1.0), 1.0);
  EXPECT_EQ(law.evaluate(0.0, 1.0), 1.0);
  for (double h = 0.01; h < 50.0; h += 0.01) {
    EXPECT_NEAR(law.evaluate(h + 2.0, 1.0) / law.evaluate(h, 1.0), std::exp(-1.0), 1e-12);
  }
}

TEST(VanGenuchtenMualemPermeability, RisesFromZeroToOneOverItsRange) {
  const VanGenuchtenMualem law{.n = 2.0, .range = {0.1, 0.9}};
  EXPECT_EQ(law.evaluate(0.0, 0.1), 0.0);
  EXPECT_EQ(law.evaluate(0.0, 0.05), 0.0);
  EXPECT_EQ(law.evaluate(0.0, 0.9), 1.0);
  double before = 0.0;
  for (double s = 0.1; s < 0.9; s += 0.0005) {
    const double k = law.evaluate(0.0, s);
    EXPECT_GE(k, before);
    before = k;
  }
  // n = 2: k = sqrt(S_e) (1 - sqrt(1 - S_e^2))^2
  EXPECT_NEAR(law.evaluate(0.0, 0.5), std::sqrt(0.5) * std::pow(1.0 - std::sqrt(0.75), 2), 1e-14);
}

TEST(RelativePermeabilities, HoldTheirFloorAndAreOneWhenSaturated) {
  for (const RelativePermeability& law :
       {RelativePermeability{HillelPower{}, 1.0e-4}, RelativePermeability{LiakopoulosPermeability{}, 1.0e-4},
        RelativePermeability{ExponentialPermeability{.alpha = 3.0}, 1.0e-4},
        RelativePermeability{VanGenuchtenMualem{.n = 1.5, .range = {}}, 1.0e-4}}) {
    EXPECT_EQ(law.evaluate(0.0, 1.0), 1.0);
    EXPECT_EQ(law.evaluate(100.0, 0.0), 1.0e-4);
    for (double h = 0.0; h < 5.0; h += 0.01) {
      const double k = law.evaluate(h, std::exp(-h));
      EXPECT_GE(k, 1.0e-4);
      EXPECT_LE(k, 1.0);
    }
  }
}

}  // namespace
}  // namespace slope::seepage
