// `slope-sim run`: what it leaves in its folder, and what it says.

#include <gtest/gtest.h>

#include "particle_file.hpp"
#include "slope/couple/read_case.hpp"
#include "slope_sim_test.hpp"

namespace slope::tools::test {
namespace {

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

}  // namespace
}  // namespace slope::tools::test
