#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <set>

#include "case_run.hpp"
#include "promises.hpp"
#include "random_case.hpp"
#include "random_numbers.hpp"
#include "slope/couple/read_case.hpp"

namespace slope::random_cases {
namespace {

namespace fs = std::filesystem;

TEST(RandomNumbers, AreTheSameEverywhere) {
  RandomNumbers random(1, 0);
  EXPECT_DOUBLE_EQ(random.uniform(0.0, 1.0), 0.44149167444625148);
  EXPECT_EQ(random.whole(0, 999999), 328402);
  RandomNumbers neighbour(1, 1), other_seed(2, 0);
  EXPECT_NE(neighbour.whole(0, 999999), other_seed.whole(0, 999999));
}

TEST(RandomNumbers, StayInTheirRanges) {
  RandomNumbers random(7, 3);
  std::set<int> wholes;
  std::size_t second = 0;
  for (int i = 0; i < 3000; ++i) {
    wholes.insert(random.whole(-1, 2));
    const double value = random.logarithmic(0.01, 100.0);
    EXPECT_TRUE(value >= 0.01 && value < 100.0) << value;
    second += random.index({1.0, 2.0, 0.0});
  }
  EXPECT_EQ(wholes, (std::set{-1, 0, 1, 2}));
  EXPECT_NEAR(static_cast<double>(second), 2000.0, 120.0);
}

TEST(RandomCase, OfANumberIsAlwaysTheSameAndNoOther) {
  EXPECT_EQ(random_case(3, 5).yaml, random_case(3, 5).yaml);
  EXPECT_NE(random_case(3, 5).yaml.substr(40), random_case(3, 6).yaml.substr(40));
  EXPECT_NE(random_case(3, 5).yaml.substr(40), random_case(4, 5).yaml.substr(40));
}

/// A box of wet soil under rain, after a while.
class Judged : public testing::Test {
 protected:
  Judged() : input(couple::read_case(SLOPE_RANDOM_TESTS "/box.yaml")), simulation(input) {
    simulation.initialise();
    start = simulation.particles();
    before = simulation.summary();
    while (!simulation.advance().finished) {
    }
    now = simulation.particles();
    after = simulation.summary();
  }
  [[nodiscard]] std::vector<std::string> broken() const {
    Promises promises(input, start, before);
    promises.look(now, after);
    promises.look_at_end(after);
    return promises.broken();
  }
  /// Whether a value in the place of another is.
  [[nodiscard]] bool seen(double& place, double value) const {
    const double kept = place;
    place = value;
    const bool is_seen = !broken().empty();
    place = kept;
    return is_seen;
  }

  couple::Case input;
  couple::Simulation simulation;
  couple::ParticleTable start, now;
  couple::Summary before, after;
};

TEST_F(Judged, AGoodRunKeepsWhatIsPromised) {
  EXPECT_EQ(broken(), std::vector<std::string>{});
  EXPECT_GT(after.water.run_off, 0.0);
}

TEST_F(Judged, RunOffThatTheBooksLeaveOutIsSeen) {
  after.water.run_off = 0.0;
  EXPECT_EQ(broken().size(), 1u);
}

TEST_F(Judged, RainThatFellTooLongIsSeen) {
  after.water.rain *= 1.2;
  after.water.run_off = after.water.rain - after.water.rain_infiltration;
  EXPECT_EQ(broken().size(), 1u);
}

TEST_F(Judged, WaterThatIsLostIsSeen) {
  after.water.infiltration *= 1.001;
  EXPECT_FALSE(broken().empty());
}

TEST_F(Judged, NoNumberIsSeenInAnyField) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(seen(now.pore_pressure[3], none));
  EXPECT_TRUE(seen(now.stress_effective[3].yy, none));
  EXPECT_TRUE(seen(now.displacement[3][0], none));
  EXPECT_TRUE(seen(now.darcy_velocity[3][1], none));
  EXPECT_TRUE(seen(after.water.storage, none));
}

TEST_F(Judged, WhatCannotBeIsSeen) {
  EXPECT_TRUE(seen(now.saturation[3], 1.01));
  EXPECT_TRUE(seen(now.porosity[3], -0.1));
  EXPECT_TRUE(seen(now.position[3][1], -0.01));
  now.pore_pressure[3] = -1.0e6, now.suction[3] = 1.0e6;
  EXPECT_EQ(broken().size(), 1u) << "drier than it was anywhere, without evaporation";
}

TEST_F(Judged, WhatIsElasticDoesNotFail) {
  input.scheme = couple::Scheme::semi_implicit;
  input.skeleton = couple::Skeleton::rigid;
  input.initial_stress = couple::InitialStress::self_weight;
  after.verdict = couple::Verdict::stands;
  EXPECT_TRUE(broken().empty());
  after.verdict = couple::Verdict::fails;
  EXPECT_EQ(broken().size(), 1u);
}

/// Cases that random ones led to: once something was wrong with what came of each.
class Found : public testing::TestWithParam<fs::path> {};

TEST_P(Found, KeepsWhatIsPromised) {
  const Outcome outcome = run_case(GetParam(), {});
  EXPECT_TRUE(outcome.ending == Ending::done || outcome.ending == Ending::budget) << outcome.end;
  EXPECT_EQ(outcome.broken, std::vector<std::string>{});
}

std::vector<fs::path> found_cases() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(SLOPE_RANDOM_TESTS "/found")) files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

INSTANTIATE_TEST_SUITE_P(Case, Found, testing::ValuesIn(found_cases()), [](const auto& instance) {
  std::string name = instance.param.stem().string();
  std::ranges::replace(name, '-', '_');
  return name;
});

}  // namespace
}  // namespace slope::random_cases
