// Where the particles' lattice meets the ground decides nothing: a small slope under rain fails at the same time
// wherever it lies in the grid, and with four times as many particles.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "run_case.hpp"
#include "slope/testing/record.hpp"

namespace slope::testing {
namespace {

// Time at which the slope of cases/quick.yaml has moved 2 cm (s), its face moved to the right by so much (m).
double onset(const std::string& by, const std::vector<std::string>& more = {}) {
  const double shift = std::stod(by);
  const auto x = [&](double at) { return std::to_string(at + shift) + " m"; };
  std::vector<std::string> overrides{"geometry=[{soil: silty_sand, polygon: [[0 m, 0 m], [11 m, 0 m], [11 m, 5 m], [" +
                                         x(7.2) + ", 5 m], [" + x(2.5) + ", 1 m], [0 m, 1 m]]}]",
                                     "stop.displacement=3 cm"};
  overrides.insert(overrides.end(), more.begin(), more.end());
  couple::Simulation simulation = start_shipped_case("quick.yaml", overrides);
  run(simulation, [](const couple::ParticleTable&) {});
  return simulation.summary().onset_time.value();
}

TEST(Lattice, DoesNotDecideWhenASlopeFails) {
  const double here = onset("0");
  double earliest = here, latest = here;
  for (const char* by : {"0.1", "0.2", "0.3"}) {
    const double there = onset(by);
    earliest = std::min(earliest, there);
    latest = std::max(latest, there);
  }
  EXPECT_TRUE(record("lattice-1", "Small slope under rain, its face at four places of the lattice: spread of the onset",
                     at_most(0.03), (latest - earliest) / here, "%"));
  EXPECT_TRUE(record("lattice-2", "- with 16 particles in a cell instead of 4: change of the onset", at_most(0.03),
                     std::abs(onset("0", {"domain.particles_per_cell=16"}) / here - 1.0), "%"));
  EXPECT_TRUE(record("lattice-3", "- with whole particles instead of clipped ones: change of the onset", at_most(0.03),
                     std::abs(onset("0", {"domain.surface_particles=lattice"}) / here - 1.0), "%"));
}

}  // namespace
}  // namespace slope::testing
