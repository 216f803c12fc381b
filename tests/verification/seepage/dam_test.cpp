// Steady seepage through a rectangular dam with a free surface and an exit face above the tail water. Its discharge is
// exactly K (h1^2 - h2^2) / 2 L (Charny 1951), whatever the shape of the water table, where no water flows above that.
// By the same argument, with the integral of the conductivity over the pressure in place of the pressure, the capillary
// fringe of an exponential soil adds K (h1 - exit height) / (alpha L): 1.4 % in one of a centimetre (a coarse
// sand), 6.6 % in one of five.

#include <gtest/gtest.h>

#include <cmath>

#include "column.hpp"
#include "slope/seepage/free_surface.hpp"
#include "slope/testing/record.hpp"

namespace slope::seepage {
namespace {

struct Dam {
  static constexpr double length = 1.5, height = 1.2, upstream = 1.0, downstream = 0.2, conductivity = 1.0e-3;

  double discharge = 0.0, inflow = 0.0, exit_height = 0.0;
  AirFlow air;

  // alpha: of the exponential soil (1/m)
  Dam(int rows, double alpha) {
    const double spacing = height / rows;
    auto particles = testing::lattice(static_cast<int>(std::lround(length / spacing)), rows, spacing);
    const Skeleton skeleton = particles.skeleton();
    const MirrorWalls walls{.base = 0.0};
    const Water water;
    Soil soil;
    soil.retention = ExponentialRetention{.alpha = alpha, .range = {0.1, 1.0}};
    soil.relative_permeability.law = ExponentialPermeability{.alpha = alpha};
    soil.hydraulic_conductivity = conductivity;
    FlowSettings settings;
    settings.spacing = spacing;
    settings.walls = walls;
    std::vector<double> start;
    for (const double y : particles.y) start.push_back(water.unit_weight() * (upstream - y));
    PoreFlow flow({soil}, water, std::vector<std::uint16_t>(particles.size(), 0), start, skeleton, settings);
    RigidStep steady;

    Boundary boundary;
    boundary.count = 3;
    FreeSurface surface(spacing, walls);
    surface.update(skeleton);
    const double half = 0.5 * spacing;
    for (const SurfacePiece& piece : surface.pieces()) {
      const std::uint32_t p = piece.particle;
      const bool left = particles.x[p]<spacing, right = particles.x[p]> length - spacing;
      const double level = left ? upstream : right ? downstream : 0.0;
      if (particles.y[p] < level) {
        const double pressure = water.unit_weight() * (level - particles.y[p]);
        boundary.faces.push_back({p, left ? 0U : 1U, pressure, 0.0, half, spacing});
      } else {
        OpenFace face{.particle = p, .boundary = 2};
        face.rise = half * piece.ny;
        face.distance = half;
        face.area = piece.area;
        boundary.open_faces.push_back(face);
      }
    }
    double step = 1.0;
    for (int k = 0; k < 400 && step < 1.0e9; ++k) {
      const SolveReport report = steady.advance(flow, step, skeleton, boundary, 0.01);
      step *= report.converged ? 2.0 : 0.25;
    }
    EXPECT_GE(step, 1.0e9);
    inflow = flow.inflow_rate()[0];
    air = flow.air_flow();
    discharge = air.seepage - flow.inflow_rate()[1];
    for (const OpenFace& face : boundary.open_faces) {
      const double y = particles.y[face.particle];
      if (flow.pressure()[face.particle] > 0.0) exit_height = std::max(exit_height, y + half);
    }
  }

  [[nodiscard]] double without_fringe(double alpha) const {
    return discharge - conductivity * (upstream - exit_height) / (alpha * length);
  }
  static constexpr double exact = conductivity * (upstream * upstream - downstream * downstream) / (2.0 * length);
};

void expect_sound(const Dam& dam) {
  EXPECT_NEAR(dam.inflow, dam.discharge, 1.0e-6 * dam.inflow);
  EXPECT_GT(dam.air.seepage, 0.1 * dam.discharge) << "an exit face is there";
  EXPECT_GT(dam.exit_height, Dam::downstream + 0.05);
  EXPECT_EQ(dam.air.infiltration, 0.0) << "air is not sucked in as water";
}

TEST(Dam, DischargesWhatCharnySays) {
  const Dam dam(48, 100.0);
  expect_sound(dam);
  EXPECT_TRUE(
      slope::testing::record("dam-exit-face",
                             "Dam with an exit face, 48 particles high, capillary fringe of 1 cm: discharge, off "
                             "K (h1^2 - h2^2) / 2L",
                             slope::testing::at_most(0.02), std::abs(dam.discharge / Dam::exact - 1.0), "%"));
}

TEST(Dam, ConductsInItsFringeToo) {
  const double alpha = 20.0;
  const Dam dam(48, alpha);
  expect_sound(dam);
  EXPECT_GT(dam.discharge, 1.05 * Dam::exact);
  EXPECT_TRUE(slope::testing::record("dam-fringe", "- with a fringe of 5 cm, whose flow is known too and taken off",
                                     slope::testing::at_most(0.02),
                                     std::abs(dam.without_fringe(alpha) / Dam::exact - 1.0), "%"));
}

}  // namespace
}  // namespace slope::seepage
