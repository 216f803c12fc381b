// slope-sim safety, and runs that ask for the factor of safety.

#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <stdexcept>
#include <thread>

#include "program.hpp"

namespace slope::tools::test {
namespace {

namespace fs = std::filesystem;

class SafetyCommand : public testing::Test {
 protected:
  SafetyCommand() {
    std::string name = (fs::temp_directory_path() / "slope-safety-test-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no folder can be made at " + name);
    scratch_ = name;
  }
  ~SafetyCommand() override {
    std::error_code ignored;
    fs::remove_all(scratch_, ignored);
  }

  /// A box of weak clay with a face that is free to fall.
  [[nodiscard]] std::vector<std::string> words(const std::string& command, std::vector<std::string> more = {}) const {
    std::vector<std::string> result{command, std::string(SLOPE_CLI_TESTS) + "/box.yaml"};
    for (const char* setting :
         {"soils.clay.strength={model: von_mises, undrained_strength: 20 kPa}", "initial.stress=self_weight",
          "geometry=[{soil: clay, polygon: [[0 m, 0 m], [1 m, 0 m], [1 m, 1 m], [0 m, 1 m]]}]", "points={}",
          "water_boundaries=[]", "safety.tolerance=0.05"}) {
      result.insert(result.end(), {"--set", setting});
    }
    result.insert(result.end(), more.begin(), more.end());
    return result;
  }
  [[nodiscard]] Outcome call(const std::vector<std::string>& all) const { return slope_sim(all, scratch_); }

  fs::path scratch_;
};

TEST_F(SafetyCommand, TellsTheFactorAtTheStartAndKeepsNothing) {
  const Outcome outcome = call(words("safety"));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_TRUE(outcome.output.starts_with("A box of wet soil\n  factor of safety ")) << outcome.output;
  EXPECT_NE(outcome.output.find(" at 0 s ("), std::string::npos) << outcome.output;
  EXPECT_EQ(outcome.output.find("written to"), std::string::npos) << outcome.output;
  EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 2);
}

TEST_F(SafetyCommand, TellsItAtTheTimesAskedForAndTheLeast) {
  const std::string folder = (scratch_ / "results").string();
  const Outcome outcome = call(words("safety", {"--at", "0 s, 0.1 s", "--tolerance", "0.1", "-o", folder}));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_NE(outcome.output.find(" at 0.1 s ("), std::string::npos) << outcome.output;
  EXPECT_NE(outcome.output.find("\n  least "), std::string::npos) << outcome.output;
  const std::string table = content_of(fs::path(folder) / "safety.csv");
  EXPECT_TRUE(table.starts_with("time [s],factor of safety [-],lower [-],upper [-],trials [-],area [m2],depth [m]\n0,"))
      << table;
  EXPECT_NE(table.find("\n0.1,"), std::string::npos) << table;
  EXPECT_NE(content_of(fs::path(folder) / "summary.json").find("\"factor_of_safety\""), std::string::npos);
  EXPECT_NE(content_of(fs::path(folder) / "particles_0000.vtp").find("mechanism_shear_strain"), std::string::npos);
}

TEST_F(SafetyCommand, SaysWhatIsWrongWithItsTimes) {
  const Outcome outcome = call(words("safety", {"--at", "noon"}));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.errors.find("safety.times.0"), std::string::npos) << outcome.errors;
}

// Interrupted in the search itself, at the start, on the way and at the end.
TEST_F(SafetyCommand, ARunThatIsInterruptedWhileItSearchesEndsAsIfItWereNot) {
  const std::vector<std::string> more{"--set",
                                      "safety.times=[0 s, 0.1 s, 0.2 s]",
                                      "--quiet",
                                      "--set",
                                      "safety.tolerance=0.001",
                                      "--checkpoint-interval",
                                      "0",
                                      "--set",
                                      "domain.cell_size=0.125 m"};
  const auto run = [&](const std::string& folder, const std::string& flag = "--overwrite") {
    std::vector<std::string> all = words("run", more);
    all.insert(all.end(), {"-o", (scratch_ / folder).string(), flag});
    return all;
  };
  ASSERT_EQ(call(run("whole")).exit_code, 0);
  int interrupted = 0;
  for (int k = 1; k < 12; ++k) {
    Program program(run("pieces", "--resume"), scratch_);
    while (program.running() && !program.catches(SIGINT)) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    std::this_thread::sleep_for(std::chrono::milliseconds(60 * k));
    if (program.running()) program.signal(SIGINT);
    const Outcome outcome = program.wait();
    ASSERT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 130) << outcome.errors;
    if (outcome.exit_code == 0) break;
    ++interrupted;
  }
  EXPECT_GT(interrupted, 1);
  ASSERT_EQ(call(run("pieces", "--resume")).exit_code, 0);
  for (const char* name : {"safety.csv", "history.csv", "budget.csv", "particles.pvd", "particles_0000.vtp",
                           "particles_0001.vtp", "particles_0002.vtp"}) {
    EXPECT_EQ(content_of(scratch_ / "whole" / name), content_of(scratch_ / "pieces" / name)) << name;
  }
}

}  // namespace
}  // namespace slope::tools::test
