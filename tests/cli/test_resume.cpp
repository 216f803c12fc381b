// Runs that are stopped, killed and gone on with.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <random>
#include <sstream>
#include <thread>

#include "slope_sim_test.hpp"

namespace slope::tools::test {
namespace {

class Resume : public SlopeSim {
 protected:
  /// A run of a second or two with histories and snapshots, checkpoints as often as may be.
  [[nodiscard]] std::vector<std::string> run(const std::string& folder, std::vector<std::string> more = {}) const {
    std::vector<std::string> words{"run",     box,
                                   "-o",      (scratch_ / folder).string(),
                                   "--set",   "stop.time=4 s",
                                   "--set",   "clock.adaptive=false",
                                   "--set",   "output.snapshot_interval=0.5 s",
                                   "--set",   "initial.stress=self_weight",
                                   "--quiet", "--checkpoint-interval",
                                   "0"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  /// A file without what depends on the clock on the wall.
  static std::string product(const fs::path& file) {
    if (file.filename() != "summary.json") return content_of(file);
    std::istringstream stream(content_of(file));
    std::string kept;
    for (std::string line; std::getline(stream, line);) {
      if (line.find("\"wall_time_s\"") == std::string::npos && line.find("\"threads\"") == std::string::npos)
        kept += line;
    }
    return kept;
  }
  /// Both folders have the same files with the same content, save log and checkpoint.
  void expect_same(const std::string& one, const std::string& other) const {
    std::vector<std::string> names, others;
    for (const auto& entry : fs::directory_iterator(scratch_ / one)) names.push_back(entry.path().filename().string());
    for (const auto& entry : fs::directory_iterator(scratch_ / other))
      others.push_back(entry.path().filename().string());
    std::ranges::sort(names);
    std::ranges::sort(others);
    ASSERT_EQ(names, others);
    for (const std::string& name : names) {
      if (name == "log.txt" || name == "checkpoint.bin") continue;
      EXPECT_EQ(product(scratch_ / one / name), product(scratch_ / other / name)) << name;
    }
  }
};

TEST_F(Resume, ARunThatIsKilledAgainAndAgainEndsAsIfItWereNot) {
  const char* asked = std::getenv("SLOPE_KILLS");
  const int kills = asked != nullptr ? std::stoi(asked) : 20;
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_EQ(call(run("whole")).exit_code, 0);
  const double duration = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  std::mt19937 random(20261126);
  std::uniform_real_distribution<double> moment(0.0, 0.6 * duration);
  int killed = 0, ended = 0;
  while (killed < kills) {
    Program program(run("killed", {"--resume", "--threads", killed % 2 == 0 ? "1" : "2"}), scratch_);
    std::this_thread::sleep_for(std::chrono::duration<double>(moment(random)));
    if (program.running()) {
      program.signal(SIGKILL);
      program.wait();
      ++killed;
      continue;
    }
    ASSERT_EQ(program.wait().exit_code, 0) << content_of(scratch_ / "errors");
    expect_same("whole", "killed");
    fs::remove_all(scratch_ / "killed");
    ++ended;
  }
  const Outcome last = call(run("killed", {"--resume"}));
  ASSERT_EQ(last.exit_code, 0) << last.errors;
  expect_same("whole", "killed");
  RecordProperty("ends_between_kills", ended);
}

TEST_F(Resume, ARunThatWasStoppedBeforeItsStartBeginsAnew) {
  Program program(run("early", {"--set", "domain.cell_size=0.1 m"}), scratch_);
  const fs::path checkpoint = scratch_ / "early" / "checkpoint.bin";
  const auto limit = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (!fs::exists(checkpoint) && std::chrono::steady_clock::now() < limit) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  program.signal(SIGKILL);
  program.wait();
  ASSERT_TRUE(fs::exists(checkpoint));
  ASSERT_FALSE(fs::exists(scratch_ / "early" / "history.csv"));
  Program again({"resume", (scratch_ / "early").string(), "--quiet"}, scratch_);
  EXPECT_TRUE(has_rows(again, scratch_ / "early" / "history.csv", 3)) << content_of(scratch_ / "errors");
}

TEST_F(Resume, AnInterruptedRunGoesOnWithAnotherNumberOfThreads) {
  ASSERT_EQ(call(run("whole")).exit_code, 0);
  Program program(run("stopped"), scratch_);
  ASSERT_TRUE(has_rows(program, scratch_ / "stopped" / "history.csv", 20));
  program.signal(SIGTERM);
  ASSERT_EQ(program.wait().exit_code, 130);
  const Outcome outcome = call({"resume", (scratch_ / "stopped").string(), "--threads", "2", "--quiet"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  expect_same("whole", "stopped");
  EXPECT_EQ(call({"resume", (scratch_ / "stopped").string()}).errors,
            (scratch_ / "stopped").string() + ": the run has come to its end already\n");
}

TEST_F(Resume, ACheckpointIsWrittenOnRequest) {
  std::vector<std::string> words = run("asked");
  words.back() = "1e6";
  Program program(words, scratch_);
  ASSERT_TRUE(has_rows(program, scratch_ / "asked" / "history.csv", 10));
  program.signal(SIGUSR1);
  ASSERT_EQ(program.wait().exit_code, 0);
  EXPECT_NE(content_of(scratch_ / "asked" / "log.txt").find("checkpoint on request"), std::string::npos);
}

TEST_F(Resume, ASecondRunIsKeptOut) {
  Program program(run("taken", {"--set", "stop.time=1 h"}), scratch_);
  ASSERT_TRUE(has_rows(program, scratch_ / "taken" / "history.csv", 3));
  for (const auto& words : {run("taken", {"--overwrite"}), {"resume", (scratch_ / "taken").string()}}) {
    fs::create_directory(scratch_ / "second");
    const Outcome second = slope_sim(words, scratch_ / "second");
    EXPECT_EQ(second.exit_code, 4);
    EXPECT_NE(second.errors.find(": another slope-sim is at work in it"), std::string::npos) << second.errors;
    fs::remove_all(scratch_ / "second");
  }
  EXPECT_TRUE(program.running());
}

TEST_F(Resume, WhatDoesNotFitIsRefused) {
  ASSERT_EQ(call(run("run", {"--set", "stop.time=0.2 s"})).exit_code, 0);
  const std::string folder = (scratch_ / "run").string();
  const Outcome other = call(run("run", {"--set", "stop.time=0.3 s", "--resume"}));
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_NE(other.errors.find("is not the case of the checkpoint: line "), std::string::npos) << other.errors;
  EXPECT_EQ(call({"resume", (scratch_ / "none").string()}).exit_code, 4);
  fs::resize_file(scratch_ / "run" / "checkpoint.bin", 1000);
  const Outcome cut = call({"resume", folder});
  EXPECT_EQ(cut.exit_code, 4);
  EXPECT_NE(cut.errors.find("checkpoint.bin: is cut off: it ends after 1000 of "), std::string::npos) << cut.errors;
}

/// A blow that the first step, at the soil's own stable length, would turn its surface inside out with.
std::vector<std::string> blow(const std::string& folder, const std::string& end) {
  return {"run",    box,
          "-o",     folder,
          "--set",  "stop.time=" + end,
          "--set",  "soils.clay.youngs_modulus=100 kPa",
          "--set",  "numerics.courant_number=0.9",
          "--set",  "coupling.skeleton=rigid",
          "--set",  "clock.adaptive=false",
          "--set",  "loads=[{name: blow, at: ground_surface, traction: [0 kPa, -200 kPa]}]",
          "--quiet"};
}

TEST_F(Resume, AStepThatBrokeIsTriedAgainWithAShorterOne) {
  const Outcome outcome = call(blow((scratch_ / "blow").string(), "0.05 s"));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_NE(content_of(scratch_ / "blow" / "summary.json").find("\"steps\": 2"), std::string::npos) << "for one";
}

TEST_F(Resume, ARunThatGivesUpLeavesItsLastGoodState) {
  const std::string folder = (scratch_ / "blow").string();
  const Outcome outcome = call(blow(folder, "0.2 s"));
  ASSERT_EQ(outcome.exit_code, 3) << outcome.errors;
  EXPECT_NE(outcome.errors.find("; shorter steps broke too"), std::string::npos) << outcome.errors;
  EXPECT_EQ(content_of(scratch_ / "blow" / "history.csv").find("nan"), std::string::npos);
  const std::string last = content_of(scratch_ / "blow" / "particles_0001.vtp");
  ASSERT_NE(last, "");
  const Outcome again = call({"resume", folder, "--quiet"});
  EXPECT_EQ(again.exit_code, 3);
  EXPECT_EQ(again.errors, outcome.errors);
  EXPECT_EQ(content_of(scratch_ / "blow" / "particles_0001.vtp"), last);
}

}  // namespace
}  // namespace slope::tools::test
