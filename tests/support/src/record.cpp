#include "slope/testing/record.hpp"

#include <filesystem>
#include <fstream>
#include <iomanip>
#include <limits>
#include <sstream>

namespace slope::testing {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

std::string shown(double value, std::string_view unit) {
  std::ostringstream text;
  text << std::setprecision(4) << (unit == "%" ? 100.0 * value : value);
  if (!unit.empty()) text << " " << unit;
  return text.str();
}

std::string shown(Asked asked, std::string_view unit) {
  if (asked.lowest == -unlimited) return "at most " + shown(asked.highest, unit);
  if (asked.highest == unlimited) return "at least " + shown(asked.lowest, unit);
  const auto highest = shown(asked.highest, unit);
  const auto lowest = shown(asked.lowest, unit);
  return lowest.substr(0, lowest.find(' ')) + " to " + highest;
}

}  // namespace

Asked at_most(double limit) {
  return {-unlimited, limit};
}
Asked at_least(double limit) {
  return {limit, unlimited};
}
Asked near(double value, double tolerance) {
  return {value - tolerance, value + tolerance};
}

std::string table_row(std::string_view what, Asked asked, double reached, std::string_view unit) {
  std::ostringstream row;
  row << "| " << what << " | " << shown(asked, unit) << " | " << shown(reached, unit) << " |";
  return row.str();
}

::testing::AssertionResult record(std::string_view id, std::string_view what, Asked asked, double reached,
                                  std::string_view unit) {
  const std::filesystem::path folder = SLOPE_VERIFICATION_DIR;
  std::filesystem::create_directories(folder);
  std::ofstream file(folder / (std::string(id) + ".row"));
  file << table_row(what, asked, reached, unit) << "\n";
  if (!file.flush()) return ::testing::AssertionFailure() << "cannot write the row of " << id;

  // Written so that a NaN fails.
  const bool holds = reached >= asked.lowest && reached <= asked.highest;
  return (holds ? ::testing::AssertionSuccess() : ::testing::AssertionFailure())
         << what << ": " << shown(reached, unit) << ", asked: " << shown(asked, unit);
}

}  // namespace slope::testing
