#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <optional>

#include "run/onset.hpp"
#include "run/rest.hpp"

namespace slope::couple {
namespace {

constexpr double growth = 0.02;   // m
constexpr double at_once = 20.0;  // s

/// What the watch finds of u(t) up to an end, and when it was found.
struct Found {
  std::optional<double> kink;
  double seen = 0.0;
};

Found watch(const std::function<double(double)>& u, double end, double step) {
  RunawayWatch watch(growth, at_once);
  for (double t = step; t <= end; t += step) {
    if (watch.observe(t, u(t))) return {watch.time(), t};
  }
  return {};
}

TEST(Runaway, NotOfACreepAtAnEvenRate) {
  for (const double rate : {1e-9, 1e-7, 1e-5, 5e-4}) {
    EXPECT_FALSE(watch([&](double t) { return rate * t; }, 1.0 / rate, 1e-3 / rate).kink) << rate;
  }
}

TEST(Runaway, NotOfASettlementThatFades) {
  EXPECT_FALSE(watch([](double t) { return 0.01 * std::sqrt(t); }, 1000.0, 0.01).kink);
  EXPECT_FALSE(watch([](double t) { return 0.05 * (1.0 - std::exp(-t / 100.0)); }, 1000.0, 0.1).kink);
  EXPECT_FALSE(watch([](double t) { return 0.02 * std::log1p(t); }, 1e5, 1.0).kink) << "creep";
}

TEST(Runaway, NotOfAJumpThatEnds) {
  // a settlement in a storm after a dry time, and what fades after it
  EXPECT_FALSE(
      watch([](double t) { return t < 5000.0 ? 0.0 : 0.03 * (1.0 - std::exp((5000.0 - t) / 100.0)); }, 2e4, 1.0).kink);
}

TEST(Runaway, NotOfEvenSteps) {
  EXPECT_FALSE(watch([](double t) { return 0.01 * std::floor(t / 500.0); }, 20000.0, 1.0).kink);
}

TEST(Runaway, IsAStepLargerThanTheGrowth) {
  const Found found = watch([](double t) { return 0.05 * std::floor(t / 500.0); }, 20000.0, 1.0);
  ASSERT_TRUE(found.kink.has_value());
  EXPECT_NEAR(*found.kink, 500.0, 1.0);
}

TEST(Runaway, IsTheBeginningOfASuddenCollapse) {
  for (const double begin : {0.0, 30.0, 1e5}) {
    const auto u = [&](double t) { return t < begin ? 0.0 : 0.5 * 2.0 * (t - begin) * (t - begin); };
    const Found found = watch(u, begin + 2.0, 0.01);
    ASSERT_TRUE(found.kink.has_value()) << begin;
    EXPECT_NEAR(*found.kink, begin, 0.06) << begin;
    EXPECT_NEAR(found.seen, begin + std::sqrt(growth), 0.06) << begin;
  }
}

TEST(Runaway, IsTheKinkAfterASettlement) {
  // as the slope W2: 1.5 cm in ten minutes by the square root of time, then 3 mm/s
  const auto u = [](double t) {
    return 0.015 * std::sqrt(std::min(t, 600.0) / 600.0) + 0.003 * std::max(0.0, t - 600.0);
  };
  const Found found = watch(u, 700.0, 0.05);
  ASSERT_TRUE(found.kink.has_value());
  EXPECT_NEAR(*found.kink, 600.0, 1.0);
  EXPECT_NEAR(found.seen, 600.0 + growth / 0.003, 1.0);
}

TEST(Runaway, OfASettlementInAStormIsTheSlideThatFollows) {
  // 40 h dry, then 3 cm of settlement that fades within 2 h, then 10 cm/h
  const auto u = [](double hours) {
    const double settled = hours < 40.0 ? 0.0 : 0.03 * (1.0 - std::exp((40.0 - hours) / 0.4));
    return settled + 0.1 * std::max(0.0, hours - 42.0);
  };
  const Found found = watch([&](double t) { return u(t / 3600.0); }, 45.0 * 3600.0, 10.0);
  ASSERT_TRUE(found.kink.has_value());
  EXPECT_NEAR(*found.kink / 3600.0, 42.0, 0.05);
}

TEST(Runaway, OfAnAcceleratingCreepIsFoundBeforeItsEnd) {
  // u = a / (t_f - t) - a / t_f, whose inverse velocity falls to zero at t_f
  const double a = 20.0, end = 1000.0;
  const Found found = watch([&](double t) { return a / (end - t) - a / end; }, 999.0, 0.1);
  ASSERT_TRUE(found.kink.has_value());
  EXPECT_LT(found.seen, 0.9 * end);
  // by the square root of what was left: the chord is as steep as the tangent there
  EXPECT_NEAR(end - *found.kink, std::sqrt((end - found.seen) * end), 0.05 * end);
}

TEST(Runaway, DoesNotDependOnTheStepsOrOnWhatComesLater) {
  const auto u = [](double t) { return 1e-5 * t + 0.002 * std::max(0.0, t - 300.0); };
  const Found fine = watch(u, 1000.0, 0.01), coarse = watch(u, 1000.0, 1.0);
  ASSERT_TRUE(fine.kink && coarse.kink);
  EXPECT_NEAR(*fine.kink, *coarse.kink, 1.0);
  EXPECT_NEAR(fine.seen, coarse.seen, 1.5);
}

TEST(Runaway, NotOfASlopeThatSwingsWhileItCreeps) {
  EXPECT_FALSE(watch([](double t) { return 1e-5 * t + 0.01 * std::abs(std::sin(t)); }, 10000.0, 0.01).kink);
}

/// When a slide that went to u(t), t since its onset, is found to rest.
std::optional<double> found_at_rest(const std::function<double(double)>& u, double end, double own_share = 1.0) {
  RestWatch watch(1.0);
  constexpr double step = 0.01;
  for (double t = 0.0; t <= end; t += step) {
    const std::vector<double> ux{0.0, -u(t)}, uy{0.0, 0.0};
    if (watch.observe(t, own_share * step, u(t) - u(0.0), ux, uy)) return t;
  }
  return std::nullopt;
}

TEST(Rest, IsFoundAfterASlideThatStops) {
  for (const double way : {4.0, 30.0, 100.0}) {
    const auto found = found_at_rest([&](double t) { return 0.02 + 0.01 * std::min(t, way); }, 300.0);
    ASSERT_TRUE(found.has_value()) << way;
    EXPECT_GT(*found, way);
    EXPECT_LE(*found, 2.25 * way + 5.0) << way;
  }
}

TEST(Rest, IsNotWhatCreepsOn) {
  EXPECT_FALSE(found_at_rest([](double t) { return 0.02 + 1e-5 * t; }, 1e4)) << "evenly, however slowly";
  EXPECT_FALSE(found_at_rest([](double t) { return 0.02 + 0.01 * std::log1p(t); }, 1e3)) << "and slower and slower";
}

TEST(Rest, IsNotFoundInTheSoilsOwnBlinkOfAnEye) {
  // the water runs a thousand times ahead of soil that has begun to move
  const auto stops = [](double t) { return 0.02 + 0.01 * std::min(t, 1.0); };
  EXPECT_FALSE(found_at_rest(stops, 100.0, 1e-3));
  EXPECT_TRUE(found_at_rest(stops, 100.0));
}

TEST(Rest, LooksAtAllParticles) {
  RestWatch watch(1.0);
  bool rests = false;
  for (double t = 0.0; t < 100.0; t += 0.01) {
    const std::vector<double> ux{0.5, 0.01 * t}, uy{0.0, 0.0};
    rests = rests || watch.observe(t, 0.01, 0.48, ux, uy);
  }
  EXPECT_FALSE(rests) << "another part of the slope has begun to move";
}

}  // namespace
}  // namespace slope::couple
