#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "case_folder.hpp"
#include "slope/couple/read_case.hpp"

namespace slope::couple::test {
namespace {

std::vector<Problem> problems_of(const std::filesystem::path& file, const std::vector<std::string>& overrides = {}) {
  try {
    (void)read_case(file, overrides);
  } catch (const InputError& error) {
    return error.problems();
  }
  return {};
}

TEST(CaseProblems, AReferenceThatIsNotThereIsTold) {
  const CaseFolder folder;
  const ChangedCase changed = slope_with("output:\n", "figures: {profile_reference: measured.csv}\noutput:\n");
  const auto file = folder.write("slope.yaml", changed.content);
  const auto problems = problems_of(file);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].text(), file.string() + ":" + std::to_string(changed.line) +
                                    ": figures.profile_reference: there is no file " +
                                    (folder.path() / "measured.csv").string());
}

TEST(CaseProblems, AreAllToldAtOnceInTheOrderOfTheFile) {
  const CaseFolder folder;
  std::string content = slope_with("porosity: 0.35", "porosity: 2").content;
  for (const auto& [text, replacement] :
       std::vector<std::pair<std::string, std::string>>{{"title:", "titel:"},
                                                        {"cell_size: 0.5 m", "cell_size: 0.5"},
                                                        {"  time: 40 min\n", ""},
                                                        {"n: 3\n", "n: 0.5\n"}}) {
    content.replace(content.find(text), text.size(), replacement);
  }
  const auto problems = problems_of(folder.write("slope.yaml", content));
  std::vector<std::string> keys;
  for (const Problem& problem : problems) keys.push_back(problem.key);
  EXPECT_EQ(keys, (std::vector<std::string>{"titel", "domain.cell_size", "soils.sandy_clay.porosity",
                                            "soils.sandy_clay.retention.n", "stop.time"}));
  EXPECT_TRUE(
      std::is_sorted(problems.begin(), problems.end(), [](const auto& a, const auto& b) { return a.line < b.line; }));
}

TEST(CaseProblems, AnEmptyCaseIsToldEveryKeyThatItNeeds) {
  const CaseFolder folder;
  const auto problems = problems_of(folder.write("case.yaml", "title: nothing yet\n"));
  std::vector<std::string> keys;
  for (const Problem& problem : problems) {
    keys.push_back(problem.key);
    EXPECT_TRUE(problem.message.starts_with("missing; write for example \"" + problem.key + ": ")) << problem.message;
  }
  EXPECT_EQ(keys, (std::vector<std::string>{"domain", "walls", "soils", "geometry", "initial", "stop"}));
}

TEST(CaseProblems, JakysFormulaNeedsAFrictionAngle) {
  const auto file = shipped_cases() / "quick.yaml";
  EXPECT_TRUE(problems_of(file, {"initial.stress=k0"}).empty());
  const auto problems = problems_of(
      file, {"initial.stress=k0", "soils.silty_sand.strength={model: von_mises, undrained_strength: 9 kPa}"});
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].key, "initial.k0_coefficient");
  EXPECT_EQ(problems[0].message,
            R"(missing; the soil "silty_sand" has no friction angle for Jaky's formula; write for example )"
            R"("k0_coefficient: 0.5")");
}

TEST(CaseProblems, AFactorOfSafetyNeedsStrengthThatCanBeReduced) {
  const auto file = shipped_cases() / "quick.yaml";
  const auto strength = [](const std::string& law) { return "soils.silty_sand.strength={model: " + law + "}"; };
  EXPECT_TRUE(problems_of(file, {"safety.times=[0 s]"}).empty());
  EXPECT_TRUE(problems_of(file, {strength("elastic"), "safety.tolerance=0.01"}).empty()) << "none is asked for";
  auto problems = problems_of(file, {strength("elastic"), "safety.interval=10 s"});
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].key, "safety");
  EXPECT_EQ(problems[0].message, "no soil has a strength that could be reduced: all are elastic");
  problems = problems_of(file, {strength("modified_cam_clay, critical_state_ratio: 1, lambda: 0.2, kappa: 0.04, "
                                         "minimum_mean_stress: 5 kPa, overconsolidation_ratio: 2"),
                                "safety.times=[0 s]"});
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].key, "safety");
  EXPECT_EQ(problems[0].message,
            R"(strength reduction is not defined for modified_cam_clay, the strength of soil "silty_sand"; give it )"
            R"(another strength, or ask for no factor of safety)");
}

/// Files that hold no case at all.
struct NoCase {
  const char* what;
  std::string content;
  const char* rest;  ///< of the message, after the file's name
};

std::ostream& operator<<(std::ostream& out, const NoCase& file) {
  return out << file.what;
}

class NoCaseAtAll : public testing::TestWithParam<NoCase> {};

TEST_P(NoCaseAtAll, GetsOneMessage) {
  const CaseFolder folder;
  const auto file = folder.write("case.yaml", GetParam().content);
  const auto problems = problems_of(file);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].text(), file.string() + GetParam().rest);
}

const NoCase no_cases[] = {
    {"Empty", "", ": the file is empty"},
    {"OnlyComments", "# nothing\n", ": the file is empty"},
    {"OpenBracket", "title: [1, 2\nwalls: x\n", ":2: not YAML: end of sequence flow not found"},
    {"Tab", "title: x\n\twalls: y\n", ":2: not YAML: illegal tab when looking for indentation"},
    {"Words", "a slope\n", ":1: expected a map of keys, got \"a slope\""},
    {"List", "- 1\n", ":1: expected a map of keys, got a list"},
    {"Bytes",
     std::string("\x7f"
                 "ELF\0\1",
                 6),
     ": not YAML: it has bytes that no text has"},
    {"TwoDocuments", "title: x\n---\ntitle: y\n", ":3: a second YAML document begins here; a case is one document"},
    {"AnchorInItself", "title: &a [*a]\n", ":1: nested too deeply for a case file"},
};
INSTANTIATE_TEST_SUITE_P(Files, NoCaseAtAll, testing::ValuesIn(no_cases),
                         [](const auto& instance) { return instance.param.what; });

TEST(CaseProblems, AFileThatCannotBeReadIsAFileError) {
  const CaseFolder folder;
  EXPECT_THROW((void)read_case(folder.path() / "none.yaml"), FileError);
  EXPECT_THROW((void)read_case(folder.path()), FileError);
  try {
    (void)read_case(folder.path() / "none.yaml");
  } catch (const FileError& error) {
    EXPECT_EQ(error.what(), (folder.path() / "none.yaml").string() + ": cannot be read: No such file or directory");
  }
}

/// Water above the ground is held by a reservoir of that level or by a pressure there, whatever moves.
TEST(WaterTable, AboveTheGroundIsHeldOrRefused) {
  const auto problems = [](const std::string& water, const std::string& boundary, const std::string& scheme) {
    std::vector<std::string> keys;
    try {
      (void)read_case(shipped_cases() / "paper/slope-w2.yaml",
                      {"initial.water=" + water, "water_boundaries=[" + boundary + "]", "coupling.scheme=" + scheme});
    } catch (const InputError& error) {
      for (const Problem& problem : error.problems()) keys.push_back(problem.key);
    }
    return keys;
  };
  using Keys = std::vector<std::string>;
  const std::string level = "{type: hydrostatic, water_table: 7 m}";
  const std::string line = "{type: water_table, points: [[0 m, 7 m], [36 m, 7 m]]}";
  const std::string uniform = "{type: uniform, pressure: 15 kPa}";
  const std::string lake = "{name: lake, at: free_surface, initial: true, reservoir: {level: ";
  const std::string ground = "{name: ground, at: ground_surface, ";
  for (const std::string scheme : {"semi_implicit", "seepage"}) {
    for (const auto& [water, key] : {std::pair(level, "water_table"), std::pair(line, "points")}) {
      EXPECT_EQ(problems(water, "", scheme), Keys{std::string("initial.water.") + key});
      EXPECT_EQ(problems(water, lake + "7 m}}", scheme), Keys{});
      EXPECT_EQ(problems(water, lake + "6 m}}", scheme).size(), 1u) << "a lower lake";
      EXPECT_EQ(problems(water, ground + "total_head: 7 m}", scheme), Keys{});
      EXPECT_EQ(problems(water, ground + "pressure: 0 kPa}", scheme).size(), 1u);
    }
    EXPECT_EQ(problems(uniform, "", scheme), Keys{"initial.water.pressure"});
    EXPECT_EQ(problems(uniform, ground + "pressure: 0 kPa}", scheme), Keys{}) << "consolidation";
    EXPECT_EQ(problems("{type: uniform, pressure: -15 kPa}", "", scheme), Keys{});
  }
}

/// A mistake in a file of rain, and what is said about it after the file's name.
TEST(Hyetograph, FileGetsOneMessageWithItsLine) {
  const std::string header =
      "expected a header such as \"time_h,intensity_mm_per_h\" (time in s, min, h or d; intensity in mm or m per s, h "
      "or d)";
  const std::string parted = ", columns parted by a comma, decimals by a point; got ";
  const auto numbers = [&](int line) {
    return ":" + std::to_string(line) + ": expected two numbers, a time and the intensity from then on" + parted;
  };
  const std::vector<std::pair<std::string, std::string>> mistakes{
      {"", ": holds no row; " + header},
      {"0,1\n", ":1: " + header + parted + "\"0,1\""},
      {"# rain\ntime_h,intensity_mm\n0,1\n", ":2: " + header + parted + "\"time_h,intensity_mm\""},
      {"time_h;intensity_mm_per_h\n0;1\n", ":1: " + header + parted + "\"time_h;intensity_mm_per_h\""},
      {"time_h,intensity_mm_per_h\n0,1\n2\n", numbers(3) + "\"2\""},
      {"time_h,intensity_mm_per_h\n0,0,5\n", numbers(2) + "\"0,0,5\""},
      {"time_h,intensity_mm_per_h\n0,a lot\n", numbers(2) + "\"0,a lot\""},
      {"time_h,intensity_mm_per_h\n0,1\n2,3\n2,4\n", ":4: times must grow from row to row"},
      {"time_h,intensity_mm_per_h\n0,1\n1,-999\n2,0\n",
       ":3: \"-999\" stands for a missing value; write what fell then, 0 if nothing did"},
      {"time_h,intensity_mm_per_h\n0,1\n1,\n2,0\n",
       ":3: \"\" stands for a missing value; write what fell then, 0 if nothing did"},
      {"time_h,intensity_mm_per_h\n0,NaN\n2,0\n",
       ":2: \"NaN\" stands for a missing value; write what fell then, 0 if nothing did"}};
  const CaseFolder folder;
  const auto file = folder.write("slope.yaml", slope_with("at: ground_surface, pressure: 0 kPa, applied_to: particle",
                                                          "at: free_surface, rain: {file: storm.csv}")
                                                   .content);
  const std::string path = (folder.path() / "storm.csv").string();
  auto problems = problems_of(file);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].key, "water_boundaries.rain.rain.file");
  EXPECT_EQ(problems[0].message, "the file " + path + " cannot be read; the path counts from the case's folder");
  for (const auto& [content, message] : mistakes) {
    folder.write("storm.csv", content);
    problems = problems_of(file);
    ASSERT_EQ(problems.size(), 1u) << content;
    EXPECT_EQ(problems[0].message, path + message);
  }
}

class RainTables : public testing::Test {
 protected:
  /// The problems, or else the warnings, of the slope under the rain of a table.
  std::vector<std::string> told_of(const std::string& rows, const std::string& more = "",
                                   const std::string& stop = "40 min") {
    folder_.write("gauge.csv", "time_min,intensity_mm_per_h\n" + rows);
    const auto file =
        folder_.write("slope.yaml", slope_with("at: ground_surface, pressure: 0 kPa, applied_to: particle",
                                               "at: free_surface, rain: {file: gauge.csv" + more + "}")
                                        .content);
    std::vector<Problem> found;
    try {
      read_ = read_case(file, {"stop.time=" + stop}, &found);
    } catch (const InputError& error) {
      found = error.problems();
    }
    std::vector<std::string> texts;
    for (const Problem& problem : found) texts.push_back(problem.text().substr(folder_.path().string().size() + 1));
    return texts;
  }
  [[nodiscard]] const std::vector<RainStep>& steps() const {
    return std::get<Rain>(read_.water_boundaries.at(0).condition).hyetograph;
  }

  CaseFolder folder_;
  Case read_;
};

using Texts = std::vector<std::string>;

TEST_F(RainTables, MustSayWhatComesAfterALastRowThatIsWet) {
  const std::string wet = "0,2\n10,2\n20,4\n";
  const auto told = told_of(wet);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_NE(told[0].find("water_boundaries.rain.rain.file: the last row, 4 mm/h from 0.333333 h on, would hold until "
                         "stop.time, 0.666667 h; end the table with a row of 0, or say \"after_table: dry\" or "
                         "\"after_table: last_row\""),
            std::string::npos)
      << told[0];
  EXPECT_EQ(told_of(wet, ", after_table: last_row"), Texts{});
  EXPECT_EQ(steps().size(), 3u);
  EXPECT_EQ(told_of(wet, ", after_table: dry"), Texts{});
  ASSERT_EQ(steps().size(), 4u);
  EXPECT_EQ(steps()[3].time, 1800.0) << "the last row lasts as long as the others";
  EXPECT_EQ(steps()[3].intensity, 0.0);
  EXPECT_EQ(told_of(wet + "30,0\n"), Texts{});
  EXPECT_EQ(told_of(wet, "", "30 min"), Texts{}) << "the run ends with the row";
  EXPECT_EQ(told_of(wet, "", "31 min").size(), 1u);
  EXPECT_EQ(told_of("0,2\n").size(), 1u) << "nobody knows how long";
  EXPECT_EQ(told_of("0,-0.1\n10,-0.2\n").size(), 1u) << "evaporation too";
  EXPECT_NE(told_of("0,2\n", ", after_table: dry").at(0).find("a table of one row does not say how long that lasts"),
            std::string::npos);
}

TEST_F(RainTables, AreWarnedOfGapsThatHoldRain) {
  const std::string even = "0,0\n1,2\n2,3\n3,1\n4,1\n5,0\n6,0\n";
  EXPECT_EQ(told_of(even), Texts{});
  EXPECT_EQ(told_of(even + "7,0\r\n"), Texts{});
  const auto told = told_of("0,0\n1,2\n2,3\n3,1\n4,1\n9,2\n10,0\n");
  ASSERT_EQ(told.size(), 1u);
  EXPECT_TRUE(
      told[0].starts_with("gauge.csv:7: water_boundaries.rain.rain.file: comes 0.0833333 h after the row before, "
                          "where 0.0166667 h are usual, and what fell then, 1 mm/h, is held all the time"))
      << told[0];
  EXPECT_EQ(told_of("0,0\n1,2\n2,3\n3,1\n4,0\n9,2\n10,0\n"), Texts{}) << "a gap that holds no rain";
  EXPECT_EQ(told_of("0,1\n6,2\n8,3\n20,4\n22,1\n30,0\n"), Texts{}) << "steps, not intervals of a gauge";
}

TEST_F(RainTables, AreWarnedOfWhatNoSkyAndNoAirDo) {
  EXPECT_EQ(told_of("0,499\n1,0\n"), Texts{});
  EXPECT_TRUE(
      told_of("0,501\n1,0\n")
          .at(0)
          .starts_with(
              "gauge.csv:2: water_boundaries.rain.rain.file: 501 mm/h is more than any rain; is the unit right?"));
  EXPECT_NE(told_of("0,2\n1,-1\n2,0\n").at(0).find("gauge.csv:3"), std::string::npos);
  EXPECT_NE(told_of("0,2\n1,-1\n2,0\n").at(0).find("evaporates 24 mm/d, more than any air does"), std::string::npos);
  EXPECT_EQ(told_of("0,2\n1,-0.5\n2,0\n"), Texts{});
}

TEST_F(RainTables, KeepTheirKeysForTables) {
  const auto file =
      folder_.write("slope.yaml", slope_with("at: ground_surface, pressure: 0 kPa, applied_to: particle",
                                             "at: free_surface, rain: {intensity: 1 mm/h, after_table: dry}")
                                      .content);
  const auto problems = problems_of(file);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].message, "has a meaning only with a file; remove it");
  std::vector<Problem> warnings;
  const auto odd =
      folder_.write("odd.yaml", slope_with("at: ground_surface, pressure: 0 kPa, applied_to: particle",
                                           "at: free_surface, rain: {hyetograph: [[0 h, 1 m/h], [1 h, 0 mm/h]]}")
                                    .content);
  (void)read_case(odd, {}, &warnings);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].key, "water_boundaries.rain.rain.hyetograph.0");
}

}  // namespace
}  // namespace slope::couple::test
