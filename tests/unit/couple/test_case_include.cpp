#include <gtest/gtest.h>

#include "case_folder.hpp"
#include "slope/couple/read_case.hpp"

namespace slope::couple::test {
namespace {

/// A folder with the shipped slope W2 as base.yaml.
class CaseInclude : public testing::Test {
 protected:
  CaseInclude() { write("base.yaml", base_); }

  std::filesystem::path write(const std::string& name, const std::string& content) const {
    std::filesystem::create_directories((folder_.path() / name).parent_path());
    return folder_.write(name, content);
  }
  [[nodiscard]] std::string path(const std::string& name) const { return (folder_.path() / name).string(); }

  /// A case that includes base.yaml and says this.
  [[nodiscard]] Case with(const std::string& content, const std::vector<std::string>& overrides = {}) const {
    return read_case(write("case.yaml", "include: base.yaml\n" + content), overrides);
  }
  /// What is said of case.yaml: all problems, one a line, without the folder's name.
  [[nodiscard]] std::string problems(const std::string& content, const std::vector<std::string>& overrides = {}) const {
    std::string text;
    try {
      (void)read_case(write("case.yaml", content), overrides);
    } catch (const InputError& error) {
      text = error.what();
    }
    const std::string folder = folder_.path().string() + "/";
    for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder, at))
      text.erase(at, folder.size());
    return text;
  }
  /// The line of the base in which a text stands.
  [[nodiscard]] std::string base_line(const std::string& text) const {
    return "base.yaml:" + std::to_string(slope_with(text, "").line) + ": ";
  }

  const std::string base_ = slope_with("", "").content;
  const CaseFolder folder_;
};

TEST_F(CaseInclude, AloneGivesTheBase) {
  EXPECT_EQ(resolved_yaml(with("")), resolved_yaml(read_case(path("base.yaml"))));
  EXPECT_EQ(with("").path, path("case.yaml"));
}

TEST_F(CaseInclude, MapsAreMergedKeyByKey) {
  const Case base = read_case(path("base.yaml"));
  Case input = with(
      "title: Another\n"
      "soils:\n  sandy_clay:\n    retention: {alpha: 0.074 1/m}\n    porosity: 0.4\n"
      "clock: {adaptive: false}\n");
  EXPECT_EQ(input.title, "Another");
  EXPECT_EQ(input.soils.at(0).porosity, 0.4);
  EXPECT_EQ(std::get<seepage::VanGenuchten>(input.soils.at(0).seepage.retention).alpha, 0.074);
  EXPECT_FALSE(input.clock.adaptive);
  input.title = base.title;
  input.soils = base.soils;
  input.clock = base.clock;
  EXPECT_EQ(resolved_yaml(input), resolved_yaml(base)) << "nothing else differs";
}

TEST_F(CaseInclude, EntriesWithANewNameAreAdded) {
  const std::string second =
      base_.substr(base_.find("  sandy_clay:"), base_.find("# What is soil") - base_.find("  sandy_clay:"));
  const Case input = with("soils:\n  clay:" + second.substr(second.find('\n')) + "points: {D1: [20 m, 10 m]}\n");
  ASSERT_EQ(input.soils.size(), 2u);
  EXPECT_EQ(input.soils[0].name, "sandy_clay");
  EXPECT_EQ(input.soils[1].name, "clay");
  ASSERT_EQ(input.points.size(), 8u);
  EXPECT_EQ(input.points.back().name, "D1");
}

TEST_F(CaseInclude, ValuesAndListsReplaceThoseOfTheBase) {
  const Case input = with(
      "domain: {upper: [36 m, 15 m]}\n"
      "geometry:\n  - {soil: sandy_clay, polygon: [[0 m, 0 m], [36 m, 0 m], [36 m, 12 m], [22.6 m, 12 m], [0 m, 5 "
      "m]]}\n"
      "points: {C2: [16.3 m, 8 m]}\n"
      "output: {snapshots: [5 s]}\n");
  EXPECT_EQ(input.domain.upper, (Point{36.0, 15.0}));
  EXPECT_EQ(input.domain.lower, (Point{0.0, 0.0}));
  ASSERT_EQ(input.regions.size(), 1u);
  EXPECT_EQ(input.regions[0].polygon.size(), 5u);
  EXPECT_EQ(input.points.at(6).position, (Point{16.3, 8.0}));
  EXPECT_EQ(input.output.snapshots, std::vector<double>{5.0});
  EXPECT_EQ(input.output.history_interval, 1.0);
}

TEST_F(CaseInclude, ListsOfNamedEntriesAreMergedByName) {
  const Case input = with(
      "water_boundaries:\n"
      "  - {name: river, at: left, to: 2 m, total_head: 3 m}\n"
      "  - {name: rain, ramp: 7 s}\n");
  ASSERT_EQ(input.water_boundaries.size(), 2u);
  EXPECT_EQ(input.water_boundaries[0].name, "rain");
  EXPECT_EQ(input.water_boundaries[0].ramp, 7.0);
  EXPECT_EQ(std::get<PrescribedPressure>(input.water_boundaries[0].condition).pressure.at(0.0), 0.0);
  EXPECT_EQ(input.water_boundaries[1].name, "river");
  EXPECT_TRUE(with("water_boundaries: []\n").water_boundaries.empty());
}

TEST_F(CaseInclude, AnotherKindTakesNothingFromTheBase) {
  const Case input = with(
      "soils: {sandy_clay: {strength: {model: elastic}, retention: {model: exponential, alpha: 2 1/m, "
      "residual_saturation: 0.1, maximum_saturation: 1}}}\n"
      "initial: {water: {type: uniform, pressure: -3 kPa}}\n"
      "water_boundaries: [{name: rain, at: ground_surface, flux: 36 mm/h}]\n");
  EXPECT_TRUE(std::holds_alternative<solid::NoYield>(input.soils.at(0).solid.strength));
  EXPECT_TRUE(std::holds_alternative<seepage::ExponentialRetention>(input.soils.at(0).seepage.retention));
  EXPECT_TRUE(std::holds_alternative<UniformWater>(input.initial_water));
  EXPECT_TRUE(std::holds_alternative<PrescribedFlux>(input.water_boundaries.at(0).condition));
  EXPECT_EQ(input.water_boundaries.at(0).ramp, 0.0);
}

TEST_F(CaseInclude, TheSameKindKeepsTheRestOfTheBase) {
  const Case input = with(
      "soils: {sandy_clay: {retention: {model: van_genuchten, alpha: 0.1 1/m}}}\n"
      "water_boundaries: [{name: rain, pressure: -1 kPa}]\n");
  EXPECT_EQ(std::get<seepage::VanGenuchten>(input.soils.at(0).seepage.retention).n, 3.0);
  EXPECT_EQ(std::get<PrescribedPressure>(input.water_boundaries.at(0).condition).pressure.at(0.0), -1000.0);
  EXPECT_EQ(input.water_boundaries.at(0).ramp, 5.0);
}

TEST_F(CaseInclude, OverridesComeOnTop) {
  const Case input = with("stop: {time: 10 min}\nwater_boundaries: [{name: rain, ramp: 7 s}]\n",
                          {"stop.time=20 min", "water_boundaries.rain.start=3 s", "soils.sandy_clay.porosity=0.3"});
  EXPECT_EQ(input.stop.time, 1200.0);
  EXPECT_EQ(input.water_boundaries.at(0).ramp, 7.0);
  EXPECT_EQ(input.water_boundaries.at(0).start, 3.0);
  EXPECT_EQ(input.soils.at(0).porosity, 0.3);
  EXPECT_EQ(problems("include: base.yaml\n", {"include=base.yaml"}),
            "--set: include: stands in a case file only; write it there, or take the base itself");
}

TEST_F(CaseInclude, BasesCanIncludeOthersFromTheirOwnFolders) {
  write("kinds/steep.yaml", "include: ../base.yaml\ntitle: Steep\nstop: {time: 5 min}\n");
  const Case input = read_case(write("case.yaml", "include: kinds/steep.yaml\nstop: {displacement: 1 m}\n"));
  EXPECT_EQ(input.title, "Steep");
  EXPECT_EQ(input.stop.time, 300.0);
  EXPECT_EQ(input.stop.displacement, 1.0);
  EXPECT_EQ(input.points.size(), 7u);
}

TEST_F(CaseInclude, PathsCountFromTheFileThatTheyStandIn) {
  write("data/curves/heads.csv", "z_m,suction_head_m_t300\n");
  write("data/base.yaml", base_ + "figures: {profile_reference: curves/heads.csv}\n");
  const auto reference = [](const Case& input) {
    return std::filesystem::path(input.path).parent_path() / input.figures.profile_reference;
  };
  const std::string including = "include: data/base.yaml\n";
  const Case input = read_case(write("case.yaml", including));
  EXPECT_TRUE(std::filesystem::equivalent(reference(input), path("data/curves/heads.csv")));
  EXPECT_EQ(input.figures.profile_reference, "data/curves/heads.csv");
  write("own.csv", "z_m,suction_head_m_t300\n");
  EXPECT_EQ(
      read_case(write("case.yaml", including + "figures: {profile_reference: own.csv}\n")).figures.profile_reference,
      "own.csv");
  EXPECT_EQ(read_case(write("case.yaml", including), {"figures.profile_reference=own.csv"}).figures.profile_reference,
            "own.csv");
  write("elsewhere/case.yaml", "include: ../data/base.yaml\n");
  EXPECT_EQ(read_case(path("elsewhere/case.yaml")).figures.profile_reference, "../data/curves/heads.csv");
  write("elsewhere/case.yaml", "include: " + path("data/base.yaml") + "\n");
  EXPECT_TRUE(
      std::filesystem::equivalent(reference(read_case(path("elsewhere/case.yaml"))), path("data/curves/heads.csv")));
}

TEST_F(CaseInclude, TheResolvedCaseStandsOnItsOwn) {
  const std::string resolved = resolved_yaml(with("soils: {sandy_clay: {porosity: 0.4}}\n"));
  EXPECT_EQ(resolved.find("include"), std::string::npos);
  EXPECT_NE(resolved.find("porosity: 0.4\n"), std::string::npos);
  EXPECT_EQ(resolved_yaml(read_case(write("elsewhere/case.yaml", resolved))), resolved);
}

TEST_F(CaseInclude, ProblemsNameTheFileAndTheLineThatTheyStandIn) {
  EXPECT_EQ(problems("include: base.yaml\nsoils:\n  sandy_clay:\n    porosity: 2\n"),
            "case.yaml:4: soils.sandy_clay.porosity: must be above 0 and below 1, got 2");
  write("base.yaml", slope_with("cohesion: 1 kPa", "cohesoin: 1 kPa").content);
  EXPECT_EQ(
      problems("include: base.yaml\nsoils:\n  sandy_clay:\n    porosity: 2\nwater_boundaries:\n"
               "  - {name: rain, ramp: 7}\n"),
      "case.yaml:4: soils.sandy_clay.porosity: must be above 0 and below 1, got 2\n"
      "case.yaml:6: water_boundaries.rain.ramp: expected a time with its unit, such as \"20 min\" (units: s, min, "
      "h, d), got 7 without a unit\n" +
          base_line("cohesion: 1 kPa") + "soils.sandy_clay.strength.cohesoin: unknown key, did you mean \"cohesion\"?");
}

TEST_F(CaseInclude, ProblemsOfOverridesComeFirst) {
  write("base.yaml", slope_with("porosity: 0.35", "porosity: 2").content);
  EXPECT_EQ(problems("include: base.yaml\nstop: {time: 0 s}\n", {"clock.adaptive=maybe"}),
            "--set: clock.adaptive: expected true or false, got \"maybe\"\n"
            "case.yaml:2: stop.time: must be above 0 s, got 0 s\n" +
                base_line("porosity: 0.35") + "soils.sandy_clay.porosity: must be above 0 and below 1, got 2");
}

TEST_F(CaseInclude, ChecksOfSeveralKeysBlameTheFileOfTheKey) {
  EXPECT_EQ(problems("include: base.yaml\nstop: {time: 10 s}\noutput: {snapshots: [1 min]}\n"),
            "case.yaml:3: output.snapshots.0: 60 s is after the end of the run, stop.time = 10 s");
  EXPECT_EQ(problems("include: base.yaml\ndomain: {upper: [36 m, 10 m]}\n"),
            base_line("    polygon: ") +
                "geometry.0.polygon.2: the corner (36 m, 12 m) is outside of the domain, which goes from (0 m, 0 m) to "
                "(36 m, 10 m)\n" +
                base_line("    polygon: ") +
                "geometry.0.polygon.3: the corner (22.6 m, 12 m) is outside of the domain, which goes from (0 m, 0 m) "
                "to (36 m, 10 m)");
}

TEST_F(CaseInclude, ANameGivenTwiceIsTold) {
  EXPECT_EQ(problems("include: base.yaml\nwater_boundaries:\n  - {name: rain, ramp: 7 s}\n"
                     "  - {name: rain, at: left, pressure: 0 kPa}\n"),
            "case.yaml:4: water_boundaries.rain.name: \"rain\" is the name of an earlier one; choose another");
}

TEST_F(CaseInclude, AMissingKeyOfAMergedMapIsToldOnce) {
  write("base.yaml", slope_with("    porosity: 0.35\n", "").content);
  EXPECT_EQ(problems("include: base.yaml\nsoils:\n  sandy_clay: {poissons_ratio: 0.3}\n"),
            "case.yaml:3: soils.sandy_clay.porosity: missing; write for example \"porosity: 0.35\"");
}

TEST_F(CaseInclude, AnIncludeThatIsNoPathIsTold) {
  const std::string expected = "include: expected the path of a case file, such as \"base.yaml\", got ";
  EXPECT_EQ(problems("title: x\ninclude: 3\n"), "case.yaml:2: " + expected + "\"3\"");
  EXPECT_EQ(problems("include: true\n"), "case.yaml:1: " + expected + "\"true\"");
  EXPECT_EQ(problems("include: ''\n"), "case.yaml:1: " + expected + "\"\"");
  EXPECT_EQ(problems("include:\n"), "case.yaml:1: " + expected + "nothing");
  EXPECT_EQ(problems("include: [base.yaml]\n"), "case.yaml:1: " + expected + "a list");
  EXPECT_EQ(problems("include: {file: base.yaml}\n"), "case.yaml:1: " + expected + "a map of keys");
  EXPECT_TRUE(
      problems("inclde: base.yaml\n").starts_with("case.yaml:1: inclde: unknown key, did you mean \"include\"?\n"));
}

TEST_F(CaseInclude, AMissingBaseIsTold) {
  EXPECT_EQ(problems("title: x\ninclude: bsae.yaml\n"),
            "case.yaml:2: include: there is no file bsae.yaml; the path counts from the folder of this file");
  write("middle.yaml", "include: none.yaml\n");
  EXPECT_EQ(problems("include: middle.yaml\n"),
            "middle.yaml:1: include: there is no file none.yaml; the path counts from the folder of this file");
}

TEST_F(CaseInclude, ABaseThatCannotBeReadIsAFileErrorWithThePlaceOfTheInclude) {
  std::filesystem::create_directory(path("folder"));
  try {
    (void)read_case(write("case.yaml", "title: x\ninclude: folder\n"));
    FAIL() << "a folder was read as a case";
  } catch (const FileError& error) {
    EXPECT_EQ(error.what(), path("case.yaml") + ":2: include: " + path("folder") + ": is a folder, not a file");
  }
}

TEST_F(CaseInclude, ABaseThatIsNoCaseIsTold) {
  write("base.yaml", "# nothing\n");
  EXPECT_EQ(problems("include: base.yaml\n"), "base.yaml: the file is empty");
  write("base.yaml", "- 1\n");
  EXPECT_EQ(problems("include: base.yaml\n"), "base.yaml:1: expected a map of keys, got a list");
  write("base.yaml", "title: [1, 2\n");
  EXPECT_EQ(problems("include: base.yaml\n"), "base.yaml:2: not YAML: end of sequence flow not found");
}

TEST_F(CaseInclude, ACircleIsTold) {
  EXPECT_EQ(problems("title: x\ninclude: case.yaml\n"),
            "case.yaml:2: include: goes in a circle: case.yaml -> case.yaml; remove one of these includes");
  write("a.yaml", "include: b.yaml\n");
  write("b.yaml", "title: x\ninclude: ./a.yaml\n");
  EXPECT_EQ(problems("include: a.yaml\n"),
            "b.yaml:2: include: goes in a circle: a.yaml -> b.yaml -> a.yaml; remove one of these includes");
}

}  // namespace
}  // namespace slope::couple::test
