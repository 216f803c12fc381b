#include <gtest/gtest.h>

#include "case_folder.hpp"
#include "slope/couple/read_case.hpp"

namespace slope::couple::test {
namespace {

Case slope(const std::vector<std::string>& overrides) {
  return read_case(shipped_cases() / "paper/slope-w2.yaml", overrides);
}

std::string problem_of(const std::string& assignment) {
  try {
    (void)slope({assignment});
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(CaseOverrides, ReplaceValues) {
  const Case input = slope({"stop.time=10 min", "soils.sandy_clay.porosity=0.4"});
  EXPECT_EQ(input.stop.time, 600.0);
  EXPECT_EQ(input.soils.at(0).porosity, 0.4);
}

TEST(CaseOverrides, AddValuesAndMaps) {
  const Case input = slope({"clock.adaptive=false", "stop.after_onset=5 s"});
  EXPECT_FALSE(input.clock.adaptive);
  EXPECT_EQ(input.stop.after_onset, 5.0);
}

TEST(CaseOverrides, ReachListItemsByNumberAndByName) {
  const Case input = slope({"water_boundaries.rain.ramp=7 s", "water_boundaries.0.start=2 s", "domain.upper.1=15 m"});
  EXPECT_EQ(input.water_boundaries.at(0).ramp, 7.0);
  EXPECT_EQ(input.water_boundaries.at(0).start, 2.0);
  EXPECT_EQ(input.domain.upper[1], 15.0);
}

TEST(CaseOverrides, ReplaceWholeMapsAndLists) {
  const Case input = slope({"soils.sandy_clay.strength={model: elastic}", "water_boundaries=[]"});
  EXPECT_TRUE(std::holds_alternative<solid::NoYield>(input.soils.at(0).solid.strength));
  EXPECT_TRUE(input.water_boundaries.empty());
}

TEST(CaseOverrides, TheLastOneHolds) {
  EXPECT_EQ(slope({"stop.time=1 min", "stop.time=2 min"}).stop.time, 120.0);
}

TEST(CaseOverrides, MistakesAreToldAsTheirs) {
  EXPECT_EQ(problem_of("stop.tiem=1 min"), R"(--set: stop.tiem: unknown key, did you mean "time"?)");
  EXPECT_EQ(problem_of("soils.sandy_clay.porosity=2"),
            "--set: soils.sandy_clay.porosity: must be above 0 and below 1, got 2");
  EXPECT_EQ(problem_of("water_boundaries.fog.ramp=1 s"),
            "--set: water_boundaries.fog: water_boundaries has no item of that number or name");
  EXPECT_EQ(problem_of("geometry.1.soil=x"), "--set: geometry.1: geometry has no item of that number or name");
  EXPECT_EQ(problem_of("title.size=3"), "--set: title.size: title is a value and has no keys");
  EXPECT_EQ(problem_of("stop.time={"), "--set: stop.time: not YAML: end of map flow not found");
  for (const char* assignment : {"stop.time", "=1 s", "stop..time=1 s", "stop.time="}) {
    EXPECT_EQ(problem_of(assignment),
              std::string(R"(--set: expected key=value, such as "stop.time=10 min", got ")") + assignment + '"');
  }
}

}  // namespace
}  // namespace slope::couple::test
