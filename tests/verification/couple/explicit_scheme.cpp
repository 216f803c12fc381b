// The paper's own explicit cycle (section 2.6) against the default scheme, on a lattice and for short times: where it
// agrees, and what it loses.

#include <gtest/gtest.h>

#include <cmath>

#include "run_case.hpp"
#include "slope/testing/record.hpp"

namespace slope::testing {
namespace {

using Overrides = std::vector<std::string>;

couple::Simulation at_end(couple::Simulation simulation) {
  run(simulation, [](const couple::ParticleTable&) {});
  return simulation;
}

// Mean pore pressure (Pa) over the middle of a column that is 1 m high.
double middle_pressure(const couple::Simulation& simulation) {
  const couple::ParticleTable table = simulation.particles();
  double sum = 0.0;
  int count = 0;
  for (std::size_t p = 0; p < table.position.size(); ++p) {
    if (std::abs(table.position[p][1] - 0.5) > 0.3) continue;
    sum += table.pore_pressure[p];
    ++count;
  }
  return sum / count;
}

double undrained_pressure(const std::string& scheme) {
  const double hydrostatic = 9810.0 * 0.5;
  return middle_pressure(at_end(
             start_case("terzaghi.yaml", {"coupling.scheme=" + scheme, "clock.adaptive=false", "stop.time=0.3 s"}))) -
         hydrostatic;
}

TEST(ExplicitScheme, TakesUpAnUndrainedLoadLikeTheDefault) {
  const double ratio = undrained_pressure("explicit") / undrained_pressure("semi_implicit");
  EXPECT_TRUE(record("explicit-1", "Explicit two-pass scheme, undrained load: pressure over that of the default scheme",
                     near(1.0, 0.02), ratio, ""));
}

TEST(ExplicitScheme, LosesWaterAtATopThatIsNotAWall) {
  const Overrides stretch{"clock.adaptive=false", "stop.time=0.5 s", "output.snapshots=[]", "figures.profile_times=[]"};
  const auto error_of = [&](const std::string& scheme) {
    Overrides overrides = stretch;
    overrides.push_back("coupling.scheme=" + scheme);
    return std::abs(
        at_end(start_shipped_case("paper/liakopoulos.yaml", overrides)).summary().water.relative_balance_error);
  };
  EXPECT_LT(error_of("semi_implicit"), 1.0e-3);
  EXPECT_GT(error_of("explicit"), 0.1);
}

}  // namespace
}  // namespace slope::testing
