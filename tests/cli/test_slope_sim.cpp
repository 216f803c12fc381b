#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>
#include <thread>

#include "particle_file.hpp"
#include "program.hpp"
#include "slope/couple/read_case.hpp"
#include "slope/couple/results.hpp"

namespace slope::tools::test {
namespace {

namespace fs = std::filesystem;

const std::string quick = std::string(SLOPE_CASES) + "/quick.yaml";
const std::string box = std::string(SLOPE_CLI_TESTS) + "/box.yaml";

/// Each test works in a folder of its own.
class SlopeSim : public testing::Test {
 protected:
  SlopeSim() {
    std::string name = (fs::temp_directory_path() / "slope-sim-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no folder can be made at " + name);
    scratch_ = name;
  }
  ~SlopeSim() override {
    std::error_code ignored;
    fs::remove_all(scratch_, ignored);
  }

  [[nodiscard]] Outcome call(const std::vector<std::string>& arguments) const { return slope_sim(arguments, scratch_); }
  [[nodiscard]] Outcome run_box(const fs::path& out, std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"run", box, "-o", out.string()});
    return call(more);
  }
  fs::path write(const std::string& name, const std::string& content) const {
    std::ofstream(scratch_ / name) << content;
    return scratch_ / name;
  }
  [[nodiscard]] static couple::RunSummary summary_of(const fs::path& out) {
    return couple::read_summary(out / "summary.json");
  }
  [[nodiscard]] static std::vector<std::string> lines_of(const fs::path& file) {
    std::istringstream stream(content_of(file));
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
  }
  /// Every row of the history is whole.
  static void expect_whole_history(const fs::path& out, std::size_t least_rows) {
    EXPECT_TRUE(content_of(out / "history.csv").ends_with('\n'));
    const auto lines = lines_of(out / "history.csv");
    ASSERT_GE(lines.size(), least_rows + 1);
    for (const std::string& line : lines) {
      EXPECT_EQ(std::count(line.begin(), line.end(), ','), std::count(lines[0].begin(), lines[0].end(), ',')) << line;
    }
  }

  fs::path scratch_;
};

TEST_F(SlopeSim, TellsOfSoilThatItsWeightCrushesBeforeTheStart) {
  const Outcome outcome =
      call({"run", quick, "-o", (scratch_ / "soft").string(), "--set", "soils.silty_sand.youngs_modulus=1 kPa", "--set",
            "soils.silty_sand.strength={model: elastic}"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_NE(outcome.errors.find("before the start: soil particle"), std::string::npos) << outcome.errors;
  EXPECT_NE(outcome.errors.find("youngs_modulus"), std::string::npos);
}

TEST_F(SlopeSim, SaysSoIfTheSlopeDoesNotStandBeforeTheStart) {
  EXPECT_EQ(
      call({"run", quick, "-o", (scratch_ / "stands").string(), "--set", "stop.time=0.01 s"}).errors.find("no balance"),
      std::string::npos);
  const Outcome weak = call({"run", quick, "-o", (scratch_ / "weak").string(), "--set", "stop.time=0.01 s", "--set",
                             "initial.water={type: uniform, pressure: 0 kPa}", "--set",
                             "soils.silty_sand.strength.friction_angle=12 deg"});
  EXPECT_EQ(weak.exit_code, 0);
  EXPECT_NE(weak.errors.find("does not stand before the rain: no balance was found, 15 % of the weight"),
            std::string::npos)
      << weak.errors;
  EXPECT_NE(weak.output.find("  verdict          does not stand before the rain"), std::string::npos) << weak.output;
  EXPECT_EQ(summary_of(scratch_ / "weak").found.verdict, couple::Verdict::does_not_stand);
}

TEST_F(SlopeSim, RainIsBookedInTheBudget) {
  const fs::path out = scratch_ / "rain";
  const Outcome outcome = run_box(
      out, {"--set", "water_boundaries=[{name: rain, at: free_surface, rain: {hyetograph: [[0.1 s, 36 mm/h]]}}]"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  const auto lines = lines_of(out / "budget.csv");
  ASSERT_EQ(lines.size(), lines_of(out / "history.csv").size());
  EXPECT_TRUE(lines[0].starts_with("time [s],rain [m3/m],rain infiltration [m3/m],run-off [m3/m],seepage [m3/m],"));
  EXPECT_TRUE(lines[3].starts_with("0.1,0,0,0,")) << lines[3];
  EXPECT_TRUE(lines[0].ends_with("storage [m3/m],balance error [m3/m]")) << lines[0];
  const couple::WaterBudget water = summary_of(out).found.water;
  EXPECT_NEAR(water.rain, 1.0e-5 * 2.0 * 0.1, 1e-12) << "36 mm/h on 2 m for 0.1 s";
  EXPECT_NEAR(water.rain_infiltration + water.run_off, water.rain, 1e-12);
  EXPECT_NE(outcome.output.find("infiltrated"), std::string::npos) << outcome.output;
}

TEST_F(SlopeSim, RunFillsAFolderThatStandsOnItsOwn) {
  const fs::path out = scratch_ / "new" / "run";
  const Outcome outcome = run_box(out, {"--set", "stop.time=0.15 s"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;

  const couple::Case again = couple::read_case(out / "case.yaml");
  EXPECT_EQ(again.stop.time, 0.15) << "overrides are part of the resolved case";
  const auto lines = lines_of(out / "history.csv");
  ASSERT_EQ(lines.size(), 5u) << "a header and rows at 0, 0.05, 0.1 and 0.15 s";
  EXPECT_TRUE(lines[0].starts_with("time [s],"));
  EXPECT_NE(lines[0].find("top displacement [m]"), std::string::npos);
  EXPECT_NE(lines[0].find("top suction [Pa]"), std::string::npos);
  EXPECT_TRUE(lines[1].starts_with("0,"));
  EXPECT_TRUE(lines[4].starts_with("0.15,"));
  expect_whole_history(out, 4);

  const auto series = read_particle_series(out);
  ASSERT_EQ(series.size(), 2u);
  EXPECT_EQ(series.front().label, "start");
  EXPECT_EQ(series.front().time, 0.0);
  EXPECT_EQ(series.back().label, "end");
  EXPECT_NEAR(series.back().time, 0.15, 1e-12);

  const couple::Summary found = summary_of(out).found;
  EXPECT_EQ(found.end_reason, couple::EndReason::time);
  EXPECT_EQ(found.particles, 32u);
  EXPECT_GT(found.steps, 0u);
  EXPECT_FALSE(found.onset_time);
  EXPECT_NE(content_of(out / "log.txt").find("--set stop.time=0.15 s"), std::string::npos);
  EXPECT_TRUE(outcome.output.starts_with("A box of wet soil\n  verdict          stands until the end, 0.15 s\n"))
      << outcome.output;
}

TEST_F(SlopeSim, RunOfTheResolvedCaseInItsOwnFolderGivesTheSame) {
  const fs::path out = scratch_ / "run";
  ASSERT_EQ(run_box(out).exit_code, 0);
  const std::string resolved = content_of(out / "case.yaml");
  const std::string history = content_of(out / "history.csv");
  ASSERT_EQ(call({"run", (out / "case.yaml").string(), "-o", out.string(), "--overwrite"}).exit_code, 0);
  EXPECT_EQ(content_of(out / "case.yaml"), resolved);
  EXPECT_EQ(content_of(out / "history.csv"), history);
}

TEST_F(SlopeSim, RunOfACaseThatIncludesLeavesOneThatDoesNot) {
  const fs::path out = scratch_ / "run";
  const fs::path file = write("case.yaml", "include: " + box + "\nstop: {time: 0.05 s}\n");
  const Outcome outcome = call({"run", file, "-o", out, "--set", "soils.clay.porosity=0.4"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ(content_of(out / "case.yaml").find("include"), std::string::npos);
  const couple::Case again = couple::read_case(out / "case.yaml");
  EXPECT_EQ(again.title, "A box of wet soil");
  EXPECT_EQ(again.stop.time, 0.05);
  EXPECT_EQ(again.soils.at(0).porosity, 0.4);
}

TEST_F(SlopeSim, TheReferenceOfTheFiguresGoesAlong) {
  const fs::path out = scratch_ / "column";
  const Outcome outcome = call({"run", std::string(SLOPE_CASES) + "/paper/liakopoulos.yaml", "-o", out.string(),
                                "--set", "stop.time=0.01 s", "--set", "output.snapshots=[]", "--set",
                                "figures.profile_times=[0.01 s]", "--set", "initial.stress=none"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  const couple::Case again = couple::read_case(out / "case.yaml");
  EXPECT_EQ(fs::path(again.figures.profile_reference).parent_path(), "");
  EXPECT_TRUE(fs::is_regular_file(out / again.figures.profile_reference));
}

TEST_F(SlopeSim, QuietRunPrintsNothing) {
  const Outcome outcome = run_box(scratch_ / "run", {"--quiet"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.output + outcome.errors, "");
}

TEST_F(SlopeSim, AnEarlierRunIsReplacedIfThatIsAskedFor) {
  const fs::path out = scratch_ / "run";
  ASSERT_EQ(run_box(out, {"--set", "output.snapshot_interval=0.05 s"}).exit_code, 0);
  ASSERT_GT(read_particle_series(out).size(), 2u);
  const std::string history = content_of(out / "history.csv");
  const Outcome refused = run_box(out);
  EXPECT_EQ(refused.exit_code, 4);
  EXPECT_EQ(refused.errors,
            out.string() + ": holds an earlier run; --resume goes on with it, --overwrite replaces it\n");
  EXPECT_EQ(content_of(out / "history.csv"), history);
  ASSERT_EQ(run_box(out, {"--overwrite"}).exit_code, 0);
  EXPECT_EQ(read_particle_series(out).size(), 2u);
  EXPECT_FALSE(fs::exists(out / "particles_0002.vtp"));
}

TEST_F(SlopeSim, AFolderWithSomethingElseIsLeftAlone) {
  const fs::path out = scratch_ / "thesis";
  fs::create_directory(out);
  std::ofstream(out / "history.csv") << "precious";
  const Outcome outcome = run_box(out);
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_EQ(outcome.errors, out.string() + ": holds something else than a run of slope-sim; choose another folder\n");
  EXPECT_EQ(content_of(out / "history.csv"), "precious");
}

TEST_F(SlopeSim, AFolderThatCannotBeMadeIsToldWithCode4) {
  const fs::path file = write("file", "");
  const Outcome outcome = run_box(file / "run");
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_EQ(outcome.errors, (file / "run").string() + ": cannot be used as output folder: Not a directory\n");
}

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

TEST_F(SlopeSim, NewWritesACaseThatIsFineAndRuns) {
  const fs::path file = scratch_ / "mine.yaml";
  const Outcome outcome = call({"new", file});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ(outcome.output, file.string() + ": written; slope-sim run " + file.string() + " -o results\n");
  const Outcome check = call({"check", file});
  EXPECT_EQ(check.exit_code, 0) << check.errors;
  EXPECT_EQ(check.errors, "");
  const Outcome run = call({"run", file, "-o", scratch_ / "run", "--set", "stop.time=1 s"});
  EXPECT_EQ(run.exit_code, 0) << run.errors;
}

TEST_F(SlopeSim, WhatTheNewCaseCommentsOutIsFineToo) {
  const fs::path file = scratch_ / "mine.yaml";
  ASSERT_EQ(call({"new", file}).exit_code, 0);
  std::string content = content_of(file);
  for (const std::string key :
       {"gravity: 9.81", "water:\n", "  density: 1000", "  bulk_modulus: 2 GPa", "maximum_suction: 50", "from: 0 m",
        "to: 11 m", "loads:\n", "  - {name: fill", "after_onset: 10", "snapshots: [5 s"}) {
    const std::size_t at = content.find("# " + key);
    ASSERT_NE(at, std::string::npos) << key;
    content.erase(at, 2);
  }
  const Outcome check = call({"check", write("all.yaml", content)});
  EXPECT_EQ(check.exit_code, 0) << check.errors;
}

TEST_F(SlopeSim, NewLeavesAnExistingFileAlone) {
  const fs::path file = write("mine.yaml", "precious");
  const Outcome outcome = call({"new", file});
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_EQ(outcome.errors, file.string() + ": exists already; choose another name\n");
  EXPECT_EQ(content_of(file), "precious");
  EXPECT_EQ(call({"new", scratch_ / "none" / "mine.yaml"}).exit_code, 4);
}

/// A VTK file with these points (x y z) and these lines (numbers of points).
std::string poly_lines(const std::vector<std::string>& points, const std::vector<std::vector<int>>& lines) {
  std::string all, connectivity, offsets;
  for (const std::string& point : points) all += point + " ";
  std::size_t end = 0;
  for (const auto& line : lines) {
    for (const int point : line) connectivity += std::to_string(point) + " ";
    offsets += std::to_string(end += line.size()) + " ";
  }
  return "<VTKFile type=\"PolyData\" version=\"0.1\"><PolyData><Piece NumberOfPoints=\"" +
         std::to_string(points.size()) + "\" NumberOfLines=\"" + std::to_string(lines.size()) +
         "\"><Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">" + all +
         "</DataArray></Points><Lines><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">" +
         connectivity + "</DataArray><DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">" + offsets +
         "</DataArray></Lines></Piece></PolyData></VTKFile>\n";
}

TEST_F(SlopeSim, ProfileTurnsAPolyLineIntoATable) {
  const fs::path table = scratch_ / "ground.csv";
  const std::vector<std::string> points{"11 5 0", "0 1 0", "2.5 1 0", "7.2 5 0"};
  for (const auto& lines : std::vector<std::vector<std::vector<int>>>{{{1, 2, 3, 0}}, {{0, 3}, {3, 2}, {2, 1}}}) {
    fs::remove(table);
    const Outcome outcome = call({"profile", write("ground.vtp", poly_lines(points, lines)), "-o", table});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    EXPECT_EQ(content_of(table), "x_m,y_m\n0,1\n2.5,1\n7.2,5\n11,5\n");
  }
  std::string content = content_of(quick);
  const std::string polygon = "polygon: [[0 m, 0 m], [11 m, 0 m], [11 m, 5 m], [7.2 m, 5 m], [2.5 m, 1 m], [0 m, 1 m]]";
  ASSERT_NE(content.find(polygon), std::string::npos);
  content.replace(content.find(polygon), polygon.size(), "surface: {file: ground.csv}");
  const Outcome check = call({"check", write("case.yaml", content)});
  EXPECT_EQ(check.exit_code, 0) << check.errors;
  EXPECT_NE(check.output.find("fine: 569 particles"), std::string::npos) << "as with the polygon: " << check.output;
}

TEST_F(SlopeSim, ProfileRefusesWhatIsNoGroundSurface) {
  const auto errors = [&](const std::string& content) {
    const Outcome outcome = call({"profile", write("ground.vtp", content), "-o", scratch_ / "ground.csv"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_FALSE(fs::exists(scratch_ / "ground.csv"));
    return outcome.errors;
  };
  const std::string file = (scratch_ / "ground.vtp").string();
  EXPECT_EQ(errors(poly_lines({"0 0 0", "1 0 0", "2 0 0", "3 0 0"}, {{0, 1}, {2, 3}})),
            file + ": holds more than one poly-line; keep the one of the ground surface\n");
  EXPECT_EQ(errors(poly_lines({"0 0 0"}, {})),
            file + ": holds no poly-line; write the ground surface as one line of points\n");
  EXPECT_EQ(errors(poly_lines({"0 0 0", "2 0 0", "1 1 0", "3 1 0"}, {{0, 1, 2, 3}})),
            file + ": the poly-line turns back at x = 1 m; a ground surface has no overhang\n");
  EXPECT_EQ(errors("x_m,y_m\n0,1\n"), file + ": is not a VTK PolyData file (.vtp)\n");
  EXPECT_EQ(errors(""), file + ": is not a VTK PolyData file (.vtp)\n");
  EXPECT_EQ(call({"profile", scratch_ / "none.vtp", "-o", scratch_ / "ground.csv"}).exit_code, 4);
}

// VTK takes a file by its word: points that are not there were read from beyond the array (a segmentation fault), and
// sizes that no ground surface has were asked for.
TEST_F(SlopeSim, ProfileRefusesDamagedFiles) {
  const std::vector<std::string> points{"0 0 0", "1 1 0", "2 2 0"};
  const auto told = [&](const std::string& content) {
    const Outcome outcome = call({"profile", write("ground.vtp", content), "-o", scratch_ / "ground.csv"});
    EXPECT_EQ(outcome.exit_code, 2) << outcome.errors;
    EXPECT_FALSE(fs::exists(scratch_ / "ground.csv"));
    const std::string file = (scratch_ / "ground.vtp").string() + ": ";
    return outcome.errors.starts_with(file) ? outcome.errors.substr(file.size()) : outcome.errors;
  };
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string content = poly_lines(points, {{0, 1, 2}});
    const std::size_t at = content.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return told(content.replace(at, from.size(), to));
  };
  EXPECT_EQ(told(poly_lines(points, {{0, 1, 7}})), "its line goes through point 7 of 3\n");
  EXPECT_EQ(told(poly_lines(points, {{0, 1, 1'000'000'000}})), "its line goes through point 1000000000 of 3\n");
  EXPECT_EQ(told(poly_lines(points, {{0, -5, 2}})), "its line goes through point -5 of 3\n");
  EXPECT_EQ(told(poly_lines({"0 0 0", "1 inf 0", "2 2 0"}, {{0, 1, 2}})), "its point 1 lies at x = 1 m, y = inf m\n");
  EXPECT_EQ(with("NumberOfPoints=\"3\"", "NumberOfPoints=\"1000000000000\""),
            "has NumberOfPoints=\"1000000000000\"; from 0 to 1000000 can be read\n");
  EXPECT_EQ(with("NumberOfLines=\"1\"", "NumberOfLines=\"-1\""),
            "has NumberOfLines=\"-1\"; from 0 to 1000000 can be read\n");
  for (const std::string components : {"1000000000", "-3"}) {
    EXPECT_EQ(with("NumberOfComponents=\"3\"", "NumberOfComponents=\"" + components + "\""),
              "has NumberOfComponents=\"" + components + "\"; from 0 to 9 can be read\n");
  }
  for (const std::string offset : {"30000000 ", "-3 "}) (void)with(">3 <", ">" + offset + "<");
}

TEST_F(SlopeSim, SchemaAndVersionArePrinted) {
  const Outcome schema = call({"schema"});
  EXPECT_EQ(schema.exit_code, 0);
  EXPECT_EQ(schema.output, couple::case_schema());
  const Outcome of_results = call({"schema", "--results"});
  EXPECT_EQ(of_results.exit_code, 0);
  EXPECT_EQ(of_results.output, couple::summary_schema());
  const Outcome version = call({"--version"});
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_TRUE(version.output.starts_with("slope-sim "));
}

TEST_F(SlopeSim, BrokenPhysicsEndsWithCode3AndKeepsWhatWasComputed) {
  const fs::path out = scratch_ / "run";
  const Outcome outcome = run_box(out, {"--set", "walls.base=free"});  // the box falls out of the grid
  EXPECT_EQ(outcome.exit_code, 3) << outcome.errors;
  EXPECT_NE(outcome.errors.find("slope-sim: at t = "), std::string::npos) << outcome.errors;
  EXPECT_NE(outcome.errors.find("outside of the grid"), std::string::npos) << outcome.errors;
  const couple::RunSummary summary = summary_of(out);
  EXPECT_EQ(summary.found.end_reason, couple::EndReason::error);
  EXPECT_NE(outcome.errors.find("slope-sim: " + summary.message + "\n"), std::string::npos);
  expect_whole_history(out, 3);
  const auto series = read_particle_series(out);
  ASSERT_GE(series.size(), 2u);
  EXPECT_EQ(series.back().label, "error");
  EXPECT_NEAR(series.back().time, summary.found.time, 1e-9);
  EXPECT_EQ(read_particles(series.back().file)->GetNumberOfPoints(), 32);
}

/// Waits, for a minute at most, until the history has that many rows.
bool has_rows(Program& program, const fs::path& history, long rows) {
  const auto limit = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (std::chrono::steady_clock::now() < limit && program.running()) {
    const std::string content = content_of(history);
    if (std::count(content.begin(), content.end(), '\n') > rows) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

class InterruptedRun : public SlopeSim, public testing::WithParamInterface<int> {};

TEST_P(InterruptedRun, EndsWithCode130AndLeavesReadableFiles) {
  const fs::path out = scratch_ / "run";
  Program program({"run", box, "-o", out.string(), "--set", "stop.time=1 h", "--set", "clock.adaptive=false", "--set",
                   "output.history_interval=0.01 s"},
                  scratch_);
  ASSERT_TRUE(has_rows(program, out / "history.csv", 3));
  EXPECT_EQ(summary_of(out).found.end_reason, couple::EndReason::running);
  program.signal(GetParam());
  const Outcome outcome = program.wait();
  EXPECT_EQ(outcome.exit_code, 130) << outcome.errors;
  expect_whole_history(out, 4);
  const auto series = read_particle_series(out);
  ASSERT_EQ(series.size(), 2u);
  EXPECT_EQ(series.back().label, "interrupted");
  EXPECT_EQ(read_particles(series.back().file)->GetNumberOfPoints(), 32);
  const couple::RunSummary summary = summary_of(out);
  EXPECT_EQ(summary.found.end_reason, couple::EndReason::interrupted);
  EXPECT_NEAR(summary.found.time, series.back().time, 1e-9);
}

/// Waits, for a minute at most, until the program has written a text to a file.
bool has_text(Program& program, const fs::path& file, const std::string& text) {
  const auto limit = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (std::chrono::steady_clock::now() < limit && program.running()) {
    if (content_of(file).find(text) != std::string::npos) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

TEST_P(InterruptedRun, EndsInItsInitialStateToo) {
  const fs::path out = scratch_ / "run";
  Program program(
      {"run", box, "-o", out.string(), "--set", "domain.cell_size=0.02 m", "--set", "initial.stress=self_weight"},
      scratch_);
  ASSERT_TRUE(has_text(program, scratch_ / "errors", "initial state: elastic stress"));
  program.signal(GetParam());
  const Outcome outcome = program.wait();
  EXPECT_EQ(outcome.exit_code, 130) << outcome.errors;
  EXPECT_NE(outcome.errors.find("interrupted before the start"), std::string::npos) << outcome.errors;
  const auto series = read_particle_series(out);
  ASSERT_EQ(series.size(), 1u);
  EXPECT_EQ(series.back().label, "interrupted");
  EXPECT_EQ(summary_of(out).found.end_reason, couple::EndReason::interrupted);
}

INSTANTIATE_TEST_SUITE_P(By, InterruptedRun, testing::Values(SIGINT, SIGTERM),
                         [](const auto& instance) { return instance.param == SIGINT ? "SIGINT" : "SIGTERM"; });

}  // namespace
}  // namespace slope::tools::test
