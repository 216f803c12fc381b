#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "program.hpp"
#include "scratch_folder.hpp"
#include "slope/couple/results.hpp"

namespace slope::tools::test {

namespace fs = std::filesystem;

inline const std::string quick = std::string(SLOPE_CASES) + "/quick.yaml";
inline const std::string box = std::string(SLOPE_CLI_TESTS) + "/box.yaml";

/// Each test calls slope-sim in a folder of its own.
class SlopeSim : public testing::Test {
 protected:
  [[nodiscard]] Outcome call(const std::vector<std::string>& arguments) const { return slope_sim(arguments, scratch_); }
  [[nodiscard]] Outcome run_box(const fs::path& out, std::vector<std::string> more = {}) const;
  [[nodiscard]] fs::path write(const std::string& name, const std::string& content) const;
  [[nodiscard]] static couple::RunSummary summary_of(const fs::path& out);
  [[nodiscard]] static std::vector<std::string> lines_of(const fs::path& file);
  /// Every row of the history is whole.
  static void expect_whole_history(const fs::path& out, std::size_t least_rows);
  /// Waits, for a minute at most, until a text stands that many times in a file that the program writes.
  [[nodiscard]] static bool has_text(Program& program, const fs::path& file, std::string_view text, int times = 1);
  /// The same until a history has that many rows below its header.
  [[nodiscard]] static bool has_rows(Program& program, const fs::path& history, int rows) {
    return has_text(program, history, "\n", rows + 1);
  }

 private:
  ScratchFolder folder_;

 protected:
  const fs::path& scratch_ = folder_.path();
};

}  // namespace slope::tools::test
