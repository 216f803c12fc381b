#include "slope/solid/von_mises.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace slope::solid {
namespace {

constexpr Elastic elastic{.youngs_modulus = 1.0e7, .poissons_ratio = 0.45};

TEST(VonMisesReturn, EndsOnTheSurfaceAndKeepsMeanAndDirection) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> part(-1.0e5, 1.0e5);
  int outside = 0;
  for (int k = 0; k < 10000; ++k) {
    const YieldCylinder cylinder{1.0e4 * (1 + k % 9)};
    const SymmetricTensor trial{part(random), part(random), part(random), part(random)};
    SymmetricTensor stress = trial;
    if (return_to_yield_surface(cylinder, elastic, stress) == Return::elastic) {
      EXPECT_LE(cylinder.value(trial), 0.0);
      EXPECT_EQ(stress.xx, trial.xx);
      continue;
    }
    ++outside;
    EXPECT_GT(cylinder.value(trial), 0.0);
    EXPECT_NEAR(cylinder.value(stress), 0.0, 1e-8);
    EXPECT_NEAR(trace(stress), trace(trial), 1e-8);
    const SymmetricTensor s = deviator(trial), t = deviator(stress);
    EXPECT_NEAR(t.xx * s.xy, t.xy * s.xx, 1e-2);
    EXPECT_NEAR(t.zz * s.xy, t.xy * s.zz, 1e-2);
  }
  EXPECT_GT(outside, 5000);
}

TEST(VonMisesReturn, BearsAnyPressureAndAnyTension) {
  for (const double mean : {-1.0e9, 1.0e9}) {
    SymmetricTensor stress{mean, mean, mean, 0.0};
    EXPECT_EQ(return_to_yield_surface(YieldCylinder{1.0}, elastic, stress), Return::elastic);
  }
}

// Sheared in plane strain far beyond the limit, sigma_zz comes to lie midway and half of the stress difference is s_u.
TEST(VonMisesLimit, IsTheShearStrengthInPlaneStrain) {
  const double strength = 2.0e4, shear = elastic.shear_modulus(), step = 1.0e-4;
  for (const double start_zz : {0.0, -1.5e4}) {
    SymmetricTensor stress{0.0, 0.0, start_zz, 0.0};
    for (int k = 0; k < 3000; ++k) {
      stress.xx += 2.0 * shear * step;
      stress.yy -= 2.0 * shear * step;
      return_to_yield_surface(YieldCylinder{strength}, elastic, stress);
    }
    EXPECT_NEAR(0.5 * (stress.xx - stress.yy), strength, 1e-6 * strength);
    EXPECT_NEAR(stress.zz, 0.5 * (stress.xx + stress.yy), 1e-3 * strength);
  }
}

}  // namespace
}  // namespace slope::solid
