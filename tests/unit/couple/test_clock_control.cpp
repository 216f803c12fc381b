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

TEST(ClockControl, IsAsSlowAsAPrescribedPressureIsFast) {
  ClockControl clock(Clock{}, scale, {0.0});
  const std::vector<double> still(3, 0.0);
  double time = 0.0;
  for (ClockControl::Pace pace; time < 1000.0; time += pace.factor * pace.time_step) {
    pace = clock.pace(time, 1000.0, 0.003);
    clock.observe(pace.time_step, still, still, still);
  }
  const double calm = 1.3 * 0.004 * scale.overburden / (0.05 * scale.period());  // Pa per second of the soil
  EXPECT_GT(clock.pace(time, 1e6, 0.003, calm / 1e4).factor, 100.0) << "a slow one does not matter";
  EXPECT_NEAR(clock.pace(time, 1e6, 0.003, calm / 10.0).factor, 10.0, 0.01);
  EXPECT_NEAR(clock.pace(time, 1e6, 0.003, 10.0 * calm).factor, 1.0, 0.01);
}

}  // namespace
}  // namespace slope::couple
