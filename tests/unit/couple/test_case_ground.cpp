#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "case/initial_values.hpp"
#include "case/polygon.hpp"
#include "case/profile.hpp"
#include "case_folder.hpp"
#include "slope/couple/read_case.hpp"

namespace slope::couple::test {
namespace {

/// The shipped slope W2 in a folder of its own, its ground drawn by ground.csv.
class CaseGround : public testing::Test {
 protected:
  CaseGround() { folder_.write("ground.csv", "x_m,y_m\n0,5\n10,5\n22.6,12\n36,12\n"); }

  /// The case with these regions, one a line.
  [[nodiscard]] std::string content(const std::string& regions) const {
    const std::string polygon =
        "  - soil: sandy_clay\n    polygon: [[0 m, 0 m], [36 m, 0 m], [36 m, 12 m], [22.6 m, 12 m], [10 m, 5 m], [0 m, "
        "5 "
        "m]]\n";
    return slope_with(polygon, regions + "\n").content;
  }
  [[nodiscard]] Case with(const std::string& regions) const {
    return read_case(folder_.write("case.yaml", content(regions)));
  }
  /// All that is said of the case, without the folder's name.
  [[nodiscard]] std::string problems(const std::string& regions) const {
    try {
      (void)with(regions);
    } catch (const InputError& error) {
      std::string text = error.what();
      const std::string folder = folder_.path().string() + "/";
      for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder, at))
        text.erase(at, folder.size());
      return text;
    }
    return "";
  }
  /// The line of the case in which its regions begin.
  const std::string line_ = "case.yaml:" + std::to_string(slope_with("  - soil: sandy_clay", "").line);
  const CaseFolder folder_;
};

TEST_F(CaseGround, AProfileIsThePolygonBelowIt) {
  const Case drawn = with("  - {soil: sandy_clay, surface: {file: ground.csv}}");
  const std::vector<Point> expected{{0, 5}, {10, 5}, {22.6, 12}, {36, 12}, {36, 0}, {0, 0}};
  EXPECT_EQ(drawn.regions.at(0).polygon, expected);
  const std::string resolved = resolved_yaml(drawn);
  EXPECT_EQ(resolved.find("surface:"), std::string::npos) << "the case of a run stands on its own";
  EXPECT_EQ(resolved_yaml(read_case(folder_.write("resolved.yaml", resolved))), resolved);
}

TEST_F(CaseGround, ColumnsAreFoundByNameAndHaveUnits) {
  folder_.write("survey.csv",
                "# of the year\n\"station\",\"height [cm]\",\"x [km]\"\r\n1,900,0\r\n# a comment\n2,1200,0.036\r\n\n");
  const Case input = with("  - {soil: sandy_clay, surface: {file: survey.csv, x: 'x [km]', y: 'height [cm]'}}");
  EXPECT_EQ(input.regions.at(0).polygon, (std::vector<Point>{{0, 9}, {36, 12}, {36, 0}, {0, 0}}));
}

TEST_F(CaseGround, LayersFollowTheSurface) {
  const Case input = with(
      "  - {soil: sandy_clay, surface: {file: ground.csv}, base: 4 m}\n"
      "  - {soil: sandy_clay, surface: {file: ground.csv, depth: 2 m}}");
  EXPECT_EQ(input.regions.at(0).polygon.back(), (Point{0, 4}));
  const std::vector<Point> below{{0, 3}, {10, 3}, {22.6, 10}, {36, 10}, {36, 0}, {0, 0}};
  EXPECT_EQ(input.regions.at(1).polygon, below);
}

TEST_F(CaseGround, AProfileWiderThanTheDomainIsCut) {
  folder_.write("ground.csv", "x_m,y_m\n-10,3\n10,5\n10,9\n46,11\n");
  const Case input = with("  - {soil: sandy_clay, surface: {file: ground.csv}}");
  const auto& polygon = input.regions.at(0).polygon;
  ASSERT_EQ(polygon.size(), 6u);
  EXPECT_EQ(polygon[0], (Point{0, 4}));
  EXPECT_EQ(polygon[2], (Point{10, 9})) << "a step";
  EXPECT_EQ(polygon[3][0], 36.0);
  EXPECT_DOUBLE_EQ(polygon[3][1], 9.0 + 2.0 * 26.0 / 36.0);
}

TEST_F(CaseGround, WhereTheLineIsBelowTheBaseThereIsNothing) {
  const Domain domain{{0, 0}, {10, 10}, 1.0, 4};
  const auto region = region_below({{0, 1}, {5, 6}, {10, 1}}, 2.0, 1.0, domain);
  EXPECT_NEAR(std::abs(signed_area(region)), 9.0, 1e-12) << "a triangle 6 m wide and 3 m high";
  EXPECT_EQ(crossing_edges(region), std::nullopt);
}

TEST_F(CaseGround, PathsCountFromTheFileThatNamesThem) {
  std::filesystem::create_directory(folder_.path() / "base");
  folder_.write("base/ground.csv", "x_m,y_m\n0,7\n36,7\n");
  folder_.write("base/base.yaml", content("  - {soil: sandy_clay, surface: {file: ground.csv}}"));
  const Case input =
      read_case(folder_.write("case.yaml", "include: base/base.yaml\npoints: {}\n"), {"points={A: [10 m, 3 m]}"});
  EXPECT_EQ(input.regions.at(0).polygon.front(), (Point{0, 7}));
}

TEST_F(CaseGround, MistakesInTheCaseAreTold) {
  const std::string surface = ": geometry.0.surface";
  EXPECT_EQ(
      problems("  - {soil: sandy_clay}"),
      line_ +
          ": geometry.0: needs one of polygon and surface, got none; write for example \"polygon: [[0 m, 0 m], [36 "
          "m, 0 m], [36 m, 12 m]]\"");
  EXPECT_EQ(
      problems("  - {soil: sandy_clay, surface: {file: ground.csv}, polygon: [[0 m, 0 m], [1 m, 0 m], [1 m, 1 m]]}"),
      line_ +
          ": geometry.0: needs one of polygon and surface, got both; write for example \"polygon: [[0 m, 0 m], [36 "
          "m, 0 m], [36 m, 12 m]]\"");
  EXPECT_EQ(
      problems("  - {soil: sandy_clay, base: 1 m, polygon: [[0 m, 0 m], [36 m, 0 m], [36 m, 12 m], [0 m, 12 m]]}"),
      line_ + ": geometry.0.base: has a meaning only with a surface; remove it");
  EXPECT_EQ(problems("  - {soil: sandy_clay, surface: {file: gruond.csv}}"),
            line_ + surface + ".file: there is no file gruond.csv; the path counts from the folder of this file");
  EXPECT_EQ(problems("  - {soil: sandy_clay, surface: {file: ground.csv, y: z_m}}"),
            line_ + surface + ".y: ground.csv:1 has no column \"z_m\", did you mean \"x_m\"?");
  EXPECT_EQ(problems("  - {soil: sandy_clay, surface: {file: ground.csv, depth: 1}}"),
            line_ + surface +
                ".depth: expected a length with its unit, such as \"0.5 m\" (units: m, cm, mm, km), got 1 without a "
                "unit");
  EXPECT_EQ(problems("  - {soil: sandy_clay, surface: {file: ground.csv}, base: -1 m}"),
            line_ + surface +
                ": the corner (36 m, -1 m) is outside of the domain, which goes from (0 m, 0 m) to (36 m, 14 m)\n" +
                line_ + surface +
                ": the corner (0 m, -1 m) is outside of the domain, which goes from (0 m, 0 m) to (36 m, 14 m)");
  EXPECT_EQ(problems("  - {soil: sandy_clay, surface: {file: ground.csv, depth: 20 m}}"),
            line_ + surface + ": the polygon encloses no area; its corners lie on one line");
}

TEST_F(CaseGround, MistakesInTheTableAreToldWithItsLine) {
  const auto table = [&](const std::string& rows) {
    folder_.write("ground.csv", rows);
    return problems("  - {soil: sandy_clay, surface: {file: ground.csv}}");
  };
  const std::string key = ": geometry.0.surface: ";
  EXPECT_EQ(table("x_m,y_m\n0,5\n20,6\n10,7\n"),
            "ground.csv:4" + key + "x = 10 m lies left of 20 m in the line before; give the points from left to right");
  EXPECT_EQ(table("x_m,y_m\n0,5\n\n36,high\n"), "ground.csv:4" + key + "\"high\" is not a number");
  EXPECT_EQ(table("x_m,y_m\n0,5\n36\n"), "ground.csv:3" + key + "has 1 columns where the first line has 2");
  EXPECT_EQ(table("x_m,y_m\n0,5\n"), "ground.csv" + key + "needs a line of column names and at least 2 points, has 1");
  EXPECT_EQ(
      table("x_m,y_m\n0,5\n30,5\n"),
      line_ + key.substr(0, key.size() - 2) +
          ".file: ground.csv goes from x = 0 m to 30 m and does not cover the domain, from 0 m to 36 m; add points "
          "or make the domain smaller");
  folder_.write("ground.csv", "x,y\n0,5\n36,5\n");
  EXPECT_EQ(
      problems("  - {soil: sandy_clay, surface: {file: ground.csv, x: x, y: y}}"),
      line_ + key.substr(0, key.size() - 2) +
          ".x: the column \"x\" of ground.csv does not end with its unit of length; call it for example \"x_m\" or "
          "\"x [m]\"");
}

Case at_rest(const InitialWater& water) {
  Case input;
  input.initial_water = water;
  return input;
}

/// P_w that a case begins with at a point, over the unit weight of water (m).
double pressure_head(const InitialWater& water, double x, double y) {
  const Case input = at_rest(water);
  InitialParticles particles;
  particles.x = {x};
  particles.y = {y};
  return initial_pressure(input, particles).at(0) / (input.water.density * input.gravity);
}

TEST(InitialWater, IsHydrostaticUnderATableGivenAsALine) {
  const WaterTable table{{{0, 2}, {10, 4}, {20, 3}}, never};
  EXPECT_DOUBLE_EQ(pressure_head(table, 5.0, 1.0), 2.0);
  EXPECT_DOUBLE_EQ(pressure_head(table, 10.0, 1.0), 3.0);
  EXPECT_DOUBLE_EQ(pressure_head(table, 15.0, 8.0), -4.5) << "suction above it";
  EXPECT_DOUBLE_EQ(pressure_head(table, -3.0, 1.0), 1.0) << "level beyond the ends";
  EXPECT_DOUBLE_EQ(pressure_head(table, 30.0, 1.0), 2.0);
}

TEST(InitialWater, ALevelTableIsTheHydrostaticOne) {
  for (const double y : {-1.0, 2.5, 7.0}) {
    EXPECT_EQ(pressure_head(WaterTable{{{0, 3}, {20, 3}}, never}, 7.0, y),
              pressure_head(HydrostaticWater{3.0}, 7.0, y));
  }
}

TEST(InitialWater, TheCapLimitsTheSuctionAndNothingElse) {
  for (const InitialWater& water :
       {InitialWater(HydrostaticWater{3.0, 9810.0}), InitialWater(WaterTable{{{0, 3}, {20, 3}}, 9810.0})}) {
    EXPECT_DOUBLE_EQ(pressure_head(water, 1.0, 10.0), -1.0);
    EXPECT_DOUBLE_EQ(pressure_head(water, 1.0, 3.5), -0.5);
    EXPECT_DOUBLE_EQ(pressure_head(water, 1.0, 0.0), 3.0);
  }
}

TEST(InitialWater, ATableIsReadAndChecked) {
  const CaseFolder folder;
  const std::string text = "{type: hydrostatic, water_table: 3 m}";
  const auto read = [&](const std::string& water) {
    return read_case(folder.write("case.yaml", slope_with(text, water).content));
  };
  const Case input = read("{type: water_table, points: [[0 m, 2 m], [36 m, 6 m]], maximum_suction: 30 kPa}");
  const auto& table = std::get<WaterTable>(input.initial_water);
  EXPECT_EQ(table.points, (std::vector<Point>{{0, 2}, {36, 6}}));
  EXPECT_EQ(table.maximum_suction, 30.0e3);
  EXPECT_EQ(
      std::get<HydrostaticWater>(read("{type: hydrostatic, water_table: 3 m, maximum_suction: 20 kPa}").initial_water)
          .maximum_suction,
      20.0e3);
  const std::string place =
      (folder.path() / "case.yaml").string() + ":" + std::to_string(slope_with(text, "").line) + ": initial.water.";
  const auto problem = [&](const std::string& water) {
    try {
      (void)read(water);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(problem("{type: water_table, points: [[0 m, 2 m]]}"), place + "points: needs at least 2 items, got 1");
  EXPECT_EQ(problem("{type: water_table, points: [[9 m, 2 m], [0 m, 3 m]]}"),
            place + "points.1: x must be above that of the point before, 9 m, got 0 m");
  EXPECT_EQ(problem("{type: water_table}"),
            place + "points: missing; write for example \"points: [[0 m, 3 m], [36 m, 6 m]]\"");
  EXPECT_EQ(problem("{type: hydrostatic, water_table: 3 m, maximum_suction: -1 kPa}"),
            place + "maximum_suction: must be at least 0 Pa, got -1 kPa");
}

}  // namespace
}  // namespace slope::couple::test
