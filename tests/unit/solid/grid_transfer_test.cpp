#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "block.hpp"

namespace slope::solid {
namespace {

using testing::Block;

struct Momentum {
  double x = 0.0, y = 0.0, angular = 0.0;
};

// Of the particles and, with APIC, of their affine fields, whose moment of inertia is h^2 / 4 for the B-spline.
Momentum momentum_of(const MaterialPointMethod& solid) {
  const Particles& p = solid.particles();
  const double inertia = 0.25 * solid.grid().cell_size * solid.grid().cell_size;
  Momentum sum;
  for (std::size_t i = 0; i < p.size(); ++i) {
    sum.x += p.solid_mass[i] * p.vx[i];
    sum.y += p.solid_mass[i] * p.vy[i];
    sum.angular += p.solid_mass[i] * (p.x[i] * p.vy[i] - p.y[i] * p.vx[i] + inertia * (p.cyx[i] - p.cxy[i]));
  }
  return sum;
}

double mass_of(const MaterialPointMethod& solid) {
  double sum = 0.0;
  for (const double mass : solid.particles().solid_mass) sum += mass;
  return sum;
}

// A block of 4 x 3 cells in the middle of an empty box, crooked, away from all walls.
Block flying_block() {
  Block block;
  block.columns = 20;
  block.rows = 20;
  block.first_column = 8;
  block.first_row = 8;
  block.soil_columns = 4;
  block.soil_rows = 3;
  return block;
}

struct Scheme {
  const char* name;
  ShapeFunction shape;
  double flip;
};
std::ostream& operator<<(std::ostream& out, const Scheme& scheme) {
  return out << scheme.name;
}

class GridTransfer : public ::testing::TestWithParam<Scheme> {
 protected:
  static Block block() {
    Block flying = flying_block();
    flying.settings.shape_function = GetParam().shape;
    flying.settings.flip_fraction = GetParam().flip;
    return flying;
  }
};

INSTANTIATE_TEST_SUITE_P(Schemes, GridTransfer,
                         ::testing::Values(Scheme{"Apic", ShapeFunction::quadratic_bspline, -1.0},
                                           Scheme{"Flip", ShapeFunction::quadratic_bspline, 0.95},
                                           Scheme{"Pic", ShapeFunction::quadratic_bspline, 0.0},
                                           Scheme{"LinearApic", ShapeFunction::linear, -1.0},
                                           Scheme{"LinearFlip", ShapeFunction::linear, 1.0}),
                         [](const auto& scheme) { return std::string(scheme.param.name); });

TEST_P(GridTransfer, FreeFallIsExact) {
  MaterialPointMethod solid = block().build();
  const double dt = 1e-3;
  const std::vector<double> start = solid.particles().y;
  for (int step = 1; step <= 300; ++step) {
    solid.predict(dt, {}, {}, 0.0);
    solid.advance(dt, {});
  }
  const double g = 9.81, t = 0.3;
  for (std::size_t p = 0; p < start.size(); ++p) {
    EXPECT_NEAR(solid.particles().vy[p], -g * t, 1e-10);
    EXPECT_NEAR(solid.particles().vx[p], 0.0, 1e-10);
    EXPECT_NEAR(solid.particles().y[p] - start[p], -0.5 * g * t * (t + dt), 1e-10);
    EXPECT_NEAR(solid.particles().uy[p], solid.particles().y[p] - start[p], 1e-12);
    EXPECT_NEAR(solid.particles().syy[p], 0.0, 1e-3);
  }
}

TEST_P(GridTransfer, RigidTranslationLeavesTheSoilAsItIs) {
  Block flying = block();
  flying.settings.gravity = 0.0;
  MaterialPointMethod solid = flying.build();
  std::fill(solid.particles().vx.begin(), solid.particles().vx.end(), 2.0);
  std::fill(solid.particles().vy.begin(), solid.particles().vy.end(), -1.0);
  for (int step = 0; step < 500; ++step) {
    solid.predict(2e-3, {}, {}, 0.0);
    solid.advance(2e-3, {});
  }
  const Particles& p = solid.particles();
  for (std::size_t i = 0; i < p.size(); ++i) {
    EXPECT_NEAR(p.ux[i], 2.0, 1e-9);
    EXPECT_NEAR(p.uy[i], -1.0, 1e-9);
    EXPECT_NEAR(p.sxx[i], 0.0, 1e-3);
    EXPECT_NEAR(p.porosity[i], 0.35, 1e-10);
  }
}

// A block that is hit, so that waves run through it: no force from outside, so its momentum stays.
TEST_P(GridTransfer, KeepsMomentum) {
  Block flying = block();
  flying.settings.gravity = 0.0;
  MaterialPointMethod solid = flying.build();
  Particles& p = solid.particles();
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.vx[i] = 0.3 + 0.5 * std::sin(2.0 * p.y[i]);
    p.vy[i] = -0.2 + 0.4 * p.x[i];
  }
  const double scale = mass_of(solid);
  const Momentum before = momentum_of(solid);
  const double dt = solid.stable_step(0.25, {});
  const bool angular = GetParam().flip < 0.0 && GetParam().shape == ShapeFunction::quadratic_bspline;
  for (int step = 0; step < 300; ++step) {
    solid.predict(dt, {}, {}, 0.0);
    solid.advance(dt, {});
    const Momentum now = momentum_of(solid);
    ASSERT_NEAR(now.x, before.x, 1e-10 * scale) << step;
    ASSERT_NEAR(now.y, before.y, 1e-10 * scale) << step;
    if (angular) {
      ASSERT_NEAR(now.angular, before.angular, 1e-9 * scale) << step;
    }
  }
}

TEST(Apic, RigidRotationTurnsOnUndiminished) {
  Block flying = flying_block();
  flying.settings.gravity = 0.0;
  MaterialPointMethod solid = flying.build();
  Particles& p = solid.particles();
  const double spin = 0.5, x0 = 5.0, y0 = 4.75;
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.vx[i] = -spin * (p.y[i] - y0);
    p.vy[i] = spin * (p.x[i] - x0);
    p.cxy[i] = -spin;
    p.cyx[i] = spin;
  }
  const double before = momentum_of(solid).angular;
  const double dt = 1e-3;
  for (int step = 0; step < 1000; ++step) {
    solid.predict(dt, {}, {}, 0.0);
    solid.advance(dt, {});
  }
  EXPECT_NEAR(momentum_of(solid).angular, before, 1e-10 * before);
  for (std::size_t i = 0; i < p.size(); ++i) {
    EXPECT_NEAR(p.cyx[i] - p.cxy[i], 2.0 * spin, 0.02 * spin);
  }
}

// How far soil without resistance goes on in bands that slide past each other, three cells wide: the transfer smooths
// them, as a viscosity would. What is left, once the affine fields have formed, after a number of steps.
double left_of_bands(double restored_losses, int steps) {
  Block flying = flying_block();
  flying.rows = 40;
  flying.soil_rows = 24;
  flying.settings.gravity = 0.0;
  flying.soil.elastic.youngs_modulus = 1.0e-9;
  MaterialPointMethod solid = flying.build();
  Particles& p = solid.particles();
  const auto bands = [&](std::size_t i) { return std::sin(std::numbers::pi * p.y[i] / (3.0 * flying.cell_size)); };
  for (std::size_t i = 0; i < p.size(); ++i) p.vx[i] = 1.0e-6 * bands(i);
  const auto go = [&](int number) {
    for (int step = 0; step < number; ++step) {
      solid.predict(1.0e-3, {}, {}, 0.0);
      solid.advance(1.0e-3, {}, {.restored_losses = restored_losses});
    }
    double sum = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) sum += p.solid_mass[i] * bands(i) * p.vx[i];
    return sum;
  };
  const double before = go(100);
  return go(steps) / before;
}

TEST(Apic, GivesBackWhatItTakesFromLastingMotion) {
  const auto rate = [](double share) { return -std::log(left_of_bands(share, 100)) / 100.0; };  // per step
  const double alone = rate(0.0);
  EXPECT_GT(alone, 5.0e-3);
  EXPECT_LT(rate(0.9), 0.2 * alone);
  EXPECT_LT(rate(0.99), 0.02 * alone);
  EXPECT_NEAR(left_of_bands(1.0, 1000), 1.0, 1.0e-3);
}

// Cells that vibrate against each other lose what APIC alone takes from them.
TEST(Apic, DampsVibrationsThoughItGivesBackWhatLasts) {
  const auto energy_left = [](double restored_losses) {
    Block flying = flying_block();
    flying.settings.gravity = 0.0;
    MaterialPointMethod solid = flying.build();
    Particles& p = solid.particles();
    for (std::size_t i = 0; i < p.size(); ++i) {
      p.vy[i] = 1.0e-4 * std::cos(std::numbers::pi * p.y[i] / flying.cell_size + 0.3);
    }
    const double dt = solid.stable_step(0.5, {});
    double first = 0.0, last = 0.0;
    for (int step = 0; step < 400; ++step) {
      solid.predict(dt, {}, {}, 0.0);
      solid.advance(dt, {}, {.restored_losses = restored_losses});
      if (step < 20) first += solid.balance().kinetic_energy;
      if (step >= 380) last += solid.balance().kinetic_energy;
    }
    return last / first;
  };
  const double alone = energy_left(0.0);
  EXPECT_LT(alone, 0.5);
  EXPECT_NEAR(energy_left(1.0), alone, 0.05 * alone);
}

TEST(Tractions, PushWithTheirShareOfTheSurface) {
  Block flying = flying_block();
  flying.settings.gravity = 0.0;
  MaterialPointMethod solid = flying.build();
  const std::vector<ParticleTraction> tractions{{0, 100.0, 0.0}, {5, 0.0, -40.0}, {5, 10.0, 0.0}};
  solid.predict(0.01, {}, {.tractions = tractions}, 0.0);
  solid.advance(0.01, {});
  EXPECT_NEAR(momentum_of(solid).x, 0.01 * 110.0 * 0.25, 1e-12);
  EXPECT_NEAR(momentum_of(solid).y, -0.01 * 40.0 * 0.25, 1e-12);
}

TEST(SurfacePressure, OfWaterAroundABlockLiftsItByTheWeightOfTheWater) {
  Block flying = flying_block();
  flying.settings.gravity = 0.0;
  for (const bool wet : {false, true}) {
    MaterialPointMethod solid = flying.build();
    const Particles& p = solid.particles();
    std::vector<double> pressure(p.size()), gradient_x(p.size(), 300.0), gradient_y(p.size(), -9810.0);
    double volume = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      pressure[i] = 1.0e5 + 300.0 * p.x[i] - 9810.0 * p.y[i];
      volume += p.volume[i];
    }
    const Momentum before = momentum_of(solid);
    const PoreState pore = wet ? PoreState{pressure, {}} : PoreState{};
    solid.predict(0.001, pore, {.surface = {pressure, gradient_x, gradient_y}}, 0.0);
    solid.advance(0.001, {});
    EXPECT_NEAR(momentum_of(solid).x - before.x, -0.001 * 300.0 * volume, 1e-9);
    EXPECT_NEAR(momentum_of(solid).y - before.y, 0.001 * 9810.0 * volume, 1e-9);
    double squeeze = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) squeeze = std::min(squeeze, p.sxx[i] + p.syy[i]);
    if (wet) {
      EXPECT_NEAR(squeeze, 0.0, 1e-6) << "the pores bear the same pressure";
    } else {
      EXPECT_LT(squeeze, -1.0);
    }
  }
}

TEST(Damping, SlowsByItsRate) {
  Block flying = flying_block();
  flying.settings.gravity = 0.0;
  MaterialPointMethod solid = flying.build();
  std::fill(solid.particles().vx.begin(), solid.particles().vx.end(), 1.0);
  for (int step = 0; step < 10; ++step) {
    solid.predict(1e-3, {}, {}, 5.0);
    solid.advance(1e-3, {});
  }
  EXPECT_NEAR(solid.particles().vx[3], std::pow(1.005, -10), 1e-12);
}

TEST(Threads, DoNotChangeASingleBit) {
  const auto run = [](int threads) {
    Block block;
    block.columns = 30;
    block.rows = 24;
    block.soil_columns = 17;
    block.soil_rows = 20;
    block.soil.strength = testing::table_2_strength();
    block.settings.threads = threads;
    MaterialPointMethod solid = block.build();
    const std::vector<double> water = block.pore_water(solid);
    std::vector<double> pressure(water.size());
    for (std::size_t p = 0; p < pressure.size(); ++p) pressure[p] = 9810.0 * (6.0 - solid.particles().y[p]);
    std::vector<double> change(water.size());
    const double dt = solid.stable_step(0.25, water);
    for (int step = 0; step < 20; ++step) {
      solid.predict(dt, {pressure, water}, {}, 0.0);
      solid.volume_response(dt, pressure, change);
      for (std::size_t p = 0; p < change.size(); ++p) change[p] *= 1e6;
      solid.correct(dt, change);
      solid.advance(dt, {});
    }
    return solid.particles();
  };
  const Particles one = run(1), two = run(2), three = run(3);
  EXPECT_EQ(one.x, two.x);
  EXPECT_EQ(one.vy, two.vy);
  EXPECT_EQ(one.sxy, two.sxy);
  EXPECT_EQ(one.porosity, two.porosity);
  EXPECT_EQ(one.syy, three.syy);
}

TEST(Balance, WeighsTheBlockAndItsMotion) {
  Block flying = flying_block();
  MaterialPointMethod solid = flying.build();
  std::fill(solid.particles().vx.begin(), solid.particles().vx.end(), 3.0);
  solid.predict(1e-3, {}, {}, 0.0);
  const double mass = mass_of(solid);
  EXPECT_NEAR(solid.balance().kinetic_energy, 4.5 * mass, 1e-9 * mass);
  EXPECT_NEAR(solid.balance().weight, 9.81 * mass, 1e-9 * mass);
  EXPECT_NEAR(solid.balance().unbalanced_force, 9.81 * mass, 1e-9 * mass);
  solid.stop();
  EXPECT_EQ(momentum_of(solid).x, 0.0);
}

}  // namespace
}  // namespace slope::solid
