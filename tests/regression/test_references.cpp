#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>

#include "case/input.hpp"
#include "picture_difference.hpp"
#include "regression_case.hpp"
#include "schema_checker.hpp"
#include "slope/couple/results.hpp"
#include "table_difference.hpp"

namespace slope::testing {
namespace {

namespace fs = std::filesystem;

void expect_tables_close(const RegressionCase& tested) {
  const Tolerances asked = tested.tolerances();
  ASSERT_FALSE(asked.tables.empty());
  for (const auto& [file, tolerances] : asked.tables) {
    const fs::path actual = tested.products() / file;
    const fs::path reference = tested.references() / file;
    const auto found = deviations(Table(actual), Table(reference), tolerances);
    const std::string wrong = complaints(found);
    EXPECT_TRUE(wrong.empty()) << wrong << "actual:    " << actual.string() << "\nreference: " << reference.string();
    const auto worst = std::ranges::max_element(found, {}, &Deviation::share);
    fmt::print("{}: at most {:.2g} of what is allowed, in {}\n", file, worst->share, worst->column);
  }
}

/// Leaves reference and difference beside each other in the build tree.
std::string leave_pictures(const RegressionCase& tested, const fs::path& file, const PictureDifference& difference) {
  const fs::path folder = tested.built() / "differences";
  fs::create_directories(folder);
  const fs::path reference = folder / (file.stem().string() + "_reference.png");
  const fs::path shown = folder / (file.stem().string() + "_difference.png");
  fs::copy_file(tested.references() / file, reference, fs::copy_options::overwrite_existing);
  write_picture(shown, difference.picture);
  return fmt::format(
      "worst around {} pixels from the left, {} from the top\nactual:     {}\nreference:  {}\ndifference: {}",
      difference.x, difference.y, (tested.products() / file).string(), reference.string(), shown.string());
}

void expect_pictures_close(const RegressionCase& tested) {
  const Tolerances asked = tested.tolerances();
  ASSERT_FALSE(asked.pictures.empty());
  for (const std::string& file : asked.pictures) {
    const auto difference = picture_difference(tested.products() / file, tested.references() / file);
    fmt::print("{}: difference {:.3g}, allowed {:g}\n", file, difference.largest, asked.picture_threshold);
    EXPECT_LE(difference.largest, asked.picture_threshold) << leave_pictures(tested, file, difference);
  }
}

/// Its summary is what the schema says, and is read and written again as it is.
void expect_described_summary(const RegressionCase& tested) {
  std::ifstream stream(tested.run() / "summary.json", std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  std::vector<couple::Problem> problems;
  const auto parsed = [&problems](const std::string& json) {
    return couple::parse_yaml(json, "text", problems, {"summary", "JSON", 20'000});
  };
  const auto violations = couple::test::schema_violations(parsed(couple::summary_schema()), parsed(text));
  EXPECT_TRUE(problems.empty());
  EXPECT_TRUE(violations.empty()) << violations.front();
  EXPECT_EQ(couple::summary_json(couple::read_summary(tested.run() / "summary.json")), text);
}

/// The files of a folder with an extension.
std::set<std::string> files_in(const fs::path& folder, const char* extension) {
  std::set<std::string> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == extension) files.insert(entry.path().filename().string());
  }
  return files;
}

/// A reference that nothing is compared with would go stale unseen.
void expect_every_reference_compared(const RegressionCase& tested) {
  const Tolerances asked = tested.tolerances();
  EXPECT_EQ(files_in(tested.references(), ".png"), std::set(asked.pictures.begin(), asked.pictures.end()));
  std::set<std::string> tables;
  for (const auto& entry : asked.tables) tables.insert(entry.first);
  EXPECT_EQ(files_in(tested.references(), ".csv"), tables);
}

TEST(ShortColumn, TablesAreAsBefore) {
  expect_tables_close(short_column);
}
TEST(ShortColumn, PicturesAreAsBefore) {
  expect_pictures_close(short_column);
}
TEST(ShortColumn, SummaryIsWhatItsSchemaDescribes) {
  expect_described_summary(short_column);
}
TEST(ShortColumn, EveryReferenceIsCompared) {
  expect_every_reference_compared(short_column);
}

TEST(ShortSlope, TablesAreAsBefore) {
  expect_tables_close(short_slope);
}
TEST(ShortSlope, PicturesAreAsBefore) {
  expect_pictures_close(short_slope);
}
TEST(ShortSlope, SummaryIsWhatItsSchemaDescribes) {
  expect_described_summary(short_slope);
}
TEST(ShortSlope, EveryReferenceIsCompared) {
  expect_every_reference_compared(short_slope);
}

}  // namespace
}  // namespace slope::testing
