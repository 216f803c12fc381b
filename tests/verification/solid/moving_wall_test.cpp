// Walls that move: a layer that slides on a frictional base, and waves that leave through an absorbing one. And the
// shear of a layer by a horizontal body force.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <slope/testing/record.hpp>

#include "block.hpp"

namespace slope::solid {
namespace {

using slope::testing::at_most;
using slope::testing::near;
using slope::testing::record;
using testing::Block;

constexpr double gravity = 9.81;

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

// A layer of 6 m x 1 m on a base with friction, free on the left and on the right; its mean acceleration (m/s2) under a
// horizontal body force of so many shares of its weight.
double acceleration_on_friction(double friction, double horizontal_coefficient) {
  Block block;
  block.columns = 40;
  block.first_column = 10;
  block.soil_columns = 12;
  block.soil_rows = 2;
  block.rows = 6;
  block.walls = {.left = Wall::free, .right = Wall::free, .base = Wall::friction, .base_friction = friction};
  MaterialPointMethod solid = block.build();
  const double dt = solid.stable_step(0.5, {});
  const StepMode initial{.yields = false, .moves = false, .accumulates_strain = false};
  for (int step = 0; step < 800; ++step) {
    solid.predict(dt, {}, {}, 40.0);
    solid.advance(dt, {}, initial);
  }
  solid.stop();
  double time = 0.0, early_time = 0.0, early = 0.0;
  while (time < 1.0) {
    const double push = horizontal_coefficient * gravity * std::min(1.0, time / 0.2);
    solid.predict(dt, {}, {.body_acceleration = {push, 0.0}}, 0.0);
    solid.advance(dt, {}, {.yields = false});
    time += dt;
    if (early_time == 0.0 && time > 0.4) {
      early_time = time;
      early = mean(solid.particles().vx);
    }
  }
  return (mean(solid.particles().vx) - early) / (time - early_time);
}

TEST(FrictionWall, ALayerSlidesWithWhatFrictionLeaves) {
  for (const auto& [friction, push] : {std::pair{0.3, 0.5}, std::pair{0.0, 0.2}, std::pair{0.5, -0.6}}) {
    const double expected = (push - std::copysign(friction, push)) * gravity;
    const double reached = acceleration_on_friction(friction, push);
    EXPECT_NEAR(reached, expected, 0.01 * gravity * std::abs(push)) << friction << " " << push;
    if (friction == 0.3) {
      EXPECT_TRUE(record("friction-base", "Layer on a frictional base (0.3), k_h = 0.5: acceleration",
                         near(expected, 0.02 * expected), reached, "m/s2"));
    }
  }
}

TEST(FrictionWall, ALayerSticksBelowTheCoefficient) {
  EXPECT_NEAR(acceleration_on_friction(0.5, 0.3), 0.0, 0.002 * gravity);
}

// A layer pushed sideways shears by rho a H^2 / 2G at its top; wide enough for its middle to know nothing of its ends.
TEST(BodyForce, ShearsALayer) {
  Block block;
  block.cell_size = 0.25;
  block.soil_columns = 96;
  block.columns = 108;
  block.first_column = 6;
  block.soil_rows = 8;
  block.rows = 12;
  block.walls = {.left = Wall::free, .right = Wall::free, .base = Wall::fixed};
  block.settings.gravity = 0.0;
  MaterialPointMethod solid = block.build();
  const double height = 2.0, push = 0.1 * gravity, shear = block.soil.elastic.shear_modulus();
  const double dt = solid.stable_step(0.5, {});
  const double first_mode = 0.5 * std::numbers::pi * std::sqrt(shear / block.dry_density()) / height;
  for (double time = 0.0; time < 12.0 / first_mode; time += dt) {
    solid.predict(dt, {}, {.body_acceleration = {push, 0.0}}, 2.0 * first_mode);
    solid.advance(dt, {}, {.yields = false, .moves = false});
  }
  // the displacement of the top is the sum of the shear strain over the column in the middle
  const Particles& p = solid.particles();
  double displacement = 0.0;
  int rows = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (std::abs(p.x[i] - 13.5) > block.spacing()) continue;
    displacement += 2.0 * p.exy[i] * block.spacing();
    ++rows;
  }
  displacement /= rows / 16.0;
  const double expected = block.dry_density() * push * height * height / (2.0 * shear);
  EXPECT_TRUE(record("body-force-shear",
                     "Layer 2 m high, k_h = 0.1: shear displacement of its top (rho k_h g H^2 / 2G)",
                     near(1e3 * expected, 1e1 * expected), 1e3 * displacement, "mm"));
}

struct Wave {
  Wall wall = Wall::absorbing;
  bool shear = false;
};

// Energy left in the middle of a layer when a pulse that runs towards its base has been there, over the energy before.
double energy_left(const Wave& wave) {
  Block block;
  block.soil_columns = wave.shear ? 160 : 2;
  block.columns = wave.shear ? 172 : 2;
  block.first_column = wave.shear ? 6 : 0;
  block.soil_rows = 40;
  block.rows = 44;
  const Wall side = wave.shear ? Wall::free : Wall::roller;
  block.walls = {.left = side, .right = side, .base = wave.wall, .absorbing_depth = 1e4};
  block.settings.gravity = 0.0;
  MaterialPointMethod solid = block.build();
  solid.release_walls({});
  const Elastic& elastic = block.soil.elastic;
  const double modulus = wave.shear ? elastic.shear_modulus() : elastic.constrained_modulus();
  const double speed = std::sqrt(modulus / block.dry_density());
  const double ratio = elastic.poissons_ratio / (1.0 - elastic.poissons_ratio);
  Particles& p = solid.particles();
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double x = (p.y[i] - 10.0) / 2.0;
    const double v = 1e-3 * std::exp(-x * x), gradient = -x * v;
    const double stress = modulus * v / speed;
    if (wave.shear) {
      p.vx[i] = v;
      p.cxy[i] = gradient;
      p.sxy[i] = stress;
    } else {
      p.vy[i] = v;
      p.cyy[i] = gradient;
      p.syy[i] = stress;
      p.sxx[i] = p.szz[i] = ratio * stress;
    }
  }
  const double middle = 0.5 * block.columns * block.cell_size;
  const auto energy = [&] {
    double sum = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      if (std::abs(p.x[i] - middle) > 1.0) continue;
      const double v = wave.shear ? p.vx[i] : p.vy[i], stress = wave.shear ? p.sxy[i] : p.syy[i];
      sum += block.dry_density() * v * v + stress * stress / modulus;
    }
    return sum;
  };
  const double before = energy();
  const double dt = solid.stable_step(0.5, {});
  // until the reflection, if there is one, is where the pulse was
  for (double time = 0.0; time < 20.0 / speed; time += dt) {
    solid.predict(dt, {}, {}, 0.0);
    solid.advance(dt, {}, {.yields = false, .moves = false});
  }
  return energy() / before;
}

TEST(AbsorbingWall, LetsWavesOut) {
  EXPECT_GT(energy_left({.wall = Wall::fixed, .shear = false}), 0.5) << "a fixed base sends it back";
  EXPECT_TRUE(record("absorbing-base-p", "Pressure pulse through an absorbing base: energy reflected", at_most(0.02),
                     energy_left({.wall = Wall::absorbing, .shear = false}), "%"));
  EXPECT_GT(energy_left({.wall = Wall::fixed, .shear = true}), 0.5);
  EXPECT_TRUE(record("absorbing-base-s", "Shear pulse through an absorbing base: energy reflected", at_most(0.02),
                     energy_left({.wall = Wall::absorbing, .shear = true}), "%"));
}

// The wall bears the weight as a fixed one does; what comes on top sinks by the soil's own compression and that of the
// soil behind the wall.
TEST(AbsorbingWall, BearsWhatRestsOnIt) {
  Block block;
  block.walls.base = Wall::absorbing;
  block.walls.absorbing_depth = 5.0;
  MaterialPointMethod solid = block.build();
  const double height = 10.0, modulus = block.soil.elastic.constrained_modulus();
  const double first_mode = 0.5 * std::numbers::pi * std::sqrt(modulus / block.dry_density()) / height;
  const double dt = solid.stable_step(0.5, {});
  for (double time = 0.0; time < 20.0 / first_mode; time += dt) {
    solid.predict(dt, {}, {}, 2.0 * first_mode);
    solid.advance(dt, {}, {.yields = false, .moves = false, .accumulates_strain = false});
  }
  solid.stop();
  solid.release_walls({});
  Particles& p = solid.particles();
  const auto settlement = [&p] { return -*std::min_element(p.uy.begin(), p.uy.end()); };
  for (double time = 0.0; time < 10.0 / first_mode; time += dt) {
    solid.predict(dt, {}, {}, 0.0);
    solid.advance(dt, {}, {.yields = false});
  }
  EXPECT_LT(settlement(), 1e-8);
  std::vector<ParticleTraction> load;
  for (std::size_t i = p.size() - 4; i < p.size(); ++i) load.push_back({i, 0.0, -1.0e4, 0.0, 0.5 * block.spacing()});
  for (double time = 0.0; time < 30.0 / first_mode; time += dt) {
    solid.predict(dt, {}, {.tractions = load}, 2.0 * first_mode);
    solid.advance(dt, {}, {.yields = false});
  }
  EXPECT_NEAR(settlement(), 1.0e4 * (height + 5.0) / modulus, 0.02 * 1.0e4 * height / modulus);
}

}  // namespace
}  // namespace slope::solid
