#include <gtest/gtest.h>

#include "run/clock_control.hpp"

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

// Steps from a time to another; the soil leaves `unbalanced` of its weight out of balance at a clock factor.
template <class Unbalanced>
ClockControl::Pace run(ClockControl& clock, double time, double end, const Unbalanced& unbalanced) {
  const std::vector<double> still(3, 0.0);
  ClockControl::Pace pace;
  for (; time < end * (1.0 - 1e-9); time += pace.factor * pace.time_step) {
    pace = clock.pace(time, end, 0.003);
    clock.observe(pace.time_step, unbalanced(pace.factor), still, still);
  }
  return pace;
}

double nothing(double /*factor*/) {
  return 0.0;
}

TEST(ClockControl, RunsFasterInTheCalmAndFallsBackAfterAChange) {
  ClockControl clock(Clock{}, scale, {0.0, 100.0});
  EXPECT_GT(run(clock, 0.0, 100.0, nothing).factor, 10.0);
  const auto after = clock.pace(100.0, 200.0, 0.003);
  EXPECT_NEAR(after.factor, 1.0, 0.01);
  EXPECT_LT(after.velocity_scale, 0.1) << "the soil's velocities fall with the factor";
}

TEST(ClockControl, HasNoCeilingOfItsOwn) {
  ClockControl clock(Clock{}, scale, {0.0});
  EXPECT_GT(run(clock, 0.0, 1.0e7, nothing).factor, 1.0e5);
}

// Inertia over the weight is Theta^2 times an acceleration over g: the factor finds the Theta at which it is the limit.
TEST(ClockControl, KeepsUnbalancedForcesNearTheirLimit) {
  for (const double limit : {1.0e-5, 1.0e-4, 1.0e-3}) {
    Clock limits;
    limits.unbalanced_limit = limit;
    ClockControl clock(limits, scale, {0.0});
    const double acceleration = 1.0e-10;  // over g, in physical time
    const auto pace = run(clock, 0.0, 1.0e6, [&](double factor) { return factor * factor * acceleration; });
    const double unbalanced = pace.factor * pace.factor * acceleration;
    EXPECT_GT(unbalanced, 0.5 * limit);
    EXPECT_LT(unbalanced, 1.6 * limit);
    EXPECT_LT(clock.largest_unbalanced_ratio(), 1.7 * limit);
  }
}

// What may be out of balance is a share of what the water has done: twice the water, twice the limit.
TEST(ClockControl, AllowsMoreAfterMoreWater) {
  const std::vector<double> start{0.0, -1.0e4, 1.0e4, 0.0};
  const auto limit_after = [&](std::vector<double> changes) {
    ClockControl clock(Clock{}, scale, {0.0});
    const auto observe = [&](std::span<const double> pressure) {
      for (int k = 0; k < 20; ++k) clock.observe(0.003, 0.0, start, pressure);
    };
    observe(start);
    for (std::size_t p = 0; p < start.size(); ++p) changes[p] = start[p] + changes[p] * scale.overburden;
    observe(changes);
    observe(start);
    return clock.unbalanced_limit();
  };
  const double least = Clock{}.unbalanced_limit;
  EXPECT_EQ(limit_after({0.0, 0.0, 0.0, 0.0}), least);
  EXPECT_EQ(limit_after({0.009, -0.009, 0.009, -0.009}), least) << "a hundredth is little";
  EXPECT_NEAR(limit_after({0.05, -0.05, 0.05, -0.05}), 5.0 * least, 1e-12) << "wetter or drier, then and after";
  EXPECT_NEAR(limit_after({0.4, 0.0, 0.0, 0.0}), 10.0 * least, 1e-12) << "in the mean";
}

TEST(ClockControl, FallsToRealTimeWhenTheSoilLetsGo) {
  ClockControl clock(Clock{}, scale, {0.0});
  run(clock, 0.0, 1000.0, nothing);
  EXPECT_EQ(clock.largest_unbalanced_ratio(), 0.0);
  const auto falls = [](double) { return 0.1; };
  EXPECT_EQ(run(clock, 1000.0, 3000.0, falls).factor, 1.0);
  EXPECT_NEAR(clock.largest_unbalanced_ratio(), 0.1, 1e-12);
}

TEST(ClockControl, DoesNotBlameTheClockForWhatRealTimeDoes) {
  Clock limits;
  limits.adaptive = false;
  ClockControl clock(limits, scale, {0.0});
  run(clock, 0.0, 1.0, [](double) { return 0.1; });
  EXPECT_EQ(clock.largest_unbalanced_ratio(), 0.0);
}

TEST(ClockControl, IsAsSlowAsAPrescribedPressureIsFast) {
  ClockControl clock(Clock{}, scale, {0.0});
  run(clock, 0.0, 1000.0, nothing);
  const double calm = 0.005 * scale.overburden / (0.05 * scale.period());  // Pa per second of the soil
  EXPECT_GT(clock.pace(1000.0, 1e6, 0.003, calm / 1e4).factor, 100.0) << "a slow one does not matter";
  EXPECT_NEAR(clock.pace(1000.0, 1e6, 0.003, calm / 10.0).factor, 10.0, 0.01);
  EXPECT_NEAR(clock.pace(1000.0, 1e6, 0.003, 10.0 * calm).factor, 1.0, 0.01);
}

}  // namespace
}  // namespace slope::couple
