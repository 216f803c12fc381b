// Strength divided by a factor.

#include <gtest/gtest.h>

#include <cmath>

#include "block.hpp"
#include "slope/solid/drucker_prager.hpp"
#include "slope/solid/material_point_method.hpp"
#include "slope/solid/mohr_coulomb.hpp"
#include "slope/solid/von_mises.hpp"

namespace slope::solid {
namespace {

constexpr double factor = 1.7;
constexpr double residual_cohesion = 2.0e3, residual_friction_angle = 0.3;

// c, phi and psi as they are at a suction and a plastic strain (paper, Eqs. 15 and 16; linear softening).
struct Now {
  double suction, plastic_strain;
  double cohesion, friction_angle, dilatancy_angle;
};

template <class Law>
Law soil() {
  Law law;
  law.cohesion = 5.0e3;
  law.friction_angle = 0.5;
  law.dilatancy_angle = 0.35;
  law.maximum_cohesion_increase = 8.0e4;
  law.cohesion_suction_rate = 0.4;
  law.friction_angle_suction_rate = 0.1;
  law.softening = FrictionalSoftening{residual_cohesion, residual_friction_angle, {0.01, 0.05, 0.0}};
  return law;
}

std::vector<Now> states() {
  std::vector<Now> result;
  for (const double suction : {-3.0e4, 0.0, 4.0e4}) {
    for (const double plastic_strain : {0.0, 0.03, 0.2}) {
      const double share = std::clamp((plastic_strain - 0.01) / 0.04, 0.0, 1.0);
      const double s = std::max(suction, 0.0) / 101325.0;
      result.push_back({suction, plastic_strain,
                        5.0e3 + share * (residual_cohesion - 5.0e3) + 8.0e4 * (1.0 - std::exp(-0.4 * s)),
                        0.5 + share * (residual_friction_angle - 0.5) + 0.1 * s, 0.35 * (1.0 - share)});
    }
  }
  return result;
}

TEST(StrengthReduction, DividesCohesionAndTheTangentOfFrictionWhateverTheyAre) {
  MohrCoulomb reduced = soil<MohrCoulomb>();
  reduced.reduction = factor;
  const SuctionDependentPyramid pyramid(reduced);
  for (const Now& now : states()) {
    const double angle = std::atan(std::tan(now.friction_angle) / factor);
    const YieldPyramid found = pyramid.at(now.suction, now.plastic_strain);
    EXPECT_NEAR(found.sin_friction, std::sin(angle), 1.0e-12);
    EXPECT_NEAR(found.c_cos_friction, now.cohesion / factor * std::cos(angle), 1.0e-9 * now.cohesion);
    EXPECT_NEAR(found.sin_dilatancy, std::sin(std::min(now.dilatancy_angle, angle)), 1.0e-12)
        << "it dilates as before, up to associated flow";
  }
}

TEST(StrengthReduction, OfAConeIsThatOfASoilWithTheReducedStrength) {
  DruckerPrager reduced = soil<DruckerPrager>();
  reduced.reduction = factor;
  const SuctionDependentCone cone(reduced);
  for (const Now& now : states()) {
    DruckerPrager weaker;
    weaker.cohesion = now.cohesion / factor;
    weaker.friction_angle = std::atan(std::tan(now.friction_angle) / factor);
    weaker.dilatancy_angle = std::min(now.dilatancy_angle, weaker.friction_angle);
    const YieldCone found = cone.at(now.suction, now.plastic_strain), right = SuctionDependentCone(weaker).at(0.0);
    EXPECT_NEAR(found.eta, right.eta, 1.0e-12);
    EXPECT_NEAR(found.eta_potential, right.eta_potential, 1.0e-12);
    EXPECT_NEAR(found.xi_c, right.xi_c, 1.0e-9 * now.cohesion);
  }
}

TEST(StrengthReduction, DividesUndrainedStrength) {
  VonMises clay{.undrained_strength = 3.0e4,
                .softening = UndrainedSoftening{.residual_undrained_strength = 1.0e4, .range = {0.0, 0.1, 0.0}},
                .reduction = factor};
  EXPECT_DOUBLE_EQ(SofteningCylinder(clay).at(0.0, 0.0).undrained_strength, 3.0e4 / factor);
  EXPECT_DOUBLE_EQ(SofteningCylinder(clay).at(0.0, 0.05).undrained_strength, 2.0e4 / factor);
  clay.softening.reset();
  EXPECT_DOUBLE_EQ(SofteningCylinder(clay).at(0.0, 0.0).undrained_strength, 3.0e4 / factor);
}

double strength_of(const MaterialPointMethod& solid, std::size_t p) {
  return std::get<VonMises>(solid.soils()[solid.particles().soil[p]].strength).undrained_strength /
         std::get<VonMises>(solid.soils()[solid.particles().soil[p]].strength).reduction;
}

TEST(StrengthReduction, WeakensWhereItIsToldAndTheWallsWithAll) {
  Grid grid;
  grid.cell_size = 1.0;
  grid.columns = 4, grid.rows = 4;
  grid.walls.base = Wall::friction;
  grid.walls.base_friction = 0.6;
  Soil clay;
  clay.elastic = {1.0e7, 0.3};
  clay.strength = VonMises{.undrained_strength = 2.0e4, .softening = {}, .reduction = 1.0};
  clay.grain_density = 2700.0;
  const std::vector<double> x{0.5, 1.5, 2.5}, y{0.5, 0.5, 0.5}, volume(3, 1.0), porosity(3, 0.3);
  const std::vector<std::uint16_t> soil(3, 0);
  const std::vector<double> density{2700.0};
  const MaterialPointMethod solid(grid, {clay}, Particles::at(x, y, volume, porosity, soil, density), Settings{});

  const MaterialPointMethod all = solid.weakened(2.0);
  const std::vector<std::uint8_t> second{0, 1, 0};
  const MaterialPointMethod one = solid.weakened(4.0, second), again = one.weakened(2.0);
  for (std::size_t p = 0; p < 3; ++p) {
    EXPECT_EQ(strength_of(solid, p), 2.0e4) << "the original is as it was";
    EXPECT_EQ(strength_of(all, p), 1.0e4);
    EXPECT_EQ(strength_of(one, p), p == 1 ? 5.0e3 : 2.0e4);
    EXPECT_EQ(strength_of(again, p), p == 1 ? 2.5e3 : 1.0e4) << "factors multiply";
  }
  EXPECT_EQ(solid.grid().walls.base_friction, 0.6);
  EXPECT_EQ(all.grid().walls.base_friction, 0.3);
  EXPECT_EQ(one.grid().walls.base_friction, 0.6) << "a part of the soil takes no wall with it";
  EXPECT_THROW((void)solid.weakened(0.0), std::invalid_argument);
}

}  // namespace
}  // namespace slope::solid
