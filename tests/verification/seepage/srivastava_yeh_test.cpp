// Srivastava and Yeh (1991): rain steps up from 0.1 to 0.9 cm/h on a column of exponential soil above a water table.

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "column.hpp"
#include "slope/testing/record.hpp"
#include "slope/testing/table.hpp"

namespace slope::seepage {
namespace {

TEST(SrivastavaYeh, PressureHeadFollowsTheSeries) {
  const auto exact = slope::testing::reference("srivastava_yeh/srivastava_yeh_psi.csv");
  const auto curve = [&](const char* name) { return slope::testing::Curve{exact.column("z_m"), exact.column(name)}; };
  const testing::Column column(1.0, 50);
  const Water water;
  Soil soil;
  soil.retention = ExponentialRetention{.alpha = 10.0, .range = {0.15, 1.0}};  // 0.06 of 0.40
  soil.relative_permeability.law = ExponentialPermeability{.alpha = 10.0};
  soil.hydraulic_conductivity = 0.01 / 3600.0;
  std::vector<double> start;
  for (const double y : column.particles.y) {
    start.push_back(water.unit_weight() * slope::testing::interpolate(curve("psi_t0"), y));
  }
  const Skeleton skeleton = column.particles.skeleton();
  PoreFlow flow({soil}, water, column.soil(), start, skeleton, column.settings());
  Boundary boundary = column.held_face(false);
  boundary.count = 2;
  for (std::uint32_t i = 0; i < column.columns; ++i) {
    boundary.inflows.push_back({column.top(i), 1, 0.009 / 3600.0 * column.spacing});
  }

  const auto dry = *std::ranges::min_element(exact.column("psi_t0"));
  testing::Stepper stepper(60.0, 60.0);
  double worst = 0.0;
  for (const auto& [hours, name] : {std::pair{1, "psi_t1h"},
                                    {3, "psi_t3h"},
                                    {5, "psi_t5h"},
                                    {10, "psi_t10h"},
                                    {20, "psi_t20h"},
                                    {30, "psi_t30h"},
                                    {50, "psi_t50h"}}) {
    ASSERT_TRUE(stepper.advance(flow, skeleton, boundary, 3600.0 * hours, 0.01));
    const auto head = column.profile(flow.pressure(), 1.0 / water.unit_weight());
    worst = std::max(worst, slope::testing::max_error(head, curve(name)) / -dry);
  }
  EXPECT_TRUE(slope::testing::record("srivastava-yeh",
                                     "Srivastava-Yeh, pressure head, 50 particles high, all times, of the head's range",
                                     slope::testing::at_most(0.01), worst, "%"));
}

}  // namespace
}  // namespace slope::seepage
