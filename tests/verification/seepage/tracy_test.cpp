// Tracy (2006), Water Resour. Res. 42, W08404: transient infiltration into a dry square of exponential soil through its
// top; the order of convergence of the head operator with faces all round.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "particles.hpp"
#include "slope/seepage/pore_flow.hpp"
#include "slope/seepage/rigid_step.hpp"
#include "slope/testing/record.hpp"
#include "slope/testing/table.hpp"

namespace slope::seepage {
namespace {

using slope::testing::at_least;
using slope::testing::record;

constexpr double alpha = 0.164, dry = -15.24, side = 15.24;
constexpr double conductivity = 1.0e-5, porosity = 0.45, residual = 1.0 / 3.0;
constexpr double steady = 1.0e9;

double exact_head(double x, double y, double time) {
  using std::numbers::pi;
  const double width = std::sqrt(alpha * alpha / 4.0 + pi * pi / (side * side));
  const double capacity = alpha * porosity * (1.0 - residual) / conductivity;
  double sum = 0.0;
  for (int k = 1; k < 400; ++k) {
    const double lambda = k * pi / side;
    const double gamma = (width * width + lambda * lambda) / capacity;
    sum += (k % 2 == 1 ? -1.0 : 1.0) * lambda / gamma * std::sin(lambda * y) * std::exp(-gamma * time);
  }
  const double driest = std::exp(alpha * dry);
  const double shape = std::sinh(width * y) / std::sinh(width * side) + 2.0 / (side * capacity) * sum;
  return std::log(driest + (1.0 - driest) * std::sin(pi * x / side) * std::exp(0.5 * alpha * (side - y)) * shape) /
         alpha;
}

double head_at_top(double x) {
  const double driest = std::exp(alpha * dry);
  return std::log(driest + (1.0 - driest) * std::sin(std::numbers::pi * x / side)) / alpha;
}

// Root mean square error of the head (m) on cells x cells particles, displaced by up to `jitter` spacings.
double error(int cells, double jitter, double time) {
  const double spacing = side / cells;
  const Water water{.density = 1000.0, .bulk_modulus = 2.0e12, .gravity = 9.81};  // incompressible, as in the solution
  auto square = testing::lattice(cells, cells, spacing, jitter);
  std::fill(square.porosity.begin(), square.porosity.end(), porosity);
  Boundary boundary;
  boundary.count = 1;
  for (int row = 0; row < cells; ++row) {
    for (int column = 0; column < cells; ++column) {
      const auto p = static_cast<std::uint32_t>(row * cells + column);
      const double x = square.x[p], y = square.y[p];
      const auto face = [&](double head, double rise, double distance) {
        boundary.faces.push_back({p, 0, water.unit_weight() * head, rise, distance, spacing});
      };
      if (column == 0) face(dry, 0.0, x);
      if (column == cells - 1) face(dry, 0.0, side - x);
      if (row == 0) face(dry, -y, y);
      if (row == cells - 1) face(head_at_top(x), side - y, side - y);
    }
  }
  Soil soil;
  soil.retention = ExponentialRetention{.alpha = alpha, .range = {residual, 1.0}};
  soil.relative_permeability.law = ExponentialPermeability{.alpha = alpha};
  soil.hydraulic_conductivity = conductivity;
  FlowSettings settings;
  settings.spacing = spacing;
  const std::vector<double> start(square.size(), water.unit_weight() * dry);
  const Skeleton skeleton = square.skeleton();
  PoreFlow flow({soil}, water, std::vector<std::uint16_t>(square.size(), 0), start, skeleton, settings);
  RigidStep water_step;
  const auto advance = [&](double time_step) {
    EXPECT_TRUE(water_step.advance(flow, time_step, skeleton, boundary, 1.0).converged);
  };
  if (time == steady) {
    for (double time_step = 2.0e5; time_step < 1.0e9; time_step *= 1.6) advance(time_step);
  } else {
    const int steps = cells * cells / 36;  // so that the error in time shrinks as that in space
    for (int step = 0; step < steps; ++step) advance(time / steps);
  }
  double squares = 0.0;
  for (std::size_t p = 0; p < square.size(); ++p) {
    squares += std::pow(flow.pressure()[p] / water.unit_weight() - exact_head(square.x[p], square.y[p], time), 2);
  }
  return std::sqrt(squares / static_cast<double>(square.size()));
}

TEST(Tracy, TheClosedFormIsThatOfTheReference) {
  const auto table = slope::testing::reference("tracy/tracy2d_head.csv");
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double x = table.column("x_m")[row], y = table.column("y_m")[row], time = table.column("t_s")[row];
    EXPECT_NEAR(exact_head(x, y, time), table.column("head_m")[row], 2e-6 * side) << x << " m, " << y << " m, " << time;
  }
}

TEST(Tracy, ConvergesOnALattice) {
  const double order = std::log2(error(16, 0.0, steady) / error(64, 0.0, steady)) / 2.0;
  EXPECT_TRUE(record("tracy-lattice-steady", "Tracy 2-D, steady, order of convergence on a lattice, 16 to 64 particles",
                     at_least(1.8), order, ""));
}

TEST(Tracy, ConvergesOnALatticeInTime) {
  const double order = std::log2(error(12, 0.0, 86400.0) / error(48, 0.0, 86400.0)) / 2.0;
  EXPECT_TRUE(record("tracy-lattice-transient",
                     "Tracy 2-D, after a day, order of convergence on a lattice, 12 to 48 particles", at_least(1.8),
                     order, ""));
}

TEST(Tracy, ConvergesAmongDisorder) {
  const double order = std::log2(error(16, 0.1, steady) / error(64, 0.1, steady)) / 2.0;
  EXPECT_TRUE(record("tracy-jittered-steady",
                     "Tracy 2-D, steady, order of convergence, displaced by 10 % of the spacing, 16 to 64 particles",
                     at_least(1.0), order, ""));
}

}  // namespace
}  // namespace slope::seepage
