// `slope-sim new`, and what slope-sim says of itself: `schema` and `--version`.

#include <gtest/gtest.h>

#include "slope/couple/read_case.hpp"
#include "slope/couple/results.hpp"
#include "slope_sim_test.hpp"

namespace slope::tools::test {
namespace {

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

}  // namespace
}  // namespace slope::tools::test
