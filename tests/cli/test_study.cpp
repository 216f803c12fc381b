// slope-sim study: its runs, its files, and what happens to it when it is killed.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>
#include <thread>

#include "program.hpp"
#include "scratch_folder.hpp"

namespace slope::tools::test {
namespace {

namespace fs = std::filesystem;

class StudyCommand : public testing::Test {
 protected:
  StudyCommand() {
    for (const char* name : {"block.yaml", "study.yaml"}) {
      fs::copy(fs::path(SLOPE_CLI_TESTS) / name, scratch_.path() / name);
    }
  }

  [[nodiscard]] fs::path path(const std::string& name) const { return scratch_.path() / name; }
  [[nodiscard]] std::vector<std::string> words(const std::string& folder, const std::vector<std::string>& more) const {
    std::vector<std::string> all{"study", path("study.yaml").string(), "-o", path(folder).string()};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  [[nodiscard]] Outcome study(const std::string& folder, const std::vector<std::string>& more = {}) const {
    return slope_sim(words(folder, more), scratch_.path());
  }
  void change(const std::string& file, const std::string& text, const std::string& replacement) const {
    std::string content = content_of(path(file));
    const std::size_t at = content.find(text);
    ASSERT_NE(at, std::string::npos) << text;
    std::ofstream(path(file)) << content.replace(at, text.size(), replacement);
  }
  void expect_same(const std::string& one, const std::string& other) const {
    for (const char* name : {"study.csv", "study.json"}) {
      ASSERT_TRUE(fs::exists(path(one) / name));
      EXPECT_EQ(content_of(path(one) / name), content_of(path(other) / name)) << name;
    }
  }

  const ScratchFolder scratch_;
};

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST_F(StudyCommand, FillsItsFolderAndTellsTheResult) {
  const Outcome outcome = study("study");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_TRUE(outcome.output.starts_with("Blocks of clay\n  runs             20 of the design monte_carlo, seed 3\n"))
      << outcome.output;
  const std::vector<std::string> rows = lines_of(content_of(path("study") / "study.csv"));
  ASSERT_EQ(rows.size(), 21u);
  EXPECT_EQ(rows[0], "sample,strength [kPa],grains [kg/m3],factor [-],verdict,failure,state,seed,folder");
  int failed = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    EXPECT_TRUE(rows[i].ends_with("finished,3,runs/00" + std::string(i < 10 ? "0" : "") + std::to_string(i)))
        << rows[i];
    failed += rows[i].find(",yes,") != std::string::npos ? 1 : 0;
  }
  EXPECT_GT(failed, 0);
  EXPECT_NE(outcome.output.find("factor < 1.3: " + std::to_string(failed) + " of 20 runs"), std::string::npos)
      << outcome.output;
  for (const char* name : {"study.yaml", "case.yaml", "study.json", "runs/0020/summary.json"}) {
    EXPECT_TRUE(fs::exists(path("study") / name)) << name;
  }
  EXPECT_FALSE(fs::exists(path("study") / "jobs.txt"));
}

TEST_F(StudyCommand, GivesTheSameOnAnyNumberOfJobs) {
  ASSERT_EQ(study("one", {"--quiet"}).exit_code, 0);
  const Outcome outcome = study("two", {"--jobs", "2", "--quiet"});
  ASSERT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.output + outcome.errors, "");
  expect_same("one", "two");
}

// Killed again and again, the engine and its runs are left to themselves; none of them is lost or done twice.
TEST_F(StudyCommand, KilledAndInterruptedAgainAndAgainEndsAsIfItWereNot) {
  change("block.yaml", "tolerance: 0.05", "tolerance: 0.002");
  ASSERT_EQ(study("whole", {"--quiet"}).exit_code, 0);
  int killed = 0;
  Outcome outcome;
  for (int k = 0; k < 40 && outcome.exit_code != 0; ++k) {
    Program program(words("pieces", {"--quiet", "--jobs", "2"}), scratch_.path());
    std::this_thread::sleep_for(std::chrono::milliseconds(250 + 100 * k));
    if (program.running()) {
      program.signal(k % 2 == 0 ? SIGKILL : SIGINT);
      ++killed;
    }
    outcome = program.wait();
    ASSERT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 130 || outcome.exit_code == -1)
        << outcome.exit_code << outcome.errors;
  }
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_GT(killed, 1);
  expect_same("whole", "pieces");
}

TEST_F(StudyCommand, ARunThatIsInterruptedGoesOnFromItsCheckpoint) {
  change("block.yaml", "stop: {time: 0.1 s}", "stop: {time: 20 s}\nclock: {adaptive: false}");
  change("study.yaml", "factor: {key: factor_of_safety.factor}", "moved: {key: largest_displacement_m}");
  change("study.yaml", "failure: factor < 1.3", "failure: verdict");
  change("study.yaml", "samples: 20, batch: 10", "samples: 2");
  ASSERT_EQ(study("whole", {"--quiet"}).exit_code, 0);
  Program program(words("study", {"--quiet"}), scratch_.path());
  const auto has_begun = [&] { return fs::exists(path("study") / "runs/0001/particles_0000.vtp"); };
  while (program.running() && !has_begun()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  program.signal(SIGINT);
  EXPECT_EQ(program.wait().exit_code, 130);
  ASSERT_EQ(study("study", {"--quiet"}).exit_code, 0);
  EXPECT_NE(content_of(path("study") / "runs/0001/log.txt").find("resumed at "), std::string::npos);
  expect_same("whole", "study");
}

TEST_F(StudyCommand, TakesUpARunThatWasLostAndLeavesTheOthersAlone) {
  ASSERT_EQ(study("study", {"--quiet"}).exit_code, 0);
  const std::string before = content_of(path("study") / "study.csv");
  const auto written = fs::last_write_time(path("study") / "runs/0003/summary.json");
  fs::remove(path("study") / "runs/0007/summary.json");
  std::ofstream(path("study") / "runs/0008/summary.json") << "{\"program\": \"slope-sim\", \"ver";
  fs::remove(path("study") / "study.csv");
  ASSERT_EQ(study("study", {"--quiet"}).exit_code, 0);
  EXPECT_EQ(content_of(path("study") / "study.csv"), before);
  EXPECT_EQ(fs::last_write_time(path("study") / "runs/0003/summary.json"), written);
}

TEST_F(StudyCommand, ARunThatFailsIsNamedAndKeepsNoOtherFromBeingRun) {
  ASSERT_EQ(study("whole", {"--quiet"}).exit_code, 0);
  ASSERT_EQ(study("study", {"--list"}).exit_code, 0);
  fs::create_directory(path("study") / "runs");
  std::ofstream(path("study") / "runs/0002") << "in the way";
  const Outcome outcome = study("study", {"--quiet"});
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_NE(outcome.errors.find("these runs did not come to their end: runs/0002; the same command goes on"),
            std::string::npos)
      << outcome.errors;
  EXPECT_TRUE(fs::exists(path("study") / "runs/0010/summary.json"));
  EXPECT_FALSE(fs::exists(path("study") / "study.csv"));
  fs::remove(path("study") / "runs/0002");
  ASSERT_EQ(study("study", {"--quiet"}).exit_code, 0);
  expect_same("whole", "study");
}

TEST_F(StudyCommand, ListsTheRunsOfABatchForWhoeverRunsThem) {
  ASSERT_EQ(study("study", {"--quiet"}).exit_code, 0);
  for (const char* from : {"runs/0001", "runs/0011"}) {  // of either batch
    const Outcome listed = study("list", {"--list"});
    ASSERT_EQ(listed.exit_code, 0) << listed.errors;
    const std::vector<std::string> commands = lines_of(listed.output);
    ASSERT_EQ(commands.size(), 10u) << listed.output;
    EXPECT_NE(commands[0].find(from), std::string::npos) << commands[0];
    for (const std::string& command : commands) ASSERT_EQ(std::system(command.c_str()), 0) << command;
  }
  const Outcome rest = study("list", {"--list"});
  EXPECT_EQ(rest.exit_code, 0);
  EXPECT_EQ(rest.output, "");
  ASSERT_EQ(study("list", {"--quiet"}).exit_code, 0);
  expect_same("study", "list");
}

TEST_F(StudyCommand, StopsWhenTheIntervalIsNarrowEnough) {
  change("study.yaml", "samples: 20, batch: 10", "samples: 1000, batch: 5, interval_width: 0.55");
  ASSERT_EQ(study("study", {"--quiet"}).exit_code, 0);
  const std::size_t rows = lines_of(content_of(path("study") / "study.csv")).size() - 1;
  EXPECT_EQ(rows % 5, 0u);
  EXPECT_GT(rows, 5u);
  EXPECT_LT(rows, 20u);
}

TEST_F(StudyCommand, GoesOnWithMoreSamplesOfMonteCarlo) {
  ASSERT_EQ(study("whole", {"--quiet"}).exit_code, 0);
  change("study.yaml", "samples: 20", "samples: 7");
  ASSERT_EQ(study("more", {"--quiet"}).exit_code, 0);
  EXPECT_EQ(lines_of(content_of(path("more") / "study.csv")).size(), 8u);
  const auto written = fs::last_write_time(path("more") / "runs/0003/summary.json");
  change("study.yaml", "samples: 7", "samples: 20");
  ASSERT_EQ(study("more", {"--quiet"}).exit_code, 0);
  expect_same("whole", "more");
  EXPECT_EQ(fs::last_write_time(path("more") / "runs/0003/summary.json"), written);
}

TEST_F(StudyCommand, RefusesAFolderOfAnotherStudyOrOfSomethingElse) {
  ASSERT_EQ(study("study", {"--list"}).exit_code, 0);
  change("study.yaml", "seed: 3", "seed: 4");
  Outcome outcome = study("study");
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_NE(outcome.errors.find("study.yaml: the study has changed since"), std::string::npos) << outcome.errors;
  change("study.yaml", "seed: 4", "seed: 3");
  change("block.yaml", "youngs_modulus: 10 MPa", "youngs_modulus: 11 MPa");
  outcome = study("study");
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_NE(outcome.errors.find("case.yaml: the case has changed since"), std::string::npos) << outcome.errors;
  fs::create_directory(path("mine"));
  std::ofstream(path("mine") / "case.yaml") << "mine";
  outcome = study("mine");
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_EQ(content_of(path("mine") / "case.yaml"), "mine");
}

TEST_F(StudyCommand, TellsOfWrongStudiesAndRunsNothing) {
  change("study.yaml", "undrained_strength", "undrained_strenth");
  Outcome outcome = study("study");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.errors.find("study.yaml:6: parameters.strength.key: the case has no number"), std::string::npos)
      << outcome.errors;
  EXPECT_FALSE(fs::exists(path("study")));
  EXPECT_EQ(slope_sim({"study", path("none.yaml").string(), "-o", path("study").string()}, scratch_.path()).exit_code,
            4);
}

TEST_F(StudyCommand, CheckSaysWhatAStudyHolds) {
  const std::string file = path("study.yaml").string();
  const Outcome fine = slope_sim({"check", file}, scratch_.path());
  EXPECT_EQ(fine.exit_code, 0) << fine.errors;
  EXPECT_EQ(fine.output, file + ": fine: 2 parameters, 20 runs at most of the design monte_carlo\n");
  change("study.yaml", "samples: 20", "samples: 0");
  const Outcome wrong = slope_sim({"check", file}, scratch_.path());
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_NE(wrong.errors.find("study.yaml:15: design.samples: must be at least 2"), std::string::npos) << wrong.errors;
}

// What the values of one sample do not go together with is told with the sample, before anything is run.
TEST_F(StudyCommand, TellsWhichSamplesTheCaseDoesNotTake) {
  change("block.yaml", "{model: von_mises, undrained_strength: 10 kPa}",
         "{model: mohr_coulomb, cohesion: 1 kPa, friction_angle: 30 deg, dilatancy_angle: 20 deg, "
         "maximum_cohesion_increase: 0 kPa, cohesion_suction_rate: 0, friction_angle_suction_rate: 0 deg}");
  change("study.yaml", "undrained_strength", "friction_angle");
  change("study.yaml", "mean: 10 kPa", "mean: 21 deg");
  const Outcome outcome = study("study");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.errors.find("parameters: sample "), std::string::npos) << outcome.errors;
  EXPECT_NE(outcome.errors.find("dilatancy_angle: must not exceed the friction angle"), std::string::npos)
      << outcome.errors;
  EXPECT_FALSE(fs::exists(path("study") / "runs"));
}

// Whole runs, with verdicts: of weak blocks that fall and of strong ones that stand.
TEST_F(StudyCommand, AsksForVerdictsToo) {
  change("study.yaml", "failure: factor < 1.3", "failure: verdict");
  change("study.yaml", "factor: {key: factor_of_safety.factor}", "moved: {key: largest_displacement_m}");
  change("study.yaml", "coefficient_of_variation: 10 %", "coefficient_of_variation: 40 %");
  change("study.yaml", "samples: 20, batch: 10", "samples: 6");
  const Outcome outcome = study("study");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  const std::string table = content_of(path("study") / "study.csv");
  EXPECT_NE(table.find(",does not stand before the start,yes,"), std::string::npos) << table;
  EXPECT_NE(table.find(",stands,no,"), std::string::npos) << table;
}

}  // namespace
}  // namespace slope::tools::test
