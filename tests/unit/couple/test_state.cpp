// A copy of a running simulation, and one made from its state, are running simulations: to the last bit.

#include <gtest/gtest.h>

#include <cmath>

#include "slope/couple/read_case.hpp"
#include "slope/couple/simulation.hpp"

namespace slope::couple {
namespace {

/// The smallest slope with what a kind of run remembers.
struct Kind {
  const char* name;
  std::vector<std::string> changes;
};

class State : public testing::TestWithParam<Kind> {};

Case case_of(std::vector<std::string> changes) {
  changes.insert(changes.begin(), {"domain.cell_size=1 m", "output.history_interval=0.25 s", "stop.time=2 s",
                                   "failure.onset_displacement=0.1 mm"});
  return read_case(std::string(SLOPE_CASES) + "/quick.yaml", changes);
}

using Rows = std::vector<std::vector<double>>;

/// To the end. @return the rows of history and budget
Rows finish(Simulation& simulation) {
  Rows rows;
  for (Event event; !event.finished;) {
    event = simulation.advance();
    if (!event.history) continue;
    rows.push_back(simulation.history_row());
    rows.push_back(simulation.budget_row());
  }
  return rows;
}

TEST(Simulation, HasStoredNothingBeforeItsInitialState) {
  EXPECT_EQ(Simulation(case_of({})).progress().water.storage, 0.0);
}

TEST_P(State, IsAllThatARunNeedsToGoOn) {
  const Case input = case_of(GetParam().changes);
  Simulation original(input);
  original.initialise();
  for (int k = 0; k < 3; ++k) original.advance();
  ASSERT_EQ(original.summary().end_reason, EndReason::running);
  Simulation copy = original, again(input, original.state(), 2);
  EXPECT_TRUE(again.state() == original.state());
  const Rows rows = finish(original);
  ASSERT_GT(rows.size(), 4u);
  EXPECT_EQ(finish(copy), rows);
  EXPECT_EQ(finish(again), rows) << "with two threads";
  EXPECT_TRUE(copy.state() == original.state());
  EXPECT_TRUE(again.state() == original.state());
  EXPECT_TRUE(again.summary() == original.summary());
}

INSTANTIATE_TEST_SUITE_P(
    Of, State,
    testing::Values(
        Kind{"TheDefaultRun", {}},
        Kind{"FrictionalWalls",
             {"walls={left: friction, left_friction: 0.3, right: friction, right_friction: 0.3, base: "
              "friction, base_friction: 0.4}"}},
        Kind{"AbsorbingWalls",
             {"walls={left: absorbing, right: absorbing, base: absorbing, absorbing_depth: 20 m}",
              "seismic={horizontal_coefficient: 0.1, start: 0.1 s}"}},
        Kind{"Rain", {"water_boundaries=[{name: rain, at: free_surface, rain: {intensity: 300 mm/h}}]"}},
        Kind{"AReservoir",
             {"water_boundaries=[{name: lake, at: free_surface, reservoir: {level: [[0 s, 2 m], [9 s, 1 m]]}}]"}},
        Kind{"ARigidSkeleton", {"coupling.skeleton=rigid"}},
        Kind{"WaterAlone", {"coupling.scheme=seepage", "stop.time=1 h", "output.history_interval=5 min"}},
        Kind{"TheExplicitScheme", {"coupling.scheme=explicit", "stop.time=0.06 s", "output.history_interval=0.01 s"}},
        Kind{"TheOnsetByRunaway", {"failure.onset=runaway"}},
        Kind{
            "ModifiedCamClay",
            {"soils.silty_sand.strength={model: modified_cam_clay, critical_state_friction_angle: 30 deg, lambda: 0.1, "
             "kappa: 0.02, minimum_mean_stress: 5 kPa, overconsolidation_ratio: 1.5}",
             "water_boundaries=[{name: rain, at: free_surface, rain: {intensity: 300 mm/h}}]"}},
        Kind{"LinearShapeFunctionsAndFlip", {"numerics.shape_function=linear", "numerics.flip_fraction=0.9"}}),
    [](const auto& instance) { return std::string(instance.param.name); });

TEST(Branch, GoesOnWithAnotherRainAndLeavesTheOriginalAlone) {
  const std::string rain = "water_boundaries=[{name: rain, at: free_surface, rain: {intensity: 300 mm/h}}]";
  const Case wet = case_of({rain});
  Simulation original(wet);
  original.initialise();
  Simulation untouched = original;
  for (Event event; event.label != "onset";) {
    event = original.advance();
    ASSERT_FALSE(event.finished);
  }
  Case dry = wet;
  dry.water_boundaries.clear();
  Simulation branch(dry, original.state());
  const double fallen = original.progress().water.rain;
  finish(branch);
  finish(original);
  finish(untouched);
  EXPECT_TRUE(untouched.state() == original.state());
  EXPECT_EQ(branch.progress().water.rain, fallen);
  EXPECT_GT(original.progress().water.rain, fallen);
  EXPECT_EQ(branch.summary().onset_time, original.summary().onset_time);
}

TEST(Branch, OfAnotherGroundIsRefused) {
  Simulation coarse(case_of({}));
  coarse.initialise();
  EXPECT_THROW(Simulation(case_of({"domain.cell_size=0.5 m"}), coarse.state()), InputError);
  EXPECT_THROW(Simulation(case_of({"coupling.skeleton=rigid"}), coarse.state()), InputError);
  EXPECT_THROW(Simulation(case_of({"coupling.scheme=seepage"}), coarse.state()), InputError);
  SimulationState torn = coarse.state();
  std::get<ClockPace>(torn.pace).clock.pressure = {0.0};
  EXPECT_THROW(Simulation(case_of({}), torn), InputError);
  for (const double place : {std::nan(""), -1.0e20, 1.0e20}) {
    SimulationState elsewhere = coarse.state();
    elsewhere.head_operator.x.front() = place;
    EXPECT_THROW(Simulation(case_of({}), elsewhere), InputError) << place;
    elsewhere = coarse.state();
    elsewhere.soil.particles.y.front() = place;
    EXPECT_THROW(Simulation(case_of({}), elsewhere), InputError) << place;
  }
  for (const double time : {std::nan(""), -1.0, 1.0e300}) {
    SimulationState elsewhen = coarse.state();
    elsewhen.progress.time = time;
    EXPECT_THROW(Simulation(case_of({}), elsewhen), InputError) << time;
  }
  EXPECT_THROW(
      Simulation(case_of({"walls={left: friction, left_friction: 0.3, right: roller, base: fixed}"}), coarse.state()),
      InputError);
}

}  // namespace
}  // namespace slope::couple
