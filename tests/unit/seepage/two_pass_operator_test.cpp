#include "slope/seepage/two_pass_operator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "particles.hpp"
#include "slope/seepage/explicit_step.hpp"
#include "slope/seepage/rigid_step.hpp"

namespace slope::seepage {
namespace {

using testing::lattice;

TEST(TwoPassOperator, AUniformGradientGivesDarcysVelocityInside) {
  const auto block = lattice(12, 12, 0.5);
  TwoPassOperator op(0.5, 1.2, {});
  op.update(block.skeleton());
  std::vector<double> head(block.size()), wx(block.size()), wy(block.size()), div(block.size());
  for (std::size_t p = 0; p < block.size(); ++p) head[p] = 0.3 * block.x[p] - 2.0 * block.y[p];
  op.darcy_velocity(head, std::vector<double>(block.size(), 1.0e-5), wx, wy);
  for (std::size_t p = 0; p < block.size(); ++p) {
    if (std::min({block.x[p], block.y[p], 6.0 - block.x[p], 6.0 - block.y[p]}) < 1.0) continue;
    EXPECT_NEAR(wx[p], -0.3e-5, 1e-18);
    EXPECT_NEAR(wy[p], 2.0e-5, 1e-18);
  }
  op.divergence(block.x, block.y, div);
  EXPECT_NEAR(div[6 * 12 + 6], 2.0, 1e-12);
}

TEST(TwoPassOperator, NothingFlowsThroughAWall) {
  const auto block = lattice(8, 8, 1.0);
  TwoPassOperator op(1.0, 1.2, {.left = 0.0, .right = 8.0});
  op.update(block.skeleton());
  std::vector<double> wx(block.size()), wy(block.size()), div(block.size());
  op.darcy_velocity(block.y, std::vector<double>(block.size(), 1.0), wx, wy);
  op.divergence(wx, wy, div);
  for (std::size_t p = 0; p < block.size(); ++p) {
    EXPECT_NEAR(wx[p], 0.0, 1e-13);
    const double depth = std::min(block.y[p], 8.0 - block.y[p]);
    if (depth > 2.0) {
      EXPECT_NEAR(wy[p], -1.0, 1e-13);
    }
    if (depth > 4.0) {
      EXPECT_NEAR(div[p], 0.0, 1e-13);
    }
  }
}

TEST(TwoPassOperator, DoesNotSeeACheckerboard) {
  const auto block = lattice(10, 10, 1.0);
  std::vector<double> head(block.size()), wx(block.size()), wy(block.size()), div(block.size()), out(block.size());
  for (std::size_t p = 0; p < block.size(); ++p) head[p] = (p % 10 + p / 10) % 2 == 0 ? 1.0 : -1.0;
  TwoPassOperator op(1.0, 1.2, {0.0, 10.0, 0.0, 10.0});
  op.update(block.skeleton());
  const std::vector<double> unit(block.size(), 1.0);
  op.darcy_velocity(head, unit, wx, wy);
  op.divergence(wx, wy, div);
  HeadOperator pairwise(1.0, 1.2, {0.0, 10.0, 0.0, 10.0}, 1);
  pairwise.update(block.skeleton());
  pairwise.set_conductivity(unit);
  pairwise.apply(head, out);
  const std::size_t centre = 55;
  EXPECT_NEAR(div[centre], 0.0, 1e-12);
  EXPECT_GT(std::abs(out[centre]), 1.0) << "the head operator does";
}

// Largest disturbance of the pressure in a closed box after some time, over the first one. The time and its step are in
// those of explicit_step().
double left_over(double jitter, double time_step, double duration) {
  const int side = 8;
  const double spacing = 0.1, size = side * spacing, disturbance = 100.0;
  const auto box = lattice(side, side, spacing, jitter);
  Soil soil;
  soil.retention = VanGenuchten{.alpha = 0.05, .n = 3.0, .range = {}};
  soil.relative_permeability.law = HillelPower{};
  soil.hydraulic_conductivity = 1.0e-5;
  FlowSettings settings;
  settings.spacing = spacing;
  settings.walls = {0.0, size, 0.0, size};
  const Water water;
  const auto at_rest = [&](std::size_t p) { return 1.0e6 - water.unit_weight() * box.y[p]; };
  std::vector<double> pressure(box.size());
  for (std::size_t p = 0; p < box.size(); ++p) {
    pressure[p] = at_rest(p) + disturbance * std::cos(std::numbers::pi * box.y[p] / size);
  }
  const std::vector<std::uint16_t> soils(box.size(), 0);
  PoreFlow flow({soil}, water, soils, pressure, box.skeleton(), settings);
  ExplicitStep step;
  const std::vector<double> still(box.size(), 0.0);
  const double unit = ExplicitStep::stable_step(flow, box.skeleton());
  for (double t = 0.0; t < duration; t += time_step) {
    step.advance(flow, time_step * unit, box.skeleton(), still, still, {});
  }
  double largest = 0.0;
  for (std::size_t p = 0; p < box.size(); ++p) {
    largest = std::max(largest, std::abs(flow.pressure()[p] - at_rest(p)) / disturbance);
  }
  return largest;
}

TEST(TwoPassOperator, GrowsOnDisorderedParticlesWhateverTheStep) {
  EXPECT_LT(left_over(0.0, 0.4, 200.0), 1.0e-6) << "a lattice calms down";
  for (const double time_step : {0.4, 0.1}) {
    EXPECT_GT(left_over(0.2, time_step, 200.0), 10.0 * left_over(0.2, time_step, 50.0)) << time_step;
  }
}

// A wave of pressure dies away in a closed, saturated column: rate K / (gamma_w storage) (pi / height)^2.
TEST(TwoPassOperator, AShortRunAgreesWithTheHeadOperatorAndTheExactSolution) {
  const int rows = 40;
  const double height = 1.0, spacing = height / rows;
  const MirrorWalls walls{0.0, 3.0 * spacing, 0.0, height};
  const auto column = lattice(3, rows, spacing);
  Water water;
  water.bulk_modulus = 1.0e6;
  const double conductivity = 1.0e-5, porosity = 0.4;
  const double storage = porosity / water.bulk_modulus;
  std::vector<double> start(column.size());
  for (std::size_t p = 0; p < column.size(); ++p) {
    start[p] = 1.0e5 - water.unit_weight() * column.y[p] + 1000.0 * std::cos(std::numbers::pi * column.y[p] / height);
  }
  const double time_step = 0.02;
  const int steps = 500;

  Soil soil;
  soil.retention = VanGenuchten{.alpha = 0.05, .n = 3.0, .range = {}};
  soil.relative_permeability.law = HillelPower{};
  soil.hydraulic_conductivity = conductivity;
  FlowSettings settings;
  settings.spacing = spacing;
  settings.walls = walls;
  const std::vector<std::uint16_t> soils(column.size(), 0);
  PoreFlow two_pass({soil}, water, soils, start, column.skeleton(), settings);
  ExplicitStep explicit_step;
  const std::vector<double> still(column.size(), 0.0);
  for (int step = 0; step < steps; ++step) {
    explicit_step.advance(two_pass, time_step, column.skeleton(), still, still, {});
  }
  PoreFlow flow({soil}, water, soils, start, column.skeleton(), settings);
  RigidStep rigid_step;
  for (int step = 0; step < 50; ++step) {
    ASSERT_TRUE(rigid_step.advance(flow, 10.0 * time_step, column.skeleton(), {}, 1.0e-4).converged);
  }

  const double rate = conductivity / (water.unit_weight() * storage) * std::pow(std::numbers::pi / height, 2);
  const double left = 1000.0 * std::exp(-rate * time_step * steps);
  EXPECT_LT(left, 800.0);
  for (std::size_t p = 0; p < column.size(); ++p) {
    const double exact =
        1.0e5 - water.unit_weight() * column.y[p] + left * std::cos(std::numbers::pi * column.y[p] / height);
    EXPECT_NEAR(two_pass.pressure()[p], exact, 0.01 * 1000.0);
    EXPECT_NEAR(flow.pressure()[p], exact, 0.01 * 1000.0);
  }
}

}  // namespace
}  // namespace slope::seepage
