#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "block.hpp"

namespace slope::solid {
namespace {

using testing::Block;

// So heavy that no stress changes its motion: the strain is what the test prescribes.
Block driven_block() {
  Block block;
  block.columns = block.rows = 12;
  block.first_column = block.first_row = 4;
  block.soil_columns = block.soil_rows = 3;
  block.settings.gravity = 0.0;
  block.soil.grain_density = 1e20;
  return block;
}

void set_velocity_gradient(Particles& p, double xx, double xy, double yx, double yy) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double x = p.x[i] - 2.75, y = p.y[i] - 2.75;
    p.vx[i] = xx * x + xy * y;
    p.vy[i] = yx * x + yy * y;
    p.cxx[i] = xx;
    p.cxy[i] = xy;
    p.cyx[i] = yx;
    p.cyy[i] = yy;
  }
}

TEST(StressUpdate, ElasticPlaneStrain) {
  MaterialPointMethod solid = driven_block().build();
  Particles& p = solid.particles();
  set_velocity_gradient(p, 1e-3, 4e-3, 0.0, -2e-3);
  solid.predict(1.0, {}, {}, 0.0);
  solid.advance(1.0, {}, {.yields = false, .moves = false});
  const Elastic elastic = testing::table_2_soil().elastic;
  const double lame = elastic.bulk_modulus() - 2.0 / 3.0 * elastic.shear_modulus(), shear = elastic.shear_modulus();
  for (std::size_t i = 0; i < p.size(); ++i) {
    EXPECT_NEAR(p.exx[i], 1e-3, 1e-12);
    EXPECT_NEAR(p.eyy[i], -2e-3, 1e-12);
    EXPECT_NEAR(p.exy[i], 2e-3, 1e-12);
    EXPECT_NEAR(p.sxx[i], lame * -1e-3 + 2.0 * shear * 1e-3, 1e-4);
    EXPECT_NEAR(p.syy[i], lame * -1e-3 - 2.0 * shear * 2e-3, 1e-4);
    EXPECT_NEAR(p.szz[i], lame * -1e-3, 1e-4);
    EXPECT_NEAR(p.sxy[i], 2.0 * shear * 2e-3, 1e-4);
    EXPECT_EQ(p.porosity[i], 0.35);
  }
}

TEST(StressUpdate, StressTurnsWithTheSoil) {
  MaterialPointMethod solid = driven_block().build();
  Particles& p = solid.particles();
  std::fill(p.sxx.begin(), p.sxx.end(), -1.0e4);
  std::fill(p.syy.begin(), p.syy.end(), -3.0e4);
  std::fill(p.szz.begin(), p.szz.end(), -2.0e4);
  const int steps = 2000;
  const double dt = 0.25 * std::numbers::pi / steps;  // an eighth of a turn, counterclockwise
  for (int step = 0; step < steps; ++step) {
    set_velocity_gradient(p, 0.0, -1.0, 1.0, 0.0);
    solid.predict(dt, {}, {}, 0.0);
    solid.advance(dt, {}, {.yields = false, .moves = false, .accumulates_strain = false});
  }
  for (std::size_t i = 0; i < p.size(); ++i) {
    EXPECT_NEAR(p.sxx[i], -2.0e4, 20.0);
    EXPECT_NEAR(p.syy[i], -2.0e4, 20.0);
    EXPECT_NEAR(p.sxy[i], 1.0e4, 20.0);
    EXPECT_NEAR(p.szz[i], -2.0e4, 1e-4);
    EXPECT_EQ(p.exx[i], 0.0);
  }
}

TEST(StressUpdate, VolumeAndPorosityKeepTheGrains) {
  MaterialPointMethod solid = driven_block().build();
  Particles& p = solid.particles();
  const double grains = 0.65 * p.volume[0];
  for (int step = 0; step < 10; ++step) {
    set_velocity_gradient(p, -0.01, 0.0, 0.0, -0.02);
    solid.predict(1.0, {}, {}, 0.0);
    solid.advance(1.0, {}, {.yields = false});
  }
  for (std::size_t i = 0; i < p.size(); ++i) {
    EXPECT_NEAR(p.volume[i], 0.0625 * std::pow(0.97, 10), 1e-12);
    EXPECT_NEAR((1.0 - p.porosity[i]) * p.volume[i], grains, 1e-15);
  }
}

TEST(StressUpdate, YieldsAtTheStrengthOfItsSuction) {
  Block block = driven_block();
  block.soil.strength = testing::table_2_strength();
  MaterialPointMethod solid = block.build();
  Particles& p = solid.particles();
  std::vector<double> suction(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) suction[i] = i % 2 == 0 ? 9.0e4 : -1.0e4;
  set_velocity_gradient(p, 0.0, 0.2, 0.0, 0.0);
  solid.predict(1.0, {}, {}, 0.0);
  solid.advance(1.0, suction, {.yields = true, .moves = false});
  const SuctionDependentCone law(testing::table_2_strength());
  for (std::size_t i = 0; i < p.size(); ++i) {
    const SymmetricTensor stress{p.sxx[i], p.syy[i], p.szz[i], p.sxy[i]};
    EXPECT_NEAR(law.at(suction[i]).value(stress), 0.0, 1e-8);
    EXPECT_NE(stress.xy, 0.0);
  }
}

// One particle dilates in soil that does not yield: its neighbours meet a part of its volume change, none of it is
// lost, and no two particles of a cell are pressed against each other.
TEST(StressUpdate, DilationIsSharedWithTheSoilAround) {
  Block block = driven_block();
  DruckerPrager strength = testing::table_2_strength();
  strength.friction_angle = strength.dilatancy_angle = 25.0 * testing::degree;
  strength.maximum_cohesion_increase = 1.0e6;
  block.soil.strength = strength;
  MaterialPointMethod solid = block.build();
  Particles& p = solid.particles();
  const std::size_t weak = 14;
  std::vector<double> suction(p.size(), 1.0e7);
  suction[weak] = 0.0;
  set_velocity_gradient(p, 0.0, 2e-3, 0.0, 0.0);
  solid.predict(1.0, {}, {}, 0.0);
  solid.advance(1.0, suction, {.moves = false});
  const double bulk = block.soil.elastic.bulk_modulus(), shear = block.soil.elastic.shear_modulus();
  // the return mapping of the weak one by itself, from a stress of pure shear
  const YieldCone cone = SuctionDependentCone(strength).at(0.0);
  const double own =
      3.0 * cone.eta * (2e-3 * shear - cone.xi_c) / (shear + 9.0 * bulk * cone.eta * cone.eta);  // volumetric strain
  double sum = 0.0, most = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double mean = (p.sxx[i] + p.syy[i] + p.szz[i]) / 3.0;
    EXPECT_LE(mean, 1e-6);
    sum -= mean / bulk * p.volume[i];
    most = std::max(most, -mean / bulk);
  }
  EXPECT_NEAR(sum, own * p.volume[weak], 1e-9 * own * p.volume[weak]);
  EXPECT_LT(most, 0.3 * own);
  EXPECT_NEAR(cone.value({p.sxx[weak], p.syy[weak], p.szz[weak], p.sxy[weak]}), 0.0, 1e-8);
}

}  // namespace
}  // namespace slope::solid
