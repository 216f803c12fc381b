// Soil that dilates where it shears. A slope far from failure is in balance, whatever its dilatancy, and its mean
// stress is that of soil that does not dilate: what yields at its toe is next to nothing.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "run_case.hpp"
#include "slope/testing/record.hpp"

namespace slope::testing {
namespace {

couple::Simulation slope_with(const std::string& model, int dilatancy_angle) {
  couple::Simulation simulation = start_case(
      "slope_factor.yaml", {"soils.loam.strength.model=" + model, "stop.time=1 s",
                            "soils.loam.strength.dilatancy_angle=" + std::to_string(dilatancy_angle) + " deg"});
  run(simulation, [](const couple::ParticleTable&) {});
  return simulation;
}

double mean_stress(const couple::ParticleTable& table, std::size_t p) {
  const auto& s = table.stress_effective[p];
  return (s.xx + s.yy + s.zz) / 3.0;
}

void check(const std::string& id, const std::string& model) {
  const couple::ParticleTable plain = slope_with(model, 0).particles();
  double displacement = 0.0, difference = 0.0;
  for (const int angle : {5, 12, 25}) {
    const couple::Simulation simulation = slope_with(model, angle);
    const couple::ParticleTable table = simulation.particles();
    EXPECT_EQ(simulation.summary().verdict, couple::Verdict::stands) << angle;
    displacement = std::max(displacement, simulation.summary().largest_displacement);
    for (std::size_t p = 0; p < table.position.size(); ++p) {
      difference = std::max(difference, std::abs(mean_stress(table, p) - mean_stress(plain, p)));
    }
  }
  EXPECT_TRUE(record(id + "-1", "Slope of factor 1.4, " + model + ", dilatancy 5, 12 and 25 deg: it moves in 1 s by",
                     at_most(0.1), 1e3 * displacement, "mm"));
  EXPECT_TRUE(
      record(id + "-2", "- its mean stress against that without dilatancy", at_most(5.0), 1e-3 * difference, "kPa"));
}

TEST(DilatantSlope, OfMohrCoulombStands) {
  check("dilatancy-1", "mohr_coulomb");
}

TEST(DilatantSlope, OfDruckerPragerStands) {
  check("dilatancy-2", "drucker_prager");
}

}  // namespace
}  // namespace slope::testing
