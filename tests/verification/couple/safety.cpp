// What the factor of safety of a slope must keep, whatever it is.

#include <gtest/gtest.h>

#include "known_factor.hpp"
#include "run_case.hpp"

namespace slope::testing {
namespace {

// The slope of slope_factor.yaml on coarse cells: a search takes a second or three.
couple::Simulation coarse_slope(std::vector<std::string> overrides = {}) {
  overrides.insert(overrides.begin(), {"domain.cell_size=0.8 m", "safety.tolerance=0.02", "stop.time=0.1 s"});
  couple::Simulation simulation = start_case("slope_factor.yaml", overrides);
  EXPECT_TRUE(simulation.initialise());
  return simulation;
}

couple::FactorOfSafety safety_of(couple::Simulation simulation) {
  EXPECT_TRUE(simulation.find_safety());
  return simulation.summary().safety.back();
}

TEST(Safety, LeavesTheRunAsItIs) {
  couple::Simulation asked = coarse_slope(), other = asked;
  EXPECT_TRUE(asked.find_safety());
  for (couple::Simulation* simulation : {&asked, &other}) {
    while (!simulation->advance().finished) {
    }
  }
  couple::SimulationState state = asked.state();
  EXPECT_EQ(state.progress.result.safety.size(), 1u);
  state.progress.result.safety.clear();
  EXPECT_EQ(state, other.state());
}

TEST(Safety, IsAskedForOnceAtEachOfItsTimes) {
  couple::Simulation simulation = coarse_slope({"safety.times=[0.05 s]", "safety.interval=0.06 s"});
  std::vector<double> times;
  const auto ask = [&] {
    if (!simulation.asks_for_safety()) return;
    times.push_back(simulation.progress().time);
    EXPECT_TRUE(simulation.find_safety());
    EXPECT_FALSE(simulation.asks_for_safety());
    EXPECT_EQ(simulation.summary().safety.back().time, times.back());
  };
  for (ask(); !simulation.advance().finished;) ask();
  EXPECT_EQ(times, (std::vector<double>{0.0, 0.05, 0.06}));
}

TEST(Safety, IsBracketedToTheToleranceAndFoundFromAnywhere) {
  couple::Simulation simulation = coarse_slope({"safety.tolerance=0.01"});
  ASSERT_TRUE(simulation.find_safety());
  ASSERT_TRUE(simulation.find_safety());  // from what the first has found
  const auto found = simulation.summary().safety;
  ASSERT_EQ(found.size(), 2u);
  for (const couple::FactorOfSafety& one : found) {
    ASSERT_TRUE(one.upper);
    EXPECT_GT(one.lower, 1.3);
    EXPECT_LE(*one.upper - one.lower, 0.01 * one.lower);
    EXPECT_EQ(one.factor, 0.5 * (one.lower + *one.upper));
    EXPECT_GT(one.area, 5.0);
    EXPECT_GT(one.depth, 1.0);
  }
  EXPECT_NEAR(found[0].factor, found[1].factor, 0.01 * found[0].factor);
  EXPECT_LT(found[1].trials, found[0].trials);
}

TEST(Safety, OfWeakerSoilIsLessByWhatItIsWeaker) {
  const double whole = safety_of(coarse_slope()).factor;
  // c / 1.7 and tan(25 deg) / 1.7: it falls by itself
  const couple::FactorOfSafety weak = safety_of(
      coarse_slope({"soils.loam.strength.cohesion=2.7588 kPa", "soils.loam.strength.friction_angle=15.338 deg"}));
  EXPECT_NEAR(weak.factor, whole / 1.7, 0.03 * whole / 1.7);
  EXPECT_LT(weak.factor, 1.0);
}

TEST(Safety, OfAPartOfTheSlopeIsNoLess) {
  const auto all = safety_of(coarse_slope({"safety.within=[[0 m, 0 m], [15 m, 0 m], [15 m, 8 m], [0 m, 8 m]]"}));
  const auto crest = safety_of(coarse_slope({"safety.within=[[7 m, 0 m], [15 m, 0 m], [15 m, 8 m], [7 m, 8 m]]"}));
  const auto away = safety_of(coarse_slope({"safety.within=[[0 m, 0 m], [2 m, 0 m], [2 m, 8 m], [0 m, 8 m]]"}));
  EXPECT_NEAR(all.factor, safety_of(coarse_slope()).factor, 1.0e-12);
  EXPECT_GT(crest.factor, 1.05 * all.factor);
  EXPECT_FALSE(away.upper) << "level ground stands with any strength";
  EXPECT_EQ(away.factor, 20.0);
  EXPECT_EQ(away.area, 0.0);
}

TEST(Safety, UnderWaterAloneIsThatOfTheSlopeAtRest) {
  const couple::FactorOfSafety coupled = safety_of(coarse_slope());
  const couple::FactorOfSafety alone =
      safety_of(coarse_slope({"coupling={scheme: seepage, mixture_density: saturated}"}));
  EXPECT_NEAR(alone.factor, coupled.factor, 0.02 * coupled.factor);
}

TEST(Safety, StopsWhenToldTo) {
  couple::Simulation simulation = coarse_slope();
  std::string search, stage;
  EXPECT_FALSE(simulation.find_safety([&](const couple::InitialProgress& progress) {
    search = progress.search, stage = progress.stage;
    return false;
  }));
  EXPECT_EQ(search, "factor of safety");
  EXPECT_EQ(stage, "strength over 1");
  EXPECT_TRUE(simulation.summary().safety.empty());
}

}  // namespace
}  // namespace slope::testing
