#include "slope/testing/record.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

namespace slope::testing {
namespace {

TEST(Record, RowShowsWhatWasAskedBesideWhatWasReached) {
  EXPECT_EQ(table_row("pressure", at_most(0.01), 0.00432, "%"), "| pressure | at most 1 % | 0.432 % |");
  EXPECT_EQ(table_row("order", at_least(1.8), 1.9312, ""), "| order | at least 1.8 | 1.931 |");
  EXPECT_EQ(table_row("P/q", near(0.9974, 1e-3), 0.99741, ""), "| P/q | 0.9964 to 0.9984 | 0.9974 |");
  EXPECT_EQ(table_row("stress", near(0.5, 0.1), 0.5, "%"), "| stress | 40 to 60 % | 50 % |");
}

TEST(Record, WritesItsRowAndTellsWhetherItHolds) {
  const auto file = std::filesystem::path(SLOPE_VERIFICATION_DIR) / "support-self-test.row";
  EXPECT_TRUE(record("support-self-test", "figure", at_most(1.0), 0.5, "m"));
  std::string row;
  std::getline(std::ifstream(file), row);
  EXPECT_EQ(row, "| figure | at most 1 m | 0.5 m |");

  EXPECT_FALSE(record("support-self-test", "figure", at_most(1.0), 1.5, "m"));
  EXPECT_FALSE(record("support-self-test", "figure", at_least(2.0), 1.5, "m"));
  EXPECT_FALSE(record("support-self-test", "figure", near(2.0, 0.1), std::numeric_limits<double>::quiet_NaN(), "m"));
  std::filesystem::remove(file);  // no row of the README's table
}

}  // namespace
}  // namespace slope::testing
