#include <gtest/gtest.h>

#include <algorithm>

#include "block.hpp"

namespace slope::solid {
namespace {

using testing::Block;

Block filled_box(Wall wall) {
  Block block;
  block.columns = block.soil_columns = 6;
  block.rows = 8;
  block.soil_rows = 6;
  block.walls = {.left = wall, .right = wall, .base = wall};
  block.settings.gravity = 0.0;
  return block;
}

// One step of a uniform velocity, then the velocity of the particle nearest to a place.
std::array<double, 2> after_a_step(Wall wall, double vx, double vy, double x, double y) {
  MaterialPointMethod solid = filled_box(wall).build();
  Particles& p = solid.particles();
  std::fill(p.vx.begin(), p.vx.end(), vx);
  std::fill(p.vy.begin(), p.vy.end(), vy);
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (std::hypot(p.x[i] - x, p.y[i] - y) < std::hypot(p.x[nearest] - x, p.y[nearest] - y)) nearest = i;
  }
  solid.predict(1e-6, {}, {}, 0.0);
  solid.advance(1e-6, {}, {.yields = false, .moves = false});
  return {p.vx[nearest], p.vy[nearest]};
}

TEST(Walls, FreeHoldsNothing) {
  const auto v = after_a_step(Wall::free, 1.0, -2.0, 0.0, 0.0);
  EXPECT_NEAR(v[0], 1.0, 1e-12);
  EXPECT_NEAR(v[1], -2.0, 1e-12);
}

TEST(Walls, RollerHoldsWhatIsNormalAndLeavesTheRest) {
  const auto left = after_a_step(Wall::roller, 1.0, -2.0, 0.0, 1.5);
  EXPECT_LT(std::abs(left[0]), 0.3);
  EXPECT_NEAR(left[1], -2.0, 1e-12);
  const auto base = after_a_step(Wall::roller, 1.0, -2.0, 1.5, 0.0);
  EXPECT_NEAR(base[0], 1.0, 1e-12);
  EXPECT_LT(std::abs(base[1]), 0.6);
  const auto corner = after_a_step(Wall::roller, 1.0, -2.0, 3.0, 0.0);
  EXPECT_LT(std::abs(corner[0]), 0.3);
  EXPECT_LT(std::abs(corner[1]), 0.6);
}

TEST(Walls, FixedHoldsAll) {
  const auto right = after_a_step(Wall::fixed, 1.0, -2.0, 3.0, 1.5);
  EXPECT_LT(std::abs(right[0]), 0.3);
  EXPECT_LT(std::abs(right[1]), 0.6);
}

// A velocity field that a wall allows passes through the grid as it is: no energy is lost at the wall and, above all,
// none made.
class CompatibleField : public ::testing::TestWithParam<Wall> {};
INSTANTIATE_TEST_SUITE_P(Walls, CompatibleField, ::testing::Values(Wall::roller, Wall::fixed));

TEST_P(CompatibleField, PassesUnchanged) {
  Block block = filled_box(GetParam());
  block.walls.left = block.walls.right = Wall::roller;
  block.soil.elastic.youngs_modulus = 1e-6;
  MaterialPointMethod solid = block.build();
  Particles& p = solid.particles();
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.vy[i] = p.y[i];
    p.cyy[i] = 1.0;
  }
  for (int step = 0; step < 200; ++step) {
    solid.predict(1e-3, {}, {}, 0.0);
    solid.advance(1e-3, {}, {.yields = false, .moves = false});
  }
  for (std::size_t i = 0; i < p.size(); ++i) {
    EXPECT_NEAR(p.vy[i], p.y[i], 1e-9);
    EXPECT_NEAR(p.vx[i], 0.0, 1e-9);
    EXPECT_NEAR(p.cyy[i], 1.0, 1e-9);
  }
}

// So it does where the nodes on the wall move: the soil slides and shears, and a wall without friction takes nothing.
TEST(Walls, AShearedLayerThatSlidesPassesUnchanged) {
  Block block = filled_box(Wall::friction);
  block.walls.left = block.walls.right = Wall::free;
  block.soil.elastic.youngs_modulus = 1e-6;
  MaterialPointMethod solid = block.build();
  Particles& p = solid.particles();
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.vx[i] = 1.0 + p.y[i];
    p.cxy[i] = 1.0;
  }
  for (int step = 0; step < 200; ++step) {
    solid.predict(1e-3, {}, {}, 0.0);
    solid.advance(1e-3, {}, {.yields = false, .moves = false});
  }
  for (std::size_t i = 0; i < p.size(); ++i) {
    EXPECT_NEAR(p.vx[i], 1.0 + p.y[i], 1e-9);
    EXPECT_NEAR(p.vy[i], 0.0, 1e-9);
  }
}

// A wall with much friction is a fixed one as long as nothing slides or comes off, to the last bit.
TEST(Walls, FrictionThatHoldsIsAFixedWall) {
  std::array<Particles, 2> after;
  for (const Wall wall : {Wall::fixed, Wall::friction}) {
    Block block = filled_box(wall);
    block.walls.left = block.walls.right = Wall::roller;
    block.walls.base_friction = 1e3;
    block.settings.gravity = 9.81;
    MaterialPointMethod solid = block.build();
    Particles& p = solid.particles();
    for (std::size_t i = 0; i < p.size(); ++i) p.syy[i] = -block.dry_density() * 9.81 * (3.0 - p.y[i]);
    for (int step = 0; step < 50; ++step) {
      solid.predict(1e-3, {}, {.body_acceleration = {1.0, 0.0}}, 0.0);
      solid.advance(1e-3, {}, {.yields = false});
    }
    after[wall == Wall::friction] = p;
  }
  EXPECT_EQ(after[0].x, after[1].x);
  EXPECT_EQ(after[0].vx, after[1].vx);
  EXPECT_EQ(after[0].syy, after[1].syy);
}

// Particles that graze the base leave their image nodes with mass enough for their momentum.
TEST(Walls, AThinLayerOnTheBaseIsNotThrownUp) {
  Block block = filled_box(Wall::fixed);
  block.soil_rows = 1;
  MaterialPointMethod solid = block.build();
  Particles& p = solid.particles();
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.y[i] = 1e-6 * static_cast<double>(1 + i % 3);
    p.vx[i] = 0.1;
    p.cxy[i] = 1.0;
  }
  solid.predict(1e-4, {}, {}, 0.0);
  solid.advance(1e-4, {});
  EXPECT_LT(testing::fastest(p), 0.1);
}

}  // namespace
}  // namespace slope::solid
