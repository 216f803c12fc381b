// A saturated, closed column that is let go under its own weight vibrates; nothing but the scheme's own dissipation
// damps it.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "run_case.hpp"
#include "slope/testing/record.hpp"

namespace slope::testing {
namespace {

// Largest speed in the second half of the run over that in the first.
double growth(const std::string& courant_number) {
  couple::Simulation simulation =
      start_case("terzaghi.yaml", {"initial.stress=none", "clock.adaptive=false", "stop.time=0.9 s",
                                   "output.history_interval=0.001 s", "numerics.courant_number=" + courant_number});
  double first = 0.0, second = 0.0;
  for (couple::Event event; !event.finished;) {
    event = simulation.advance();
    const couple::ParticleTable now = simulation.particles();
    double speed = 0.0;
    for (const couple::Point& v : now.velocity) speed = std::max(speed, std::hypot(v[0], v[1]));
    double& largest = now.time < 0.45 ? first : second;
    largest = std::max(largest, speed);
  }
  return second / first;
}

TEST(UndrainedColumn, VibratesWithoutGrowing) {
  double worst = 0.0;
  for (const char* courant_number : {"0.25", "0.5", "0.9"}) worst = std::max(worst, growth(courant_number));
  EXPECT_TRUE(record("undrained-1",
                     "Undrained vibrating column, Courant numbers 0.25 to 0.9: largest speed, second half over first",
                     at_most(1.0), worst, ""));
}

}  // namespace
}  // namespace slope::testing
