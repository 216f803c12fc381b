// Runs of slope-sim that a signal interrupts.

#include <gtest/gtest.h>

#include <csignal>

#include "particle_file.hpp"
#include "slope_sim_test.hpp"

namespace slope::tools::test {
namespace {

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
