// Disordered particles of a slope at rest with its water: nothing may flow.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "particles.hpp"
#include "slope/seepage/pore_flow.hpp"
#include "slope/seepage/rigid_step.hpp"
#include "slope/testing/record.hpp"

namespace slope::seepage {
namespace {

TEST(Hydrostatic, NothingFlows) {
  const double spacing = 0.25;
  const auto block = testing::lattice(40, 30, spacing, 0.2);
  testing::Particles slope;
  for (std::size_t p = 0; p < block.size(); ++p) {
    if (block.y[p] > 2.0 + 0.7 * block.x[p]) continue;
    slope.x.push_back(block.x[p]);
    slope.y.push_back(block.y[p]);
  }
  slope.volume.assign(slope.x.size(), spacing * spacing);
  slope.porosity.assign(slope.x.size(), 0.35);
  const Water water;
  Soil soil;
  soil.retention = VanGenuchten{.alpha = 0.5, .n = 3.0, .range = {}};
  soil.relative_permeability.law = HillelPower{};
  soil.hydraulic_conductivity = 1.0e-5;
  FlowSettings settings;
  settings.spacing = spacing;
  settings.walls = {.left = 0.0, .right = 10.0, .base = 0.0};
  std::vector<double> pressure;
  for (const double y : slope.y) pressure.push_back(water.unit_weight() * (3.0 - y));
  const Skeleton skeleton = slope.skeleton();
  PoreFlow flow({soil}, water, std::vector<std::uint16_t>(slope.size(), 0), pressure, skeleton, settings);

  std::vector<double> wx(slope.size()), wy(slope.size());
  flow.darcy_velocity(skeleton, wx, wy);
  double fastest = 0.0;
  for (std::size_t p = 0; p < slope.size(); ++p) fastest = std::max(fastest, std::hypot(wx[p], wy[p]));
  EXPECT_TRUE(slope::testing::record("hydrostatic-flux", "Hydrostatic slope, disordered, largest flux over k",
                                     slope::testing::at_most(1.0e-9), fastest / soil.hydraulic_conductivity, ""));

  ASSERT_TRUE(RigidStep().advance(flow, 1.0e7, skeleton, {}, 1.0e-3).converged);
  double largest = 0.0;
  for (std::size_t p = 0; p < slope.size(); ++p)
    largest = std::max(largest, std::abs(flow.pressure()[p] - pressure[p]));
  EXPECT_LT(largest, 1.0e-6) << "Pa, after 116 days";
}

}  // namespace
}  // namespace slope::seepage
