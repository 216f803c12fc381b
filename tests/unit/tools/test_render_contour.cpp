#include <gtest/gtest.h>

#include "contour_picture.hpp"
#include "picture_file.hpp"
#include "scratch_folder.hpp"
#include "slope/couple/read_case.hpp"
#include "synthetic_slope.hpp"

namespace slope::tools::test {
namespace {

ContourPanel panel_of(vtkPolyData* particles, const std::string& field) {
  ContourPanel panel;
  panel.particles = particles;
  panel.field = field_called(field);
  panel.scale = common_scale(panel.field, {particles});
  panel.domain = {{0.0, 0.0}, {36.0, 14.0}, 0.5, 4};
  panel.failure_strain = 0.02;
  panel.title = "A synthetic slope";
  panel.caption = "t = 0 s";
  return panel;
}

TEST(ContourPicture, DrawsEveryField) {
  const ScratchFolder folder;
  const auto particles = as_polydata(synthetic_slope(0.0));
  for (const Field& field : drawable_fields()) {
    Canvas canvas(800, 340, 32.0);
    draw_contour_panel(canvas, {60.0, 40.0, 780.0, 320.0}, panel_of(particles, field.name));
    canvas.write_png(folder.path() / (field.name + ".png"));
    const PictureFile picture(folder.path() / (field.name + ".png"));
    EXPECT_FALSE(picture.is_white(60 + 20 * 30, 40 + 20 * 8)) << field.name;
  }
}

TEST(ContourPicture, ShowsStandingWaterInItsRange) {
  const ScratchFolder folder;
  const auto particles = as_polydata(synthetic_slope(0.0));
  Canvas canvas(800, 340, 32.0);
  ContourPanel panel = panel_of(particles, "suction");
  panel.standing_water = {{{0.0, 6.0}, 8.0}, {{30.0, 36.0}, 11.0}};
  draw_contour_panel(canvas, {60.0, 40.0, 780.0, 320.0}, panel);
  canvas.write_png(folder.path() / "panel.png");
  const PictureFile picture(folder.path() / "panel.png");
  const auto white_at = [&](double x, double y) {
    return picture.is_white(static_cast<int>(60.0 + 20.0 * x), static_cast<int>(40.0 + 20.0 * y));
  };
  EXPECT_FALSE(white_at(3.0, 6.5)) << "water on the toe";
  EXPECT_TRUE(white_at(3.0, 9.0)) << "air above it";
  EXPECT_TRUE(white_at(8.0, 6.5)) << "beyond its range";
  EXPECT_TRUE(white_at(33.0, 13.0)) << "a level below the crest stands nowhere";
}

TEST(ContourPicture, TakesTheLevelsOfReservoirsAtTheirTime) {
  couple::Case input;
  couple::WaterBoundary lake;
  lake.condition = couple::Reservoir{{{{0.0, 3.0}, {10.0, 5.0}}}};
  lake.where.to = 12.0;
  input.water_boundaries = {lake};
  EXPECT_TRUE(standing_water_at(input, 0.0).empty()) << "it comes with the start";
  ASSERT_EQ(standing_water_at(input, 5.0).size(), 1u);
  EXPECT_EQ(standing_water_at(input, 5.0)[0].level, 4.0);
  EXPECT_EQ(standing_water_at(input, 5.0)[0].x.high, 12.0);
  input.water_boundaries[0].initial = true;
  EXPECT_EQ(standing_water_at(input, 0.0).at(0).level, 3.0);
}

TEST(ContourPicture, ShowsSoilAirAndWaterLevelWhereTheyAre) {
  const ScratchFolder folder;
  const auto particles = as_polydata(synthetic_slope(0.0));
  Canvas canvas(800, 340, 32.0);
  const Box box{60.0, 40.0, 780.0, 320.0};  // 20 pixels to a metre
  draw_contour_panel(canvas, box, panel_of(particles, "suction"));
  canvas.write_png(folder.path() / "panel.png");

  const PictureFile picture(folder.path() / "panel.png");
  const auto at = [](double x, double y) {
    return std::pair{static_cast<int>(60.0 + 20.0 * x), static_cast<int>(40.0 + 20.0 * y)};
  };
  const auto white_at = [&](double x, double y) { return picture.is_white(at(x, y).first, at(x, y).second); };
  EXPECT_TRUE(white_at(5.0, 9.0)) << "air above the toe";
  EXPECT_TRUE(white_at(30.0, 13.0)) << "air above the crest";
  EXPECT_FALSE(white_at(5.0, 1.0)) << "soil below the toe";
  EXPECT_FALSE(white_at(30.0, 11.0)) << "soil below the crest";
  for (const double x : {2.0, 12.0, 20.0, 34.0}) {
    EXPECT_TRUE(white_at(x, 3.0)) << "water level at x = " << x;
    EXPECT_TRUE(picture.is_dark(at(x, 3.0).first, at(x, 3.0).second + 3)) << "its casing above, at x = " << x;
    EXPECT_TRUE(picture.is_dark(at(x, 3.0).first, at(x, 3.0).second - 4)) << "its casing below, at x = " << x;
  }
  const auto deep = picture.pixel(at(30.0, 0.5).first, at(30.0, 0.5).second);
  const auto high = picture.pixel(at(30.0, 11.5).first, at(30.0, 11.5).second);
  EXPECT_GT(deep[2], deep[1]) << "no suction is violet";
  EXPECT_GT(high[1], high[2]) << "high suction is green to yellow";
}

TEST(ContourPicture, IsTheSameBytesAgain) {
  const ScratchFolder folder;
  const auto particles = as_polydata(synthetic_slope(640.0, 0.9, 1.8));
  const auto panel = panel_of(particles, "deviatoric_strain");
  write_contour_picture(folder.path() / "one.png", 1000, panel);
  write_contour_picture(folder.path() / "two.png", 1000, panel);
  EXPECT_FALSE(bytes_of(folder.path() / "one.png").empty());
  EXPECT_EQ(bytes_of(folder.path() / "one.png"), bytes_of(folder.path() / "two.png"));
}

TEST(ContourPicture, HasTheWidthAskedForAndTheDomainsShape) {
  const ScratchFolder folder;
  const auto particles = as_polydata(synthetic_slope(0.0));
  write_contour_picture(folder.path() / "slope.png", 800, panel_of(particles, "suction"));
  const PictureFile picture(folder.path() / "slope.png");
  EXPECT_EQ(picture.width(), 800);
  EXPECT_NEAR(picture.height(), 445, 5);

  const auto column = as_polydata(synthetic_column(0.0, 0.9));
  auto panel = panel_of(column, "suction");
  panel.domain = {{0.0, 0.0}, {0.08, 1.0}, 0.04, 4};
  write_contour_picture(folder.path() / "column.png", 800, panel);
  const PictureFile tall(folder.path() / "column.png");
  EXPECT_LE(tall.width(), 800);
  EXPECT_GT(tall.height(), tall.width());
}

TEST(ContourPicture, ScaleIsCommonRoundAndSaysWhatLiesAbove) {
  const auto start = as_polydata(synthetic_slope(0.0));
  const auto end = as_polydata(synthetic_slope(640.0, 0.9, 1.8));
  const auto suction = common_scale(field_called("suction"), {start, end});
  EXPECT_DOUBLE_EQ(suction.range.low, -30.0);
  EXPECT_DOUBLE_EQ(suction.range.high, 90.0);
  EXPECT_FALSE(suction.more_above);

  auto spiked = synthetic_slope(640.0, 0.9, 1.8);
  spiked.deviatoric_strain[100] = 7.0;
  const auto strain = common_scale(field_called("deviatoric_strain"), {start, as_polydata(spiked)});
  EXPECT_DOUBLE_EQ(strain.range.low, 0.0);
  EXPECT_LE(strain.range.high, 1.0);
  EXPECT_TRUE(strain.more_above);

  const auto nothing = common_scale(field_called("deviatoric_strain"), {start});
  EXPECT_GT(nothing.range.length(), 0.0) << "a field that is zero everywhere still has a scale";
}

TEST(ContourPicture, UnwritableFileIsAFileError) {
  const auto particles = as_polydata(synthetic_slope(0.0));
  EXPECT_THROW(write_contour_picture("/no/such/folder/picture.png", 400, panel_of(particles, "suction")),
               couple::FileError);
}

}  // namespace
}  // namespace slope::tools::test
