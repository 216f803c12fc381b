// A column of the paper's Table 2 soil, 10 m high, 4 particles to a cell, between rollers.

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

constexpr double height = 10.0, gravity = 9.81;
constexpr StepMode stress_only{.yields = false, .moves = false, .accumulates_strain = true};

Block column(double cell_size) {
  Block block;
  block.cell_size = cell_size;
  block.soil_rows = static_cast<int>(std::lround(height / cell_size));
  block.rows = block.soil_rows + 4;
  return block;
}

double wave_speed(const Block& block) {
  return std::sqrt(block.soil.elastic.constrained_modulus() / block.saturated_density());
}

// The column under its own saturated weight, brought to rest with the critical damping of its first mode.
MaterialPointMethod settled(const Block& block, const StepMode& mode) {
  MaterialPointMethod solid = block.build();
  const std::vector<double> water = block.pore_water(solid);
  const double dt = solid.stable_step(0.25, water);
  const double first_mode = 0.5 * std::numbers::pi * wave_speed(block) / height;
  for (double time = 0.0; time < 12.0 / first_mode; time += dt) {
    solid.predict(dt, {{}, water}, {}, 2.0 * first_mode);
    solid.advance(dt, {}, mode);
  }
  return solid;
}

struct StressError {
  double of_largest = 0.0;  // all cells but the surface cell; over the largest stress
  double of_local = 0.0;    // the same but for the two cells nearest to the surface; over the stress there
  double sideways = 0.0;    // sigma_xx against K_0 times the weight above; over a cell's weight
  double shear = 0.0;       // sigma_xy against zero; over the largest stress
};

StressError error_of(const Block& block, const MaterialPointMethod& solid) {
  const double unit_weight = block.saturated_density() * gravity;
  const double nu = block.soil.elastic.poissons_ratio;
  const Particles& p = solid.particles();
  StressError error;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double weight_above = unit_weight * (height - p.y[i]);
    const double difference = std::abs(-p.syy[i] - weight_above);
    const double depth = (height - p.y[i]) / block.cell_size;
    if (depth > 1.0) error.of_largest = std::max(error.of_largest, difference / (unit_weight * height));
    if (depth > 2.0) error.of_local = std::max(error.of_local, difference / weight_above);
    error.sideways =
        std::max(error.sideways, std::abs(p.sxx[i] + nu / (1.0 - nu) * weight_above) / (unit_weight * block.cell_size));
    error.shear = std::max(error.shear, std::abs(p.sxy[i]) / (unit_weight * height));
  }
  return error;
}

TEST(SelfWeightColumn, StressIsTheWeightAbove) {
  const Block fine = column(0.25);
  const StressError error = error_of(fine, settled(fine, stress_only));
  EXPECT_TRUE(record("self-weight-stress",
                     "Self-weight column, 40 cells, B-spline, stress (of the largest) below the surface cell",
                     at_most(0.005), error.of_largest, "%"));
  EXPECT_TRUE(record("self-weight-stress-local",
                     "Self-weight column, 40 cells, B-spline, stress (of the stress there) below the two topmost cells",
                     at_most(0.005), error.of_local, "%"));
  EXPECT_TRUE(
      record("self-weight-stress-sideways",
             "Self-weight column, 40 cells, B-spline, sideways stress (of a cell's weight), the surface cell too",
             at_most(0.17), error.sideways, "%"));
  EXPECT_LT(error.shear, 1e-6);
}

// The error is that of a seventh of a cell's weight, at the base: it halves with the cells.
TEST(SelfWeightColumn, StressErrorIsOfFirstOrderAtTheBaseOnly) {
  const Block coarse = column(0.5);
  const StressError error = error_of(coarse, settled(coarse, stress_only));
  EXPECT_TRUE(record("self-weight-stress-coarse",
                     "Self-weight column, 20 cells, B-spline, stress (of the largest) below the surface cell",
                     at_most(0.0075), error.of_largest, "%"));
  EXPECT_LT(error.sideways, 0.17);
}

TEST(SelfWeightColumn, StressWithLinearShapeFunctions) {
  Block fine = column(0.25);
  fine.settings.shape_function = ShapeFunction::linear;
  EXPECT_TRUE(record("self-weight-stress-linear",
                     "Self-weight column, 40 cells, linear, stress (of the largest) below the surface cell",
                     at_most(0.01), error_of(fine, settled(fine, stress_only)).of_largest, "%"));
}

TEST(SelfWeightBlock, StressBetweenSidesOnARollerBase) {
  Block block = column(0.5);
  block.columns = block.soil_columns = 12;
  block.walls.base = Wall::roller;
  const StressError error = error_of(block, settled(block, stress_only));
  EXPECT_LT(error.of_largest, 0.0075);
  EXPECT_LT(error.sideways, 0.17);
  EXPECT_LT(error.shear, 1e-6);
}

TEST(SelfWeightColumn, SettlesByTheClosedForm) {
  const Block fine = column(0.25);
  const MaterialPointMethod solid = settled(fine, {.yields = false, .moves = true, .accumulates_strain = true});
  const double expected =
      fine.saturated_density() * gravity * height * height / (2.0 * fine.soil.elastic.constrained_modulus());
  EXPECT_NEAR(expected, 0.06969, 1e-5);
  const double settlement = -*std::min_element(solid.particles().uy.begin(), solid.particles().uy.end());
  EXPECT_TRUE(record("self-weight-settlement", "Self-weight column, 40 cells, settlement (rho g H^2 / 2M = 69.69 mm)",
                     near(1.0e3 * expected, 0.01e3 * expected), 1.0e3 * settlement, "mm"));
}

// The first mode of the column, fixed at the base and free at the top, lasts 4 H / c.
TEST(ElasticColumn, VibratesWithTheWaveSpeed) {
  Block fine = column(0.25);
  fine.settings.gravity = 0.0;
  MaterialPointMethod solid = fine.build();
  const std::vector<double> water = fine.pore_water(solid);
  Particles& p = solid.particles();
  const double wave_number = 0.5 * std::numbers::pi / height;
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.vy[i] = 1e-3 * std::sin(wave_number * p.y[i]);
    p.cyy[i] = 1e-3 * wave_number * std::cos(wave_number * p.y[i]);
  }
  const double dt = solid.stable_step(0.25, water);
  std::vector<double> zeros;  // times at which the top stands still
  double time = 0.0, before = p.vy.back();
  while (zeros.size() < 5) {
    solid.predict(dt, {{}, water}, {}, 0.0);
    solid.advance(dt, {}, stress_only);
    time += dt;
    const double now = p.vy.back();
    if ((now > 0.0) != (before > 0.0)) zeros.push_back(time - dt * now / (now - before));
    before = now;
    ASSERT_LT(time, 5.0);
  }
  const double period = 0.5 * (zeros.back() - zeros.front());
  EXPECT_NEAR(wave_speed(fine), 83.9, 0.05);
  EXPECT_TRUE(record("elastic-wave-speed", "Drained wave speed of Table 2 (83.9 m/s) from a column's period, 40 cells",
                     near(83.9, 0.5), 4.0 * height / period, "m/s"));
}

}  // namespace
}  // namespace slope::solid
