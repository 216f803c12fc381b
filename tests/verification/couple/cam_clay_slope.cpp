// A small slope of slightly overconsolidated clay under its own weight: it finds its initial stress, with the memory
// that goes with it, and stays where it is.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "run_case.hpp"
#include "slope/solid/modified_cam_clay.hpp"
#include "slope/testing/record.hpp"

namespace slope::testing {
namespace {

constexpr double ratio = 1.5;

std::vector<std::string> clay() {
  return {
      "soils.silty_sand.strength={model: modified_cam_clay, critical_state_friction_angle: 30 deg, lambda: 0.1, kappa: "
      "0.02, minimum_mean_stress: 5 kPa, overconsolidation_ratio: " +
          std::to_string(ratio) + "}",
      "water_boundaries=[]", "stop.time=1 s", "output.history_interval=0.5 s"};
}

TEST(CamClaySlope, FindsItsInitialStressAndStands) {
  couple::Simulation simulation = start_shipped_case("quick.yaml", clay());
  const solid::Soil& soil = simulation.input().soils[0].solid;
  solid::ModifiedCamClay normally = std::get<solid::ModifiedCamClay>(soil.strength);
  normally.overconsolidation_ratio = 1.0;
  const solid::HardeningEllipse law(normally, soil.elastic.poissons_ratio);
  const couple::ParticleTable start = simulation.particles();
  ASSERT_EQ(start.internal.size(), 1u);
  double outside = 0.0, memory = 0.0;
  for (std::size_t p = 0; p < start.position.size(); ++p) {
    const auto& [xx, yy, zz, xy] = start.stress_effective[p];
    const double p_c = start.internal[0].values[p];
    double through_stress = 0.0;
    law.initial({xx, yy, zz, xy}, {&through_stress, 1});
    outside = std::max(outside, law.value({xx, yy, zz, xy}, {&p_c, 1}));
    memory = std::max(memory, std::abs(p_c / (ratio * through_stress) - 1.0));
  }
  EXPECT_TRUE(record("cam-clay-slope-1", "Slope of modified Cam-clay, its initial stress: unbalanced over weight",
                     at_most(1.0e-6), simulation.summary().initial_unbalanced_ratio, ""));
  EXPECT_TRUE(
      record("cam-clay-slope-2", "- yield function over p_c^2, where it is largest", at_most(0.0), outside, ""));
  EXPECT_TRUE(
      record("cam-clay-slope-3", "- overconsolidation ratio of 1.5, largest error", at_most(0.01), memory, "%"));
  EXPECT_TRUE(simulation.summary().stands_before);
  run(simulation, [](const couple::ParticleTable& /*now*/) {});
  EXPECT_TRUE(record("cam-clay-slope-4", "- how far it moves in its first second", at_most(1.0e-5),
                     simulation.summary().largest_displacement, "m"));
}

}  // namespace
}  // namespace slope::testing
