#include <gtest/gtest.h>

#include <algorithm>

#include "program.hpp"
#include "scratch_folder.hpp"
#include "shell_cases.hpp"

namespace slope::tools::test {
namespace {

namespace fs = std::filesystem;

class DamagedFolder : public testing::TestWithParam<ShellCase> {};

TEST_P(DamagedFolder, IsDrawnAsFarAsItCanBe) {
  const ShellCase& damage = GetParam();
  const int exit_code = std::stoi(damage.expected.at(0));
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "run";
  fs::copy(SLOPE_GOOD_RUN, folder);
  do_in(folder, damage.command,
        "particles() { '" SLOPE_CHANGE_PARTICLES "' \"$@\"; }\nBROKEN_RUN='" SLOPE_BROKEN_RUN "'\n");

  Program program({folder.string(), "--width", "400", "--field", "suction"}, scratch.path(), SLOPE_RENDER);
  const Outcome outcome = program.wait();
  EXPECT_EQ(outcome.exit_code, exit_code) << outcome.errors.substr(0, 2000);
  EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'), std::stol(damage.expected.at(1)))
      << outcome.output;
  EXPECT_NE(outcome.errors.find(damage.expected.at(2)), std::string::npos) << outcome.errors.substr(0, 2000);
  EXPECT_LT(outcome.errors.size(), 40000u) << "nobody reads that";
  EXPECT_EQ(outcome.errors.empty(), exit_code == 0 && damage.expected.at(2).empty()) << outcome.errors.substr(0, 2000);
}

INSTANTIATE_TEST_SUITE_P(With, DamagedFolder, testing::ValuesIn(shell_cases(SLOPE_CLI_TESTS "/damaged_folders.txt", 3)),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace slope::tools::test
