#include <gtest/gtest.h>

#include <cstdint>
#include <fstream>
#include <stdexcept>

#include "picture_difference.hpp"
#include "table_difference.hpp"

namespace slope::testing {
namespace {

/// A white picture with a black line, `row` pixels from below.
vtkSmartPointer<vtkImageData> picture_of_a_line(int row, int width = 100, int height = 80) {
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(width, height, 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* value = static_cast<std::uint8_t*>(picture->GetScalarPointer());
  std::fill_n(value, 3 * width * height, static_cast<std::uint8_t>(255));
  std::fill_n(value + 3 * width * row, 3 * width, static_cast<std::uint8_t>(0));
  return picture;
}

TEST(PictureDifference, IsNoneForALineThatMovesByAPixel) {
  EXPECT_EQ(picture_difference(picture_of_a_line(70), picture_of_a_line(70)).largest, 0.0);
  EXPECT_EQ(picture_difference(picture_of_a_line(70), picture_of_a_line(71)).largest, 0.0);
}

TEST(PictureDifference, IsTwoRowsOfATileForALineThatMovesFarther) {
  const auto difference = picture_difference(picture_of_a_line(70), picture_of_a_line(72));
  EXPECT_DOUBLE_EQ(difference.largest, 255.0 * 2.0 / tile_width);
  EXPECT_EQ(difference.y, tile_width / 2);  // the uppermost tiles hold both lines
  const auto* shown = static_cast<const std::uint8_t*>(difference.picture->GetScalarPointer(50, 70, 0));
  EXPECT_EQ(*shown, 0);
  EXPECT_EQ(*static_cast<const std::uint8_t*>(difference.picture->GetScalarPointer(50, 71, 0)), 255);
}

TEST(PictureDifference, NeedsPicturesOfOneSize) {
  EXPECT_THROW((void)picture_difference(picture_of_a_line(70), picture_of_a_line(70, 101)), std::runtime_error);
  EXPECT_THROW((void)picture_difference(picture_of_a_line(70), picture_of_a_line(70, 100, 81)), std::runtime_error);
}

TEST(PictureDifference, NeedsPictures) {
  EXPECT_THROW((void)read_picture("no-such-picture.png"), std::runtime_error);
}

/// A file of the running test's own.
std::filesystem::path written(const std::string& name, const std::string& content) {
  const std::string test = ::testing::UnitTest::GetInstance()->current_test_info()->name();
  auto file = std::filesystem::path(::testing::TempDir()) / (test + "_" + name);
  std::ofstream(file) << content;
  return file;
}

Table table(const std::string& name, const std::string& content) {
  return Table(written(name + ".csv", content));
}

const TableTolerances along_time{ColumnTolerance{"t", {0.25, 0.0}}, {{"u", {0.1, 0.0}}}};
const TableTolerances by_row{std::nullopt, {{"u", {0.1, 0.01}}}};

std::string complaints_about(const std::string& actual, const std::string& reference, const TableTolerances& asked) {
  return complaints(deviations(table("actual", actual), table("reference", reference), asked));
}

TEST(TableDifference, IsMeasuredByTheTolerance) {
  const auto found = deviations(table("actual", "u\n1\n10.3\n"), table("reference", "u\n1\n10\n"), by_row);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].column, "u");
  EXPECT_EQ(found[0].along, 1.0);
  EXPECT_NEAR(found[0].share, 0.3 / 0.2, 1e-12);
  EXPECT_EQ(complaints(found), "  u: 10.3 instead of 10 at 1, 1.5 times what is allowed\n");
}

TEST(TableDifference, LetsACurveBeLateByTheToleranceAlongIt) {
  const std::string jump = "t,u\n0,0\n1,0\n2,100\n3,100\n";
  EXPECT_EQ(complaints_about("t,u\n0.2,0\n1.2,0\n2.2,100\n3.2,100\n", jump, along_time), "");
  EXPECT_NE(complaints_about("t,u\n0.2,0\n1.4,0\n2.4,100\n3.2,100\n", jump, along_time).find("u:"), std::string::npos);
}

TEST(TableDifference, SeesACurveThatEndsElsewhere) {
  EXPECT_NE(complaints_about("t,u\n0,1\n2,1\n", "t,u\n0,1\n3,1\n", along_time).find("t:"), std::string::npos);
  EXPECT_NE(complaints_about("t,u\n1,1\n3,1\n", "t,u\n0,1\n3,1\n", along_time).find("t:"), std::string::npos);
}

TEST(TableDifference, SeesWhatIsNoNumber) {
  EXPECT_NE(complaints_about("u\nnan\n", "u\n1\n", by_row), "");
  EXPECT_NE(complaints_about("t,u\n0,1\n1,nan\n3,1\n", "t,u\n0,1\n1,1\n3,1\n", along_time), "");
}

TEST(TableDifference, NeedsTheSameColumnsAndRows) {
  EXPECT_THROW((void)complaints_about("v\n1\n", "u\n1\n", by_row), std::out_of_range);
  EXPECT_THROW((void)complaints_about("u\n1\n2\n", "u\n1\n", by_row), std::runtime_error);
  EXPECT_THROW((void)complaints_about("u\n", "u\n1\n", by_row), std::runtime_error);
}

TEST(Tolerances, EachColumnNeedsOne) {
  const std::string rest = "}}}}\npictures: {threshold: 1, files: []}\n";
  EXPECT_NO_THROW((void)read_tolerances(written("right.yaml", "tables: {a.csv: {columns: {u: {absolute: 1" + rest)));
  EXPECT_THROW((void)read_tolerances(written("wrong.yaml", "tables: {a.csv: {columns: {u: {absolut: 1" + rest)),
               std::runtime_error);
}

}  // namespace
}  // namespace slope::testing
