#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <memory>
#include <stdexcept>
#include <thread>

#include "particle_file.hpp"
#include "program.hpp"
#include "scratch_folder.hpp"
#include "shell_cases.hpp"
#include "slope/couple/results.hpp"

namespace slope::tools::test {
namespace {

namespace fs = std::filesystem;

const std::string box = std::string(SLOPE_CLI_TESTS) + "/box.yaml";

// What may be wrong around the program: its streams, its output folder, the disk, signals.
class Surroundings : public testing::Test {
 protected:
  [[nodiscard]] Outcome shell(const std::string& command) const {
    return Program({"-c", "sim='" SLOPE_SIM "'; box='" + box + "'; cd '" + path().string() + "'; " + command}, path(),
                   "/bin/bash")
        .wait();
  }
  [[nodiscard]] const fs::path& path() const { return scratch_.path(); }
  [[nodiscard]] static couple::EndReason end_reason_of(const fs::path& run) {
    return couple::read_summary(run / "summary.json").found.end_reason;
  }
  /// A run that goes on for an hour, and has begun its history.
  [[nodiscard]] std::unique_ptr<Program> long_run() const {
    auto program = std::make_unique<Program>(
        std::vector<std::string>{"run", box, "-o", (path() / "run").string(), "--quiet", "--set", "stop.time=1 h",
                                 "--set", "clock.adaptive=false", "--set", "output.history_interval=0.01 s", "--set",
                                 "output.snapshot_interval=1 s"},
        path());
    const auto limit = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    while (content_of(path() / "run" / "history.csv").size() < 1000 && program->running()) {
      if (std::chrono::steady_clock::now() > limit) throw std::runtime_error("the run does not begin");
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return program;
  }
  [[nodiscard]] std::vector<std::string> left_over(const fs::path& folder) const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) {
      const std::string name = entry.path().filename().string();
      if (name.ends_with(".tmp") || name.ends_with(".part")) names.push_back(name);
    }
    return names;
  }

 private:
  ScratchFolder scratch_;
};

TEST_F(Surroundings, ClosedStreamsPutNothingIntoTheFiles) {
  const Outcome outcome = shell("\"$sim\" run \"$box\" -o run <&- >&- 2>&-");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(end_reason_of(path() / "run"), couple::EndReason::time);
  for (const auto& entry : fs::directory_iterator(path() / "run")) {
    if (entry.path().filename() == "log.txt") continue;  // it has a line of the progress at each snapshot
    EXPECT_EQ(content_of(entry.path()).find(" of 0.2 s"), std::string::npos) << entry.path();
  }
}

TEST_F(Surroundings, AFullOutputIsToldWithCode4) {
  for (const std::string command : {"schema", "check \"$box\"", "run \"$box\" -o run", "new case.yaml"}) {
    const Outcome outcome = shell("\"$sim\" " + command + " >/dev/full");
    EXPECT_EQ(outcome.exit_code, 4) << command;
    EXPECT_NE(outcome.errors.find("the standard output cannot be written: No space left on device"), std::string::npos)
        << command << ": " << outcome.errors;
  }
  EXPECT_EQ(end_reason_of(path() / "run"), couple::EndReason::time) << "the run itself is whole";
}

TEST_F(Surroundings, ErrorsThatNobodyTakesEndNothing) {
  EXPECT_EQ(shell("\"$sim\" run \"$box\" -o run 2>/dev/full").exit_code, 0);
  EXPECT_EQ(shell("\"$sim\" check none.yaml 2>/dev/full").exit_code, 4);
}

TEST_F(Surroundings, AReaderThatGoesAwayEndsNoRun) {
  const Outcome outcome = shell("\"$sim\" run \"$box\" -o run 2>&1 | true; exit ${PIPESTATUS[0]}");
  EXPECT_EQ(outcome.exit_code, 4) << "the report was lost";
  EXPECT_EQ(end_reason_of(path() / "run"), couple::EndReason::time);
}

TEST_F(Surroundings, FilesOfTheUserInTheOutputFolderAreKept) {
  const Outcome outcome = shell(
      "mkdir own; cp \"$box\" own/case.yaml; echo mine >own/log.txt; "
      "\"$sim\" run own/case.yaml -o own");
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_NE(outcome.errors.find("own: holds something else than a run of slope-sim"), std::string::npos);
  EXPECT_EQ(content_of(path() / "own" / "log.txt"), "mine\n");
  EXPECT_EQ(content_of(path() / "own" / "case.yaml"), content_of(box));
}

TEST_F(Surroundings, TheFolderOfARunThatWasKilledAtOnceIsUsedAgain) {
  EXPECT_EQ(shell("mkdir run; touch run/log.txt; \"$sim\" run \"$box\" -o run --overwrite").exit_code, 0);
}

TEST_F(Surroundings, AReferenceWithTheNameOfOurOwnFilesGoesAlong) {
  const Outcome outcome = shell(
      "mkdir refs; printf 'z_m,suction_head_m_t0.1\\n0,0\\n1,0.8\\n' >refs/history.csv; cp \"$box\" case.yaml; "
      "echo 'figures: {profile_times: [0.1 s], profile_reference: refs/history.csv}' >>case.yaml; "
      "\"$sim\" run case.yaml -o run");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ(content_of(path() / "run" / "reference_history.csv"), content_of(path() / "refs" / "history.csv"));
  EXPECT_TRUE(content_of(path() / "run" / "history.csv").starts_with("time [s],"));
  EXPECT_EQ(shell("\"$sim\" check run/case.yaml").exit_code, 0);
}

TEST_F(Surroundings, AReferenceInThePlaceOfOurOwnFilesIsRefused) {
  const Outcome outcome = shell(
      "\"$sim\" run \"$box\" -o run --quiet; printf 'z_m,suction_head_m_t0.1\\n0,0\\n1,0.8\\n' >run/history.csv; "
      "echo 'figures: {profile_times: [0.1 s], profile_reference: history.csv}' >>run/case.yaml; "
      "\"$sim\" run run/case.yaml -o run");
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_NE(outcome.errors.find("would be replaced by the run's own"), std::string::npos) << outcome.errors;
  EXPECT_TRUE(content_of(path() / "run" / "history.csv").starts_with("z_m,"));
}

TEST_F(Surroundings, AFullDiskIsToldWithItsReasonAndWhatIsThereCanBeRead) {
  const Outcome outcome = shell(
      "ulimit -f 40; exec \"$sim\" run \"$box\" -o run --quiet --set 'stop.time=10 min' --set clock.adaptive=false "
      "--set 'output.history_interval=0.01 s' --set 'output.snapshot_interval=0.1 s'");
  EXPECT_EQ(outcome.exit_code, 4) << outcome.errors;
  EXPECT_NE(outcome.errors.find("cannot be written: File too large"), std::string::npos) << outcome.errors;
  EXPECT_EQ(left_over(path() / "run"), std::vector<std::string>{});
  const couple::RunSummary summary = couple::read_summary(path() / "run" / "summary.json");
  EXPECT_EQ(summary.found.end_reason, couple::EndReason::error);
  EXPECT_NE(summary.message.find("File too large"), std::string::npos);
  for (const Snapshot& snapshot : read_particle_series(path() / "run")) {
    EXPECT_EQ(read_particles(snapshot.file)->GetNumberOfPoints(), 32) << snapshot.file;
  }
}

TEST_F(Surroundings, AFolderThatIsDeletedInMidRunIsToldWithItsReason) {
  const auto program = long_run();
  fs::rename(path() / "run", path() / "gone");
  const Outcome outcome = program->wait();
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_NE(outcome.errors.find("cannot be written: No such file or directory"), std::string::npos) << outcome.errors;
}

TEST_F(Surroundings, AFileWhereTheFolderShouldBeIsToldWithItsReason) {
  const Outcome outcome = shell("\"$sim\" run \"$box\" -o /dev/full");
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_NE(outcome.errors.find("/dev/full: cannot be used as output folder: "), std::string::npos) << outcome.errors;
}

TEST_F(Surroundings, AHangUpStopsTheRunAsAnInterruptionDoes) {
  const auto program = long_run();
  program->signal(SIGHUP);
  program->signal(SIGHUP);
  EXPECT_EQ(program->wait().exit_code, 130);
  EXPECT_EQ(end_reason_of(path() / "run"), couple::EndReason::interrupted);
  EXPECT_EQ(read_particle_series(path() / "run").back().label, "interrupted");
}

TEST_F(Surroundings, AHangUpThatIsIgnoredStaysSo) {
  const Outcome outcome = shell("trap '' HUP; \"$sim\" run \"$box\" -o run --quiet & kill -HUP $!; wait $!");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(end_reason_of(path() / "run"), couple::EndReason::time);
}

TEST_F(Surroundings, ASecondInterruptionEndsTheProgramAtOnce) {
  const auto program = long_run();
  program->signal(SIGSTOP);  // so that both are there when it goes on
  program->signal(SIGINT);
  program->signal(SIGTERM);
  program->signal(SIGCONT);
  EXPECT_EQ(program->wait().exit_code, -1);
  EXPECT_EQ(end_reason_of(path() / "run"), couple::EndReason::running);
  EXPECT_TRUE(content_of(path() / "run" / "history.csv").ends_with('\n'));
  for (const Snapshot& snapshot : read_particle_series(path() / "run")) {
    EXPECT_EQ(read_particles(snapshot.file)->GetNumberOfPoints(), 32) << snapshot.file;
  }
}

class OddInput : public testing::TestWithParam<ShellCase> {};

TEST_P(OddInput, GetsAClearMessageInBoundedTimeAndMemory) {
  const ShellCase& odd = GetParam();
  const ScratchFolder scratch;
  fs::create_directory(scratch.path() / "odd");
  fs::copy_file(SLOPE_CASES "/quick.yaml", scratch.path() / "odd" / "case.yaml");
  do_in(scratch.path() / "odd", odd.command,
        "many() { awk -v n=\"$1\" -v t=\"$2\" 'BEGIN { for (i = 0; i < n; ++i) printf \"%s\", t }'; }\n"
        "replace() { printf '%s\\n' \"$2\" >part; sed -i -e \"/$1/{r part\" -e 'd}' case.yaml; }\n"
        "geometry() { replace '^    polygon:' \"    $1\"; }\n"
        "boundary() { replace '^  - {name: rain' \"  - $1\"; }\n"
        "output() { replace '^  history_interval' \"  $1\"; }\n");
  const auto start = std::chrono::steady_clock::now();
  const Outcome outcome = slope_sim({"check", (scratch.path() / "odd" / "case.yaml").string()}, scratch.path());
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
  EXPECT_EQ(outcome.exit_code, std::stoi(odd.expected.at(0))) << outcome.errors.substr(0, 2000);
  const std::string said = outcome.output + outcome.errors;
  EXPECT_NE(said.find(odd.expected.at(1)), std::string::npos) << said.substr(0, 2000);
  EXPECT_LT(said.size(), 40000u) << "nobody reads that";
}

INSTANTIATE_TEST_SUITE_P(With, OddInput, testing::ValuesIn(shell_cases(SLOPE_CLI_TESTS "/odd_inputs.txt", 2)),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace slope::tools::test
