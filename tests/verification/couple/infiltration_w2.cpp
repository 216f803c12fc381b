// A column of the W2 soil under zero pressure at its surface, against independent one-dimensional solutions.

#include <gtest/gtest.h>

#include <algorithm>

#include "run_case.hpp"
#include "slope/testing/curve.hpp"
#include "slope/testing/record.hpp"
#include "slope/testing/table.hpp"

namespace slope::testing {
namespace {

double worst_error(const std::string& skeleton, const std::string& suffix, const std::string& times,
                   const std::string& end) {
  couple::Simulation simulation = start_case(
      "infiltration_w2.yaml", {"coupling.skeleton=" + skeleton, "output.snapshots=" + times, "stop.time=" + end});
  const Table profiles = reference("infiltration_w2/infiltration_profiles_W2_D5.csv");
  double worst = 0.0;
  run(simulation, [&](const couple::ParticleTable& now) {
    Curve pressure;
    for (std::size_t p = 0; p < now.position.size(); ++p) {
      pressure.x.push_back(8.0 - (now.position[p][1] - now.displacement[p][1]));
      pressure.y.push_back(now.pore_pressure[p] / 1000.0);
    }
    const Curve exact{profiles.column("depth_m"), profiles.column("p_kPa_t" + time_text(now.time) + suffix)};
    worst = std::max(worst, max_relative_error(pressure, exact));
  });
  return worst;
}

TEST(InfiltrationW2, Deformable) {
  const double worst = worst_error("deformable", "_def", "[10 s, 30 s, 100 s, 300 s]", "600 s");
  EXPECT_TRUE(record("infiltration-1", "W2 infiltration column, deformable, 2 x 160 particles: pressure, 10 to 600 s",
                     at_most(0.02), worst, "%"));
}

TEST(InfiltrationW2, Rigid) {
  const double worst = worst_error("rigid", "_rigid", "[3 s, 10 s, 30 s, 60 s]", "90 s");
  EXPECT_TRUE(record("infiltration-2", "W2 infiltration column, rigid, 2 x 160 particles: pressure, 3 to 90 s",
                     at_most(0.02), worst, "%"));
}

}  // namespace
}  // namespace slope::testing
