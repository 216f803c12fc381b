#include <gtest/gtest.h>

#include <algorithm>

#include "boundary_conditions.hpp"
#include "case_folder.hpp"
#include "initial_state.hpp"
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
}

}  // namespace
}  // namespace slope::couple::test
