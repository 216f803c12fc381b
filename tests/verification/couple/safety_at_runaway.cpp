// The factor of safety of the paper's slopes falls to one as their motion runs away.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

#include "run_case.hpp"
#include "slope/testing/record.hpp"

namespace slope::testing {
namespace {

// When the motion is found to run away, soon after it begins to.
double factor_at_runaway(const std::string& name) {
  couple::Simulation simulation = start_shipped_case("paper/" + name + ".yaml");
  while (!simulation.summary().runaway_onset && !simulation.advance().finished) {
  }
  EXPECT_TRUE(simulation.summary().runaway_onset) << name;
  EXPECT_TRUE(simulation.find_safety()) << name;
  const double factor = simulation.summary().safety.back().factor;
  std::cout << name << ": " << factor << '\n';
  return factor;
}

TEST(SafetyAtRunaway, IsOne) {
  double worst = 0.0;
  for (const char* name : {"slope-w1", "slope-w2", "slope-w3", "slope-h1"}) {
    worst = std::max(worst, std::abs(factor_at_runaway(name) - 1.0));
  }
  EXPECT_TRUE(record("safety-runaway-1",
                     "Slopes W1, W2, W3 and H1 when their motion runs away: factor of safety off one, the largest",
                     at_most(0.02), worst, ""));
}

}  // namespace
}  // namespace slope::testing
