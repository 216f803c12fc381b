#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "field_image.hpp"
#include "slope/couple/read_case.hpp"
#include "synthetic_slope.hpp"

namespace slope::tools::test {
namespace {

const ImageGrid slope_grid{{0.0, 0.0}, {36.0, 14.0}, 720, 280};

double ground(double x) {
  return x <= 10.0 ? 5.0 : std::min(12.0, 5.0 + (x - 10.0) * 7.0 / 12.6);
}

TEST(FieldImage, LinearFieldComesOutUnchangedInside) {
  auto table = synthetic_slope(0.0);
  const auto linear = [](double x, double y) { return 3.0 - 2.0 * x + 0.7 * y; };
  for (std::size_t p = 0; p < table.position.size(); ++p) {
    auto& x = table.position[p];
    // Off the lattice, where a weighted mean alone would be wrong.
    x[0] += 0.05 * std::sin(7.0 * static_cast<double>(p));
    x[1] += 0.05 * std::cos(11.0 * static_cast<double>(p));
    table.suction[p] = linear(x[0], x[1]);
  }
  const FieldImage image(as_polydata(table), slope_grid, {"suction"});
  for (double x = 1.0; x < 35.5; x += 1.7) {
    for (double y = 1.0; y < ground(x) - 1.0; y += 0.6) {
      ASSERT_TRUE(image.inside({x, y})) << x << ", " << y;
      EXPECT_NEAR(image.value("suction", {x, y}), linear(x, y), 1.0e-9) << x << ", " << y;
    }
  }
}

TEST(FieldImage, SoilEndsWhereTheParticlesEnd) {
  const FieldImage image(as_polydata(synthetic_slope(0.0)), slope_grid, {"suction"});
  for (double x = 0.1; x < 36.0; x += 0.9) {
    EXPECT_TRUE(image.inside({x, 0.1})) << "base at " << x;
    EXPECT_TRUE(image.inside({x, ground(x) - 0.3})) << "below the surface at " << x;
    EXPECT_FALSE(image.inside({x, ground(x) + 0.3})) << "above the surface at " << x;
  }
  const auto outline = image.outline();
  ASSERT_EQ(outline.size(), 1U);
  double left = 36.0;
  double right = 0.0;
  for (const auto& x : outline.front()) {
    left = std::min(left, x[0]);
    right = std::max(right, x[0]);
    EXPECT_NEAR(x[1], ground(x[0]), 0.25) << "at " << x[0];
    if (x[0] < 9.0 || x[0] > 24.0) {
      EXPECT_NEAR(x[1], ground(x[0]), 0.03) << "level ground at " << x[0];
    }
  }
  EXPECT_NEAR(left, 0.0, 0.03);
  EXPECT_NEAR(right, 36.0, 0.03);
}

TEST(FieldImage, WaterLevelOfAHydrostaticFieldIsItsWaterTable) {
  const FieldImage image(as_polydata(synthetic_slope(0.0)), slope_grid, {"pore_pressure"});
  const auto lines = image.without_surface(image.iso_lines("pore_pressure", 0.0));
  ASSERT_EQ(lines.size(), 1U);
  for (const auto& x : lines.front()) {
    EXPECT_NEAR(x[1], 3.0, 1.0e-3) << "at " << x[0];
  }
  const auto [first, last] = std::minmax(lines.front().front()[0], lines.front().back()[0]);
  EXPECT_NEAR(first, 0.0, 0.03);
  EXPECT_NEAR(last, 36.0, 0.03);
}

TEST(FieldImage, LineAlongTheSurfaceIsLeftOutAndOneThatReachesItStays) {
  auto table = synthetic_slope(0.0);
  for (std::size_t p = 0; p < table.position.size(); ++p) {
    const auto& x = table.position[p];
    const double depth = ground(x[0]) - x[1];
    table.pore_pressure[p] =
        std::min(depth - 0.2, 9.0 - x[1]);  // zero along the surface below y = 8.8 m, and at y = 9 m
  }
  const FieldImage image(as_polydata(table), slope_grid, {"pore_pressure"});
  const auto lines = image.without_surface(image.iso_lines("pore_pressure", 0.0));
  ASSERT_EQ(lines.size(), 1U);
  double leftmost = 36.0;
  for (const auto& x : lines.front()) {
    EXPECT_NEAR(x[1], 9.0, 0.5);
    leftmost = std::min(leftmost, x[0]);
  }
  EXPECT_NEAR(leftmost, 17.6, 0.8) << "the line reaches the face";
}

TEST(FieldImage, VectorsAreDrawnByTheirLengthAndMissingArraysAreNamed) {
  auto table = synthetic_slope(0.0);
  std::fill(table.displacement.begin(), table.displacement.end(), couple::Point{0.03, -0.04});
  const auto particles = as_polydata(table);
  EXPECT_NEAR(FieldImage(particles, slope_grid, {"displacement"}).value("displacement", {20.0, 5.0}), 0.05, 1.0e-12);
  try {
    const FieldImage image(particles, slope_grid, {"temperature"});
    FAIL() << "no array is called temperature";
  } catch (const couple::FileError& error) {
    EXPECT_NE(std::string(error.what()).find("temperature"), std::string::npos);
  }
}

}  // namespace
}  // namespace slope::tools::test
