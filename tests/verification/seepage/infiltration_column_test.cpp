// Rain on a rigid column of the paper's soil W2, 8 m high with the water table 5 m below its surface, which is kept at
// zero pressure.

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "column.hpp"
#include "slope/testing/record.hpp"
#include "slope/testing/table.hpp"

namespace slope::seepage {
namespace {

TEST(InfiltrationColumn, PressureFollowsTheReference) {
  const double height = 8.0;
  const auto table = slope::testing::reference("infiltration_w2/infiltration_profiles_W2_D5.csv");
  const testing::Column column(height, 160);
  const Water water;
  Soil soil;
  soil.retention = VanGenuchten{.alpha = 0.05, .n = 3.0, .range = {}};
  soil.relative_permeability.law = HillelPower{.exponent = 2.0};
  soil.hydraulic_conductivity = 1.0e-5;
  std::vector<double> start;
  for (const double y : column.particles.y) start.push_back(water.unit_weight() * (3.0 - y));
  auto particles = column.particles;
  std::fill(particles.porosity.begin(), particles.porosity.end(), 0.35);
  const Skeleton skeleton = particles.skeleton();
  PoreFlow flow({soil}, water, column.soil(), start, skeleton, column.settings());
  const Boundary boundary = column.held_face(true);

  testing::Stepper stepper(1.0e-4, 0.1);
  double worst = 0.0;
  for (const auto& [time, name] : {std::pair{3.0, "p_kPa_t3_rigid"},
                                   {10.0, "p_kPa_t10_rigid"},
                                   {30.0, "p_kPa_t30_rigid"},
                                   {60.0, "p_kPa_t60_rigid"},
                                   {90.0, "p_kPa_t90_rigid"}}) {
    ASSERT_TRUE(stepper.advance(flow, skeleton, boundary, time));
    const auto pressure = column.profile(flow.pressure(), 1.0e-3);
    slope::testing::Curve exact{table.column("depth_m"), table.column(name)};
    for (double& depth : exact.x) depth = height - depth;
    std::ranges::reverse(exact.x);
    std::ranges::reverse(exact.y);
    worst = std::max(worst, slope::testing::max_relative_error(pressure, exact));
  }
  EXPECT_TRUE(slope::testing::record("infiltration-w2-rigid",
                                     "Infiltration into W2, rigid, pressure, 160 particles high, 3 to 90 s",
                                     slope::testing::at_most(0.02), worst, "%"));
  EXPECT_NEAR(flow.unexplained_water(), 0.0, 1e-6 * flow.cumulative_inflow()[0]);
}

}  // namespace
}  // namespace slope::seepage
