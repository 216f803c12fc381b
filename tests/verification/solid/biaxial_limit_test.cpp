// Plane-strain compression at a constant lateral stress, driven by strain at one material point: in each of many small
// steps the lateral strain is the one that keeps the lateral stress.

#include <gtest/gtest.h>

#include <slope/testing/record.hpp>

#include "block.hpp"
#include "slope/solid/drucker_prager.hpp"

namespace slope::solid {
namespace {

using slope::testing::near;
using slope::testing::record;

double major_stress_at_the_limit(double dilatancy_angle) {
  DruckerPrager strength = testing::table_2_strength();
  strength.dilatancy_angle = dilatancy_angle;
  const YieldCone cone = SuctionDependentCone(strength).at(0.0);
  const Elastic elastic = testing::table_2_soil().elastic;
  const double shear = elastic.shear_modulus(), lame = elastic.bulk_modulus() - 2.0 / 3.0 * shear;
  const double lateral = -5.0e4, step = -2.0e-5;
  SymmetricTensor stress{lateral, lateral, lateral, 0.0};
  for (int k = 0; k < 5000; ++k) {
    const auto after = [&](double lateral_strain) {
      const double volumetric = lame * (step + lateral_strain);
      SymmetricTensor trial{stress.xx + volumetric + 2.0 * shear * lateral_strain,
                            stress.yy + volumetric + 2.0 * shear * step, stress.zz + volumetric, stress.xy};
      return_to_yield_surface(cone, elastic, trial);
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

TEST(BiaxialLimit, WithoutDilatancy) {
  EXPECT_TRUE(record("biaxial-limit", "Drucker-Prager biaxial limit, psi = 0, sigma_1", near(122.644, 0.122),
                     1e-3 * major_stress_at_the_limit(0.0), "kPa"));
}

TEST(BiaxialLimit, AssociatedIsMohrCoulomb) {
  EXPECT_TRUE(record("biaxial-limit-associated", "Drucker-Prager biaxial limit, associated, sigma_1",
                     near(126.335, 0.126), 1e-3 * major_stress_at_the_limit(25.0 * testing::degree), "kPa"));
}

}  // namespace
}  // namespace slope::solid
