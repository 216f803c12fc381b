// Plane-strain compression at a constant lateral stress, driven by strain at one material point: in each of many small
// steps the lateral strain is the one that keeps the lateral stress.

#include <gtest/gtest.h>

#include <cmath>
#include <slope/testing/record.hpp>

#include "block.hpp"
#include "slope/solid/strength_law.hpp"

namespace slope::solid {
namespace {

using slope::testing::near;
using slope::testing::record;

// The major stress (Pa) that the soil comes to bear at a lateral one of 50 kPa.
template <class YieldSurface>
double major_stress_at_the_limit(const YieldSurface& surface) {
  const Elastic elastic = testing::table_2_soil().elastic;
  const double shear = elastic.shear_modulus(), lame = elastic.bulk_modulus() - 2.0 / 3.0 * shear;
  const double lateral = -5.0e4, step = -2.0e-5;
  SymmetricTensor stress{lateral, lateral, lateral, 0.0};
  for (int k = 0; k < 5000; ++k) {
    const auto after = [&](double lateral_strain) {
      const double volumetric = lame * (step + lateral_strain);
      SymmetricTensor trial{stress.xx + volumetric + 2.0 * shear * lateral_strain,
                            stress.yy + volumetric + 2.0 * shear * step, stress.zz + volumetric, stress.xy};
      return_to_yield_surface(surface, elastic, trial);
      return trial;
    };
    double low = 0.0, high = -10.0 * step;
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = 0.5 * (low + high);
      (after(middle).xx < lateral ? low : high) = middle;
    }
    stress = after(low);
    EXPECT_NEAR(stress.xx, lateral, 1.0);
  }
  return -stress.yy;
}

double drucker_prager_limit(double dilatancy_angle) {
  DruckerPrager strength = testing::table_2_strength();
  strength.dilatancy_angle = dilatancy_angle;
  return major_stress_at_the_limit(SuctionDependentCone(strength).at(0.0));
}

TEST(BiaxialLimit, WithoutDilatancy) {
  EXPECT_TRUE(record("biaxial-limit", "Drucker-Prager biaxial limit, psi = 0, sigma_1", near(122.644, 0.122),
                     1e-3 * drucker_prager_limit(0.0), "kPa"));
}

TEST(BiaxialLimit, AssociatedIsMohrCoulomb) {
  EXPECT_TRUE(record("biaxial-limit-associated", "Drucker-Prager biaxial limit, associated, sigma_1",
                     near(126.335, 0.126), 1e-3 * drucker_prager_limit(25.0 * testing::degree), "kPa"));
}

// sigma_1 = sigma_3 K_p + 2 c sqrt(K_p), whatever the dilatancy.
TEST(BiaxialLimit, OfMohrCoulombIsExact) {
  const double kp = std::pow(std::tan(57.5 * testing::degree), 2);
  const double expected = 5.0e4 * kp + 2.0e3 * std::sqrt(kp);
  for (const double dilatancy : {0.0, 10.0, 25.0}) {
    const MohrCoulomb strength{
        .cohesion = 1.0e3, .friction_angle = 25.0 * testing::degree, .dilatancy_angle = dilatancy * testing::degree};
    const double reached = major_stress_at_the_limit(SuctionDependentPyramid(strength).at(0.0));
    EXPECT_NEAR(reached, expected, 1.0);
    if (dilatancy > 0.0) continue;
    EXPECT_TRUE(record("biaxial-limit-mohr-coulomb", "Mohr-Coulomb biaxial limit, psi = 0, sigma_1",
                       near(1e-3 * expected, 1e-6 * expected), 1e-3 * reached, "kPa"));
  }
}

TEST(BiaxialLimit, OfVonMisesIsTwiceTheUndrainedStrength) {
  EXPECT_NEAR(major_stress_at_the_limit(YieldCylinder{2.0e4}), 5.0e4 + 4.0e4, 1.0);
}

}  // namespace
}  // namespace slope::solid
