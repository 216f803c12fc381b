// Drainage of the sand column of Liakopoulos (paper, section 3) with a skeleton that does not move.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "column.hpp"
#include "slope/testing/record.hpp"
#include "slope/testing/table.hpp"

namespace slope::seepage {
namespace {

TEST(LiakopoulosRigid, SuctionAndOutflowFollowTheReference) {
  const auto profiles = slope::testing::reference("liakopoulos/liakopoulos_ref_rigid_profiles.csv");
  const auto history = slope::testing::reference("liakopoulos/liakopoulos_ref_history.csv");
  const slope::testing::Curve lost{history.column("t_s"), history.column("cum_outflow_m_rigid")};
  const testing::Column column(1.0, 50);
  const Water water;
  Soil sand;
  sand.retention = LiakopoulosRetention{};
  sand.relative_permeability.law = LiakopoulosPermeability{};
  sand.hydraulic_conductivity = 4.41e-6;
  auto particles = column.particles;
  std::fill(particles.porosity.begin(), particles.porosity.end(), 0.2975);
  const Skeleton skeleton = particles.skeleton();
  PoreFlow flow({sand}, water, column.soil(), std::vector<double>(particles.size(), 0.0), skeleton, column.settings());
  const Boundary boundary = column.held_face(false);

  testing::Stepper stepper(1.0e-3, 5.0);
  double early = 0.0, late = 0.0, outflow = 0.0;
  for (const int time : {60, 120, 300, 600, 1200, 1800, 3600, 7200}) {
    ASSERT_TRUE(stepper.advance(flow, skeleton, boundary, time, 0.01));
    const auto suction = column.profile(flow.suction(), 1.0 / water.unit_weight());
    const slope::testing::Curve exact{profiles.column("z_m"),
                                      profiles.column("suction_head_m_t" + std::to_string(time))};
    double& worst = time <= 300 ? early : late;
    worst = std::max(worst, slope::testing::max_relative_error(suction, exact));
    if (time >= 300) {
      const double expected = slope::testing::interpolate(lost, time);
      outflow = std::max(outflow, std::abs(-flow.cumulative_inflow()[0] / column.width() / expected - 1.0));
    }
  }
  using slope::testing::at_most;
  using slope::testing::record;
  EXPECT_TRUE(record("liakopoulos-rigid-suction-early",
                     "Liakopoulos, seepage alone, suction head up to 300 s, 50 particles high", at_most(0.03), early,
                     "%"));
  EXPECT_TRUE(record("liakopoulos-rigid-suction",
                     "Liakopoulos, seepage alone, suction head from 600 s, 50 particles high", at_most(0.02), late,
                     "%"));
  EXPECT_TRUE(record("liakopoulos-rigid-outflow",
                     "Liakopoulos, seepage alone, cumulative outflow from 300 s, 50 particles high", at_most(0.02),
                     outflow, "%"));
}

}  // namespace
}  // namespace slope::seepage
