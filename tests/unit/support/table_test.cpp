#include "slope/testing/table.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace slope::testing {
namespace {

class TableFile : public ::testing::Test {
 protected:
  Table read(const std::string& text) {
    std::ofstream(file_) << text;
    return Table(file_);
  }
  void TearDown() override { std::filesystem::remove(file_); }

  const std::filesystem::path file_ =
      std::filesystem::temp_directory_path() /
      ("slope_table_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()) + ".csv");
};

TEST_F(TableFile, TakesTheNamesFromTheLastCommentLine) {
  const auto table = read("# source, with commas\n# z_m, p_Pa\n0, -1.5e3\n0.5,-7e-104\n");
  EXPECT_EQ(table.names(), (std::vector<std::string>{"z_m", "p_Pa"}));
  EXPECT_EQ(table.column("z_m"), (std::vector<double>{0.0, 0.5}));
  EXPECT_EQ(table.column("p_Pa"), (std::vector<double>{-1.5e3, -7e-104}));
}

TEST_F(TableFile, TakesTheNamesFromTheFirstLineWithoutNumbers) {
  const auto table = read("# source\nt,u\n1,2\n3,4\n");
  EXPECT_EQ(table.rows(), 2u);
  EXPECT_EQ(table.column("u"), (std::vector<double>{2.0, 4.0}));
}

TEST_F(TableFile, SaysWhatIsWrong) {
  EXPECT_THROW((void)read("# a,b\n1,2\n3\n"), std::runtime_error);
  EXPECT_THROW((void)read("# a,b\n1,2\n3,x\n"), std::runtime_error);
  EXPECT_THROW((void)read("# a,b\n1,2\n").column("c"), std::out_of_range);
  EXPECT_THROW((void)Table("no/such/file.csv"), std::runtime_error);
}

TEST(Reference, EveryFileCanBeRead) {
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(SLOPE_TEST_REFERENCE_DIR)) {
    if (entry.path().extension() != ".csv") continue;
    const Table table(entry.path());
    // A summary is one row, everything else a curve.
    EXPECT_GE(table.rows(), entry.path().filename() == "summary.csv" ? 1u : 2u) << entry.path();
    EXPECT_GT(table.names().size(), 1u) << entry.path();
    ++files;
  }
  EXPECT_GE(files, 8u);
  EXPECT_EQ(reference("terzaghi/terzaghi_U.csv").names(), (std::vector<std::string>{"Tv", "U"}));
}

}  // namespace
}  // namespace slope::testing
