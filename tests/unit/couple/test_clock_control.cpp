#include <gtest/gtest.h>

#include "clock_control.hpp"

namespace slope::couple {
namespace {

const SlopeScale scale{.height = 10.0, .wave_speed = 80.0, .overburden = 2.0e5, .gravity = 9.81};  // first period 0.5 s

TEST(ClockControl, KeepsRealTimeWhateverIsDue) {
  Clock limits;
  limits.adaptive = false;
  ClockControl clock(limits, scale, {});
  double time = 0.0;
  for (const double next : {0.01, 0.0115, 0.5}) {
    while (time < next - 1e-12) {
      const auto pace = clock.pace(time, next, 0.003);
      EXPECT_EQ(pace.factor, 1.0);
      EXPECT_GT(pace.time_step, 0.0);
      EXPECT_LE(pace.time_step, 0.003);
      time += pace.factor * pace.time_step;
      EXPECT_LE(time, next * (1.0 + 1e-12));
    }
    EXPECT_NEAR(time, next, 1e-12);
  }
}

TEST(ClockControl, RunsFasterInTheCalmAndFallsBackAfterAChange) {
  ClockControl clock(Clock{}, scale, {0.0, 100.0});
  const std::vector<double> still(3, 0.0);
  double time = 0.0;
  const auto run_to = [&](double end) {
    ClockControl::Pace pace;
    while (time < end - 1e-9) {
      pace = clock.pace(time, end, 0.003);
      clock.observe(pace.time_step, still, still, still);
      time += pace.factor * pace.time_step;
    }
    return pace;
  };
  EXPECT_GT(run_to(100.0).factor, 10.0);
  const auto after = clock.pace(100.0, 200.0, 0.003);
  EXPECT_NEAR(after.factor, 1.0, 0.01);
  EXPECT_LT(after.velocity_scale, 0.1) << "the soil's velocities fall with the factor";
}

}  // namespace
}  // namespace slope::couple
