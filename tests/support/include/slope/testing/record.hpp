#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace slope::testing {

/// What a verification asks of its figure.
struct Asked {
  double lowest;
  double highest;
};
[[nodiscard]] Asked at_most(double limit);
[[nodiscard]] Asked at_least(double limit);
[[nodiscard]] Asked near(double value, double tolerance);

/// Checks a figure and writes it down for the verification table of the README, whether it holds or not:
///
///     EXPECT_TRUE(record("terzaghi-pressure", "Terzaghi, pressure, 40 cells", at_most(0.01), error, "%"));
///
/// @param id    names the row: unique, in lower case with hyphens; the table is sorted by it.
/// @param what  the problem and the quantity, for the reader of the table.
/// @param unit  of both figures; "%": they are fractions and shown times 100; "": none.
[[nodiscard]] ::testing::AssertionResult record(std::string_view id, std::string_view what, Asked asked, double reached,
                                                std::string_view unit);

/// The row that record() writes: "| what | asked | reached |".
[[nodiscard]] std::string table_row(std::string_view what, Asked asked, double reached, std::string_view unit);

}  // namespace slope::testing
