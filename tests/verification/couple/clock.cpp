// How fast the clock runs must not show in what the slope does: each case's displacements come at the same time when
// the forces that the clock may leave out of balance are halved; and a slide has no steps but those that real time has.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include "run_case.hpp"
#include "slope/testing/record.hpp"

namespace slope::testing {
namespace {

struct Course {
  couple::Summary summary;
  double largest_step = 0.0;  // of the largest displacement, from one history row to the next (m)
};

// To a displacement of 30 cm, or the end of the case.
Course run_with(const std::string& name, std::vector<std::string> overrides, double share_of_limit) {
  const double limit = share_of_limit * couple::Clock{}.unbalanced_limit;
  overrides.push_back("clock.unbalanced_limit=" + std::to_string(1e6 * limit) + "e-6");
  couple::Simulation simulation = start_shipped_case(name, overrides);
  Course run;
  double before = 0.0;
  for (couple::Event event; !event.finished;) {
    event = simulation.advance();
    if (!event.history) continue;
    const double now = simulation.summary().largest_displacement;
    run.largest_step = std::max(run.largest_step, now - before);
    before = now;
  }
  run.summary = simulation.summary();
  return run;
}

// Largest relative difference of the times at which two runs pass the displacements up to a largest one (m).
double largest_shift(const couple::Summary& a, const couple::Summary& b, double up_to) {
  double largest = 0.0;
  for (std::size_t k = 0; k < a.displacement_times.size(); ++k) {
    if (a.displacement_times[k].displacement > up_to) break;
    EXPECT_TRUE(a.displacement_times[k].time && b.displacement_times[k].time);
    if (!a.displacement_times[k].time || !b.displacement_times[k].time) return 1.0;
    largest = std::max(largest, std::abs(*b.displacement_times[k].time / *a.displacement_times[k].time - 1.0));
  }
  return largest;
}

struct Halving {
  const char* id;
  const char* what;
  const char* file;
};

void PrintTo(const Halving& halving, std::ostream* out) {
  *out << halving.file;
}

class ClockLimit : public ::testing::TestWithParam<Halving> {};

TEST_P(ClockLimit, HalvedChangesNoTime) {
  const Halving& h = GetParam();
  const Course whole = run_with(h.file, {"stop.displacement=30.1 cm"}, 1.0);
  const Course half = run_with(h.file, {"stop.displacement=30.1 cm"}, 0.5);
  EXPECT_TRUE(record(h.id, h.what, at_most(0.015), largest_shift(whole.summary, half.summary, 0.30), "%"));
}

INSTANTIATE_TEST_SUITE_P(
    Slopes, ClockLimit,
    ::testing::Values(Halving{"clock-1-w1", "Clock's limit halved, times at 1 to 30 cm: slope W1, largest change",
                              "paper/slope-w1.yaml"},
                      Halving{"clock-1-w2", "- slope W2", "paper/slope-w2.yaml"},
                      Halving{"clock-1-w3", "- slope W3", "paper/slope-w3.yaml"},
                      Halving{"clock-2-h1", "- slope H1", "paper/slope-h1.yaml"},
                      Halving{"clock-2-h3", "- slope H3", "paper/slope-h3.yaml"},
                      Halving{"clock-3-storm", "- storm of two days on W2", "rain/storm.yaml"},
                      Halving{"clock-4-road-cut", "- road cut", "rain/road-cut.yaml"}),
    [](const auto& test) {
      std::string name = test.param.id;
      std::ranges::replace(name, '-', '_');
      return name;
    });

TEST(RoadCut, SlidesAsWithAThirdOfTheLimit) {
  const std::vector<std::string> overrides{"stop={time: 40 h, displacement: 12 cm}"};
  const Course whole = run_with("rain/road-cut.yaml", overrides, 1.0);
  const Course third = run_with("rain/road-cut.yaml", overrides, 1.0 / 3.0);
  EXPECT_TRUE(record("clock-5-road-cut", "Road cut, a third of the clock's limit: times at 2, 5, 10 cm, largest change",
                     at_most(0.015), largest_shift(whole.summary, third.summary, 0.10), "%"));
  EXPECT_TRUE(
      record("clock-6-road-cut", "- largest step within ten minutes", at_most(1.2), 100.0 * whole.largest_step, "cm"));
}

}  // namespace
}  // namespace slope::testing
