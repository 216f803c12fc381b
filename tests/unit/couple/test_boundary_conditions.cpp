#include <gtest/gtest.h>

#include <algorithm>

#include "case/initial_values.hpp"
#include "case_folder.hpp"
#include "run/boundary_conditions.hpp"
#include "slope/couple/read_case.hpp"

namespace slope::couple::test {
namespace {

/// What acts on the shipped quick case with some overrides.
struct Acting {
  explicit Acting(const std::vector<std::string>& overrides)
      : input(read_case(shipped_cases() / "quick.yaml", overrides)),
        particles(fill_regions(input.domain, input.regions)),
        mixture(input, particles, initial_pressure(input, particles), 1),
        conditions(input, particles) {}

  [[nodiscard]] Actions at(double time) {
    Actions actions;
    conditions.apply(time, mixture, actions);
    return actions;
  }

  Case input;
  InitialParticles particles;
  Mixture mixture;
  BoundaryConditions conditions;
};

TEST(BoundaryConditions, ASurchargeIsPerHorizontalMetreWhateverTheInclination) {
  Acting acting({"loads=[{name: fill, at: ground_surface, traction: [0 kPa, -10 kPa], start: 2 s, ramp: 4 s}]"});
  EXPECT_TRUE(acting.at(1.0).tractions.empty());
  for (const auto& [time, share] : {std::pair{4.0, 0.5}, std::pair{6.0, 1.0}, std::pair{60.0, 1.0}}) {
    double force = 0.0;
    for (const solid::ParticleTraction& traction : acting.at(time).tractions) {
      EXPECT_EQ(traction.x, 0.0);
      force += traction.y * acting.particles.spacing;
    }
    EXPECT_NEAR(force, -share * 10.0e3 * 11.0, 1e-6) << "the ground is 11 m wide, its face 45 degrees steep";
  }
}

TEST(BoundaryConditions, AnEarthquakeGrowsOverItsRamp) {
  Acting acting({"seismic={horizontal_coefficient: 0.2, vertical_coefficient: -0.1, start: 10 s, ramp: 4 s}"});
  EXPECT_EQ(acting.at(9.0).body_acceleration, (std::array{0.0, 0.0}));
  EXPECT_NEAR(acting.at(11.0).body_acceleration[0], 0.25 * 0.2 * 9.81, 1e-12);
  EXPECT_NEAR(acting.at(14.0).body_acceleration[0], 0.2 * 9.81, 1e-12);
  EXPECT_NEAR(acting.at(99.0).body_acceleration[1], -0.1 * 9.81, 1e-12);
  const auto& times = acting.conditions.change_times();
  for (const double time : {10.0, 14.0}) EXPECT_NE(std::find(times.begin(), times.end(), time), times.end()) << time;
  Actions before;
  acting.conditions.apply_initial(acting.mixture, before);
  EXPECT_EQ(before.body_acceleration, (std::array{0.0, 0.0}));
  EXPECT_EQ(acting.conditions.standing_acceleration(), (std::array{0.0, 0.0}));
  Acting standing({"seismic={horizontal_coefficient: 0.2, vertical_coefficient: -0.1}"});
  EXPECT_EQ(standing.conditions.standing_acceleration(), standing.at(0.0).body_acceleration);
}

// A step may be hours long where the water moves alone.
TEST(BoundaryConditions, NothingActsInTheStepThatEndsWhereItStarts) {
  Acting acting({"water_boundaries=[{name: rain, at: free_surface, start: 2 s, rain: {intensity: 10 mm/h}}]",
                 "loads=[{name: fill, at: ground_surface, traction: [0 kPa, -10 kPa], start: 2 s}]",
                 "seismic={horizontal_coefficient: 0.2, start: 2 s}"});
  const Actions before = acting.at(2.0), after = acting.at(2.0 + 1e-9);
  EXPECT_TRUE(before.water.open_faces.empty());
  EXPECT_TRUE(before.tractions.empty());
  EXPECT_EQ(before.body_acceleration[0], 0.0);
  EXPECT_FALSE(after.water.open_faces.empty());
  EXPECT_FALSE(after.tractions.empty());
  EXPECT_NEAR(after.body_acceleration[0], 0.2 * 9.81, 1e-12);
}

/// Overrides of the quick case (ground at 1 m, face from x = 2.5 m to 7.2 m, crest at 5 m) with a lake on it.
std::vector<std::string> lake_of(const std::string& level, const std::string& more = "") {
  return {"water_boundaries=[{name: lake, at: free_surface, initial: true, reservoir: {level: " + level + "}}" + more +
          "]"};
}

TEST(BoundaryConditions, AReservoirFollowsItsLevel) {
  Acting acting(lake_of("[[10 s, 3 m], [20 s, 2 m], [30 s, 4 m]]"));
  const auto& lake = std::get<Reservoir>(acting.input.water_boundaries[0].condition);
  EXPECT_EQ(lake.level.at(0.0), 3.0);
  EXPECT_EQ(lake.level.at(15.0), 2.5);
  EXPECT_EQ(lake.level.at(25.0), 3.0);
  EXPECT_EQ(lake.level.at(99.0), 4.0);
  EXPECT_EQ(lake.level.highest(), 4.0);
  EXPECT_EQ(acting.conditions.next_change(0.0), 10.0);
  EXPECT_EQ(acting.conditions.next_change(10.0), 20.0);
  EXPECT_EQ(acting.conditions.next_change(30.0), never);
  EXPECT_EQ(acting.conditions.names(), (std::vector<std::string>{"lake", "lake above the level"}));
  EXPECT_FALSE(acting.conditions.is_open(0));
  EXPECT_TRUE(acting.conditions.is_open(1));
}

TEST(BoundaryConditions, AReservoirHoldsItsPressureBelowTheLevelAndLetsWaterOutAbove) {
  Acting acting(lake_of("3 m"));
  const Actions actions = acting.at(1.0);
  EXPECT_EQ(actions.water.count, 2u);
  ASSERT_FALSE(actions.water.faces.empty());
  ASSERT_FALSE(actions.water.open_faces.empty());
  const std::vector<double>& y = acting.mixture.soil.particles().y;
  for (const seepage::FacePressure& face : actions.water.faces) {
    EXPECT_EQ(face.boundary, 0u);
    EXPECT_NEAR(face.pressure, 9810.0 * (3.0 - y[face.particle] - face.rise), 1e-9);
    EXPECT_GT(face.pressure, 0.0);
  }
  for (const seepage::OpenFace& face : actions.water.open_faces) {
    EXPECT_EQ(face.boundary, 1u);
    EXPECT_EQ(face.rain, 0.0);
    EXPECT_GE(y[face.particle] + face.rise, 3.0);
  }
  double lift = 0.0, below = 0.0;
  for (std::size_t p = 0; p < y.size(); ++p) {
    lift -= acting.particles.volume[p] * actions.standing_water.gradient_y[p];
    below += acting.particles.volume[p] * std::clamp((3.0 - y[p]) / acting.particles.spacing + 0.5, 0.0, 1.0);
  }
  EXPECT_NEAR(lift, 9810.0 * below, 1e-6 * lift);
}

TEST(BoundaryConditions, RainFallsOnWhatAReservoirLeavesDry) {
  Acting acting(lake_of("3 m", ", {name: storm, at: free_surface, start: 5 s, rain: {intensity: 36 mm/h}}"));
  const Actions dry = acting.at(1.0), rain = acting.at(6.0);
  EXPECT_EQ(dry.water.open_faces.size(), rain.water.open_faces.size());
  double fallen = 0.0;
  for (const seepage::OpenFace& face : rain.water.open_faces) {
    EXPECT_EQ(face.boundary, 1u) << "the storm's";
    fallen += face.rain;
  }
  EXPECT_NEAR(fallen, 1.0e-5 * (11.0 - 4.85), 0.5e-5) << "from the shore on";
  for (const seepage::OpenFace& face : dry.water.open_faces) EXPECT_EQ(face.boundary, 2u) << "the lake's";
}

TEST(BoundaryConditions, AReservoirHoldsBeforeTheStartIfItIsInitial) {
  Acting acting(lake_of("[[0 s, 3 m], [10 s, 4 m]]"));
  Actions before;
  acting.conditions.apply_initial(acting.mixture, before);
  EXPECT_EQ(before.water.faces.size(), acting.at(0.0).water.faces.size());
  EXPECT_EQ(before.standing_water.pressure, acting.at(0.0).standing_water.pressure);
  Acting later({"water_boundaries=[{name: lake, at: free_surface, reservoir: {level: 3 m}}]"});
  later.conditions.apply_initial(later.mixture, before);
  EXPECT_TRUE(before.water.faces.empty());
  EXPECT_TRUE(before.standing_water.pressure.empty());
}

TEST(BoundaryConditions, TwoReservoirsShareTheSoilBetweenThem) {
  const std::string far = ", {name: pond, at: free_surface, from: 9 m, reservoir: {level: 4 m}}";
  Acting acting(
      {"water_boundaries=[{name: lake, at: free_surface, to: 8 m, reservoir: {level: 3 m}}" + far + "]",
       "geometry.0.polygon=[[0 m, 0 m], [11 m, 0 m], [11 m, 3 m], [9.5 m, 5 m], [7.2 m, 5 m], [2.5 m, 1 m], [0 m, "
       "1 m]]"});
  const Actions actions = acting.at(1.0);
  const solid::Particles& soil = acting.mixture.soil.particles();
  for (std::size_t p = 0; p < soil.size(); ++p) {
    if (soil.y[p] > 2.5) continue;  // below both levels
    const double lake = 9810.0 * (3.0 - soil.y[p]), pond = 9810.0 * (4.0 - soil.y[p]);
    const double share = std::clamp(soil.x[p] - 8.0, 0.0, 1.0);
    EXPECT_NEAR(actions.standing_water.pressure[p], (1.0 - share) * lake + share * pond, 1e-6);
    EXPECT_NEAR(actions.standing_water.gradient_x[p], share > 0.0 && share < 1.0 ? pond - lake : 0.0, 1e-6);
    EXPECT_NEAR(actions.standing_water.gradient_y[p], -9810.0, 1e-6);
  }
  for (const seepage::FacePressure& face : actions.water.faces) {
    EXPECT_EQ(face.boundary, soil.x[face.particle] > 9.0 ? 1u : 0u);
  }
}

TEST(BoundaryConditions, PressuresAndFluxesFollowTheirPoints) {
  Acting acting(
      {"water_boundaries=[{name: river, at: left, to: 1 m, total_head: [[0 s, 1 m], [10 s, 3 m]], applied_to: "
       "face}, {name: leak, at: right, flux: [[0 s, 0 m/s], [20 s, 2e-6 m/s]]}, {name: drain, at: base, "
       "free_drainage: true, start: 4 s}]"});
  EXPECT_EQ(acting.conditions.next_change(0.0), 4.0) << "the drain begins";
  EXPECT_EQ(acting.conditions.next_change(4.0), 10.0);
  EXPECT_EQ(acting.conditions.next_change(10.0), 20.0);
  EXPECT_NEAR(acting.conditions.prescribed_rate(0.0), 9810.0 * 0.2, 1e-6);
  EXPECT_EQ(acting.conditions.prescribed_rate(10.0), 0.0);
  EXPECT_TRUE(acting.at(3.0).water.drains.empty());
  const Actions actions = acting.at(5.0);
  const solid::Particles& soil = acting.mixture.soil.particles();
  ASSERT_FALSE(actions.water.faces.empty());
  for (const seepage::FacePressure& face : actions.water.faces) {
    EXPECT_NEAR(face.pressure, 9810.0 * (2.0 - soil.y[face.particle]), 1e-9);
  }
  ASSERT_FALSE(actions.water.inflows.empty());
  const double spacing = acting.particles.spacing;
  for (const seepage::Inflow& inflow : actions.water.inflows) EXPECT_NEAR(inflow.rate, 0.5e-6 * spacing, 1e-18);
  double width = 0.0;
  for (const seepage::Drain& drain : actions.water.drains) width += drain.width;
  EXPECT_NEAR(width, 11.0, 1e-9);
}

}  // namespace
}  // namespace slope::couple::test
