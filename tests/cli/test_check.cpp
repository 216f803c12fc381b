// What slope-sim refuses, and `slope-sim check`.

#include <gtest/gtest.h>

#include <array>

#include "slope_sim_test.hpp"

namespace slope::tools::test {
namespace {

TEST_F(SlopeSim, BadCasesEndWithCode2AndOneMessage) {
  const std::string content = content_of(quick);
  const std::vector<std::array<std::string, 3>> mistakes{
      {"cohesion: 1 kPa", "cohesoin: 1 kPa",
       R"(soils.silty_sand.strength.cohesoin: unknown key, did you mean "cohesion"?)"},
      {"youngs_modulus: 10 MPa", "youngs_modulus: 10",
       R"(soils.silty_sand.youngs_modulus: expected a pressure with its unit, such as "10 kPa" (units: Pa, kPa, MPa, GPa, N/m2, kN/m2, MN/m2), got 10 without a unit)"},
      {"ramp: 1 s", "ramp: 1 m",
       R"(water_boundaries.rain.ramp: expected a time with its unit, such as "20 min" (units: s, min, h, d), got "1 m", which is a length)"},
      {"porosity: 0.35", "porosity: -0.35", "soils.silty_sand.porosity: must be above 0 and below 1, got -0.35"},
      {"crest: [7.5 m, 5 m]", "crest: [7.5 m, 50 m]",
       "points.crest: the point (7.5 m, 50 m) lies outside of the soil; move it into a region of geometry"},
      {"n: 3,", "n: 0.9,", "soils.silty_sand.retention.n: must be above 1, got 0.9"},
      {"geometry:\n  - soil: silty_sand\n    polygon: [[0 m, 0 m], [11 m, 0 m], [11 m, 5 m], [7.2 m, 5 m], [2.5 m, 1 "
       "m], [0 m, 1 m]]",
       "geometry: []", "geometry: needs at least 1 item, got 0"},
  };
  for (const auto& [text, replacement, message] : mistakes) {
    ASSERT_NE(content.find(text), std::string::npos) << text;
    std::string wrong = content;
    wrong.replace(wrong.find(text), text.size(), replacement);
    const fs::path file = write("case.yaml", wrong);
    const auto line =
        1 + std::count(wrong.begin(), wrong.begin() + static_cast<std::ptrdiff_t>(wrong.find(replacement)), '\n');
    for (const auto& arguments : {std::vector<std::string>{"check", file}, {"run", file, "-o", scratch_ / "run"}}) {
      const Outcome outcome = call(arguments);
      EXPECT_EQ(outcome.exit_code, 2) << replacement;
      EXPECT_EQ(outcome.errors, file.string() + ":" + std::to_string(line) + ": " + message + "\n");
      EXPECT_EQ(outcome.output, "");
      EXPECT_FALSE(fs::exists(scratch_ / "run")) << "a wrong case makes no folder";
    }
  }
}

TEST_F(SlopeSim, AFileThatIsNotYamlEndsWithCode2) {
  const fs::path file = write("case.yaml", "title: [1, 2\n");
  const Outcome outcome = call({"check", file});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.errors, file.string() + ":2: not YAML: end of sequence flow not found\n");
}

TEST_F(SlopeSim, AnUnreadableCaseEndsWithCode4) {
  const Outcome outcome = call({"run", (scratch_ / "none.yaml").string(), "-o", (scratch_ / "run").string()});
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_EQ(outcome.errors, (scratch_ / "none.yaml").string() + ": cannot be read: No such file or directory\n");
}

TEST_F(SlopeSim, AnIncludeThatLeadsNowhereEndsWithCode2AndAnUnreadableOneWithCode4) {
  const auto check = [&](const std::string& include) { return call({"check", write("case.yaml", include)}); };
  const std::string place = (scratch_ / "case.yaml").string() + ":1: include: ";
  const Outcome missing = check("include: base.yaml\n");
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_EQ(missing.errors, place + "there is no file " + (scratch_ / "base.yaml").string() +
                                "; the path counts from the folder of this file\n");
  fs::create_directory(scratch_ / "folder");
  const Outcome folder = check("include: folder\n");
  EXPECT_EQ(folder.exit_code, 4);
  EXPECT_EQ(folder.errors, place + (scratch_ / "folder").string() + ": is a folder, not a file\n");
}

TEST_F(SlopeSim, AnUnknownOverrideEndsWithCode2) {
  const Outcome outcome = call({"check", quick, "--set", "stop.tiem=1 s"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.errors, "--set: stop.tiem: unknown key, did you mean \"time\"?\n");
}

TEST_F(SlopeSim, WrongArgumentsEndWithCode2) {
  for (const auto& arguments : std::vector<std::vector<std::string>>{{},
                                                                     {"walk"},
                                                                     {"run", quick},
                                                                     {"run", "-o", "x"},
                                                                     {"run", quick, "-o", "x", "--threads", "0"},
                                                                     {"check"},
                                                                     {"check", quick, "--fast"}}) {
    const Outcome outcome = call(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << (arguments.empty() ? "" : arguments.back());
    EXPECT_NE(outcome.errors, "");
  }
}

TEST_F(SlopeSim, CheckOfAFineCaseSaysWhatItHolds) {
  const Outcome outcome = call({"check", quick});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.output, quick + ": fine: 569 particles of 1 soil on 22 x 12 cells of 0.5 m, until 60 s\n");
}

TEST_F(SlopeSim, CheckPassesOnEveryShippedCase) {
  std::size_t files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(SLOPE_CASES)) {
    if (entry.path().extension() != ".yaml" || entry.path().filename() == "soils.yaml") continue;
    ++files;
    const Outcome outcome = call({"check", entry.path()});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  }
  EXPECT_GE(files, 8u);
}

}  // namespace
}  // namespace slope::tools::test
