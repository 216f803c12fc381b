#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "block.hpp"
#include "slope/solid/shear_strength.hpp"
#include "slope/solid/strength_law.hpp"

namespace slope::solid {
namespace {

using testing::Block;
using testing::degree;

constexpr SofteningRange range{.from = 0.01, .to = 0.05, .characteristic_length = 0.0};

template <class Law>
Law brittle() {
  return {.cohesion = 1.0e4,
          .friction_angle = 30.0 * degree,
          .dilatancy_angle = 6.0 * degree,
          .maximum_cohesion_increase = 1.0e5,
          .cohesion_suction_rate = 0.07,
          .softening = FrictionalSoftening{
              .residual_cohesion = 2.0e3, .residual_friction_angle = 20.0 * degree, .range = range}};
}

TEST(SofteningRange, FallsLinearlyBetweenTwoPlasticStrains) {
  EXPECT_EQ(range.share(0.0), 0.0);
  EXPECT_EQ(range.share(0.01), 0.0);
  EXPECT_NEAR(range.share(0.02), 0.25, 1e-15);
  EXPECT_EQ(range.share(0.05), 1.0);
  EXPECT_EQ(range.share(7.0), 1.0);
}

TEST(SofteningRange, CanKeepTheDisplacementOfABandWhateverTheCellSize) {
  EXPECT_EQ(range.in_cells_of(0.1).to, range.to) << "without a characteristic length nothing changes";
  const SofteningRange sized{.from = 0.01, .to = 0.05, .characteristic_length = 0.5};
  for (const double cell_size : {0.25, 0.5, 1.0}) {
    const SofteningRange fitted = sized.in_cells_of(cell_size);
    EXPECT_EQ(fitted.from, sized.from);
    EXPECT_NEAR((fitted.to - fitted.from) * cell_size, 0.04 * 0.5, 1e-15);
  }
  VonMises strength{.undrained_strength = 1.0e4, .softening = UndrainedSoftening{2.0e3, sized}};
  const auto law = std::get<SofteningCylinder>(make_strength_law({{}, strength, 0.0}, 0.25));
  EXPECT_NEAR(law.at(0.0, 0.01 + 0.04).undrained_strength, 6.0e3, 1e-9);
}

TEST(Softening, LowersCohesionFrictionAndDilatancyButNotWhatSuctionAdds) {
  const auto strength = brittle<MohrCoulomb>();
  const double suction = 9.0e4, gain = 1.0e5 * (1.0 - std::exp(-0.07 * suction / atmospheric_pressure));
  const ShearStrength peak = shear_strength(strength, suction, 0.005);
  EXPECT_NEAR(peak.cohesion, 1.0e4 + gain, 1e-9);
  EXPECT_NEAR(peak.friction_angle, 30.0 * degree, 1e-15);
  EXPECT_NEAR(peak.dilatancy_angle, 6.0 * degree, 1e-15);
  const ShearStrength half = shear_strength(strength, suction, 0.03);
  EXPECT_NEAR(half.cohesion, 6.0e3 + gain, 1e-9);
  EXPECT_NEAR(half.friction_angle, 25.0 * degree, 1e-15);
  EXPECT_NEAR(half.dilatancy_angle, 3.0 * degree, 1e-15);
  const ShearStrength residual = shear_strength(strength, 0.0, 0.06);
  EXPECT_NEAR(residual.cohesion, 2.0e3, 1e-9);
  EXPECT_NEAR(residual.friction_angle, 20.0 * degree, 1e-15);
  EXPECT_NEAR(residual.dilatancy_angle, 0.0, 1e-15);
}

// The surface of a soil that has softened is that of a soil which never had more.
TEST(Softening, GivesTheSurfaceOfTheWeakerSoil) {
  for (const double plastic_strain : {0.0, 0.02, 0.03, 0.2}) {
    for (const double suction : {-1.0e4, 3.0e4}) {
      const ShearStrength now = shear_strength(brittle<DruckerPrager>(), 0.0, plastic_strain);
      DruckerPrager cone{now.cohesion, now.friction_angle, now.dilatancy_angle, 1.0e5, 0.07, 0.0, {}};
      const YieldCone expected = SuctionDependentCone(cone).at(suction);
      const YieldCone softened = SuctionDependentCone(brittle<DruckerPrager>()).at(suction, plastic_strain);
      EXPECT_NEAR(softened.eta, expected.eta, 1e-14);
      EXPECT_NEAR(softened.eta_potential, expected.eta_potential, 1e-14);
      EXPECT_NEAR(softened.xi_c, expected.xi_c, 1e-9);
      MohrCoulomb pyramid{now.cohesion, now.friction_angle, now.dilatancy_angle, 1.0e5, 0.07, 0.0, {}};
      const YieldPyramid weaker = SuctionDependentPyramid(pyramid).at(suction);
      const YieldPyramid lower = SuctionDependentPyramid(brittle<MohrCoulomb>()).at(suction, plastic_strain);
      EXPECT_NEAR(lower.sin_friction, weaker.sin_friction, 1e-14);
      EXPECT_NEAR(lower.sin_dilatancy, weaker.sin_dilatancy, 1e-14);
      EXPECT_NEAR(lower.c_cos_friction, weaker.c_cos_friction, 1e-9);
    }
  }
}

// A block so heavy that it moves as it is told, sheared by gamma in small steps.
MaterialPointMethod sheared(const Strength& strength, double gamma, bool accumulates = true) {
  Block block;
  block.columns = block.rows = 12;
  block.first_column = block.first_row = 4;
  block.soil_columns = block.soil_rows = 3;
  block.settings.gravity = 0.0;
  block.soil.grain_density = 1e20;
  block.soil.strength = strength;
  MaterialPointMethod solid = block.build();
  Particles& p = solid.particles();
  std::fill(p.sxx.begin(), p.sxx.end(), -5.0e4);
  std::fill(p.syy.begin(), p.syy.end(), -5.0e4);
  std::fill(p.szz.begin(), p.szz.end(), -5.0e4);
  const int steps = 400;
  for (int step = 0; step < steps; ++step) {
    for (std::size_t i = 0; i < p.size(); ++i) {
      p.vx[i] = gamma / steps * (p.y[i] - 2.75);
      p.vy[i] = 0.0;
      p.cxx[i] = p.cyx[i] = p.cyy[i] = 0.0;
      p.cxy[i] = gamma / steps;
    }
    solid.predict(1.0, {}, {}, 0.0);
    solid.advance(1.0, {}, {.yields = true, .moves = false, .accumulates_strain = accumulates});
  }
  return solid;
}

SymmetricTensor stress_of(const MaterialPointMethod& solid) {
  const Particles& p = solid.particles();
  return {p.sxx[0], p.syy[0], p.szz[0], p.sxy[0]};
}

TEST(Softening, PlasticStrainIsTheStrainBeyondTheElasticOne) {
  const double strength = 2.0e4, gamma = 0.03;
  const MaterialPointMethod solid = sheared(VonMises{.undrained_strength = strength}, gamma);
  // the deviator turns a little (Jaumann), so the shear modulus is met to a percent only
  const double elastic = strength / testing::table_2_soil().elastic.shear_modulus();
  EXPECT_NEAR(solid.particles().plastic_strain[0], (gamma - elastic) / std::sqrt(3.0), 1e-2 * gamma);
  const MaterialPointMethod initial = sheared(VonMises{.undrained_strength = strength}, gamma, false);
  EXPECT_EQ(initial.particles().plastic_strain[0], 0.0);
  EXPECT_EQ(sheared(NoYield{}, gamma).particles().plastic_strain[0], 0.0);
}

TEST(Softening, ShearedFarTheSoilHasItsResidualStrength) {
  const MaterialPointMethod clay =
      sheared(VonMises{.undrained_strength = 2.0e4, .softening = UndrainedSoftening{5.0e3, range}}, 0.2);
  EXPECT_NEAR(std::sqrt(second_invariant(stress_of(clay))), 5.0e3, 1e-6);
  const MaterialPointMethod sand = sheared(brittle<MohrCoulomb>(), 0.2);
  const YieldPyramid residual = SuctionDependentPyramid(brittle<MohrCoulomb>()).at(0.0, 1.0);
  EXPECT_NEAR(residual.value(stress_of(sand)), 0.0, 1e-6);
  EXPECT_NEAR(residual.sin_friction, std::sin(20.0 * degree), 1e-12);
  const MaterialPointMethod cone = sheared(brittle<DruckerPrager>(), 0.2);
  EXPECT_NEAR(SuctionDependentCone(brittle<DruckerPrager>()).at(0.0, 1.0).value(stress_of(cone)), 0.0, 1e-6);
}

}  // namespace
}  // namespace slope::solid
