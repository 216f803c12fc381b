#include <gtest/gtest.h>

#include "slope/couple/csv_rows.hpp"

namespace slope::couple {
namespace {

using Cells = std::vector<std::string>;

Cells first_row(const std::string& text) {
  CsvRows rows(text);
  EXPECT_TRUE(rows.next()) << text;
  return rows.cells();
}

TEST(CsvRows, CountsLinesAndPassesOverEmptyOnes) {
  CsvRows rows("\n  \na,b\n\n# c, d\n1,2");
  ASSERT_TRUE(rows.next());
  EXPECT_EQ(rows.line(), 3);
  EXPECT_FALSE(rows.is_comment());
  EXPECT_EQ(rows.cells(), (Cells{"a", "b"}));
  ASSERT_TRUE(rows.next());
  EXPECT_EQ(rows.line(), 5);
  EXPECT_TRUE(rows.is_comment());
  EXPECT_EQ(rows.cells(), (Cells{"c", "d"}));
  EXPECT_FALSE(rows.is_last());
  ASSERT_TRUE(rows.next());
  EXPECT_EQ(rows.line(), 6);
  EXPECT_EQ(rows.text(), "1,2");
  EXPECT_TRUE(rows.is_last());
  EXPECT_FALSE(rows.next());
  EXPECT_FALSE(CsvRows("").next());
  EXPECT_FALSE(CsvRows("\n \n#\n## #").next()) << "an empty comment is no row: it would be taken for a header";
  EXPECT_EQ(first_row("## a, b"), (Cells{"a", "b"}));
}

TEST(CsvRows, KeepsEmptyCells) {
  EXPECT_EQ(first_row(","), (Cells{"", ""}));
  EXPECT_EQ(first_row("a,,b,"), (Cells{"a", "", "b", ""}));
}

TEST(CsvRows, TakesOffBlanksAndQuotes) {
  EXPECT_EQ(first_row("  a b ,\tc\t, d"), (Cells{"a b", "c", "d"}));
  EXPECT_EQ(first_row(R"("x [m]", "y, [m]" ,3)"), (Cells{"x [m]", "y, [m]", "3"}));
  EXPECT_EQ(first_row(R"("a ""b"" c","")"), (Cells{"a \"b\" c", ""}));
  EXPECT_EQ(first_row(R"("""")"), (Cells{"\""}));
  EXPECT_EQ(first_row(R"(5" of rain,1)"), (Cells{"5\" of rain", "1"})) << "a quote in the middle is a letter";
  EXPECT_EQ(first_row("\"open, to the end\n1,2"), (Cells{"open, to the end"})) << "but not beyond the line";
}

}  // namespace
}  // namespace slope::couple
