// `slope-sim profile`.

#include <gtest/gtest.h>

#include "slope_sim_test.hpp"

namespace slope::tools::test {
namespace {

/// A VTK file with these points (x y z) and these lines (numbers of points).
std::string poly_lines(const std::vector<std::string>& points, const std::vector<std::vector<int>>& lines) {
  std::string all, connectivity, offsets;
  for (const std::string& point : points) all += point + " ";
  std::size_t end = 0;
  for (const auto& line : lines) {
    for (const int point : line) connectivity += std::to_string(point) + " ";
    offsets += std::to_string(end += line.size()) + " ";
  }
  return "<VTKFile type=\"PolyData\" version=\"0.1\"><PolyData><Piece NumberOfPoints=\"" +
         std::to_string(points.size()) + "\" NumberOfLines=\"" + std::to_string(lines.size()) +
         "\"><Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">" + all +
         "</DataArray></Points><Lines><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">" +
         connectivity + "</DataArray><DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">" + offsets +
         "</DataArray></Lines></Piece></PolyData></VTKFile>\n";
}

TEST_F(SlopeSim, ProfileTurnsAPolyLineIntoATable) {
  const fs::path table = scratch_ / "ground.csv";
  const std::vector<std::string> points{"11 5 0", "0 1 0", "2.5 1 0", "7.2 5 0"};
  for (const auto& lines : std::vector<std::vector<std::vector<int>>>{{{1, 2, 3, 0}}, {{0, 3}, {3, 2}, {2, 1}}}) {
    fs::remove(table);
    const Outcome outcome = call({"profile", write("ground.vtp", poly_lines(points, lines)), "-o", table});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    EXPECT_EQ(content_of(table), "x_m,y_m\n0,1\n2.5,1\n7.2,5\n11,5\n");
  }
  std::string content = content_of(quick);
  const std::string polygon = "polygon: [[0 m, 0 m], [11 m, 0 m], [11 m, 5 m], [7.2 m, 5 m], [2.5 m, 1 m], [0 m, 1 m]]";
  ASSERT_NE(content.find(polygon), std::string::npos);
  content.replace(content.find(polygon), polygon.size(), "surface: {file: ground.csv}");
  const Outcome check = call({"check", write("case.yaml", content)});
  EXPECT_EQ(check.exit_code, 0) << check.errors;
  EXPECT_NE(check.output.find("fine: 569 particles"), std::string::npos) << "as with the polygon: " << check.output;
}

TEST_F(SlopeSim, ProfileRefusesWhatIsNoGroundSurface) {
  const auto errors = [&](const std::string& content) {
    const Outcome outcome = call({"profile", write("ground.vtp", content), "-o", scratch_ / "ground.csv"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_FALSE(fs::exists(scratch_ / "ground.csv"));
    return outcome.errors;
  };
  const std::string file = (scratch_ / "ground.vtp").string();
  EXPECT_EQ(errors(poly_lines({"0 0 0", "1 0 0", "2 0 0", "3 0 0"}, {{0, 1}, {2, 3}})),
            file + ": holds more than one poly-line; keep the one of the ground surface\n");
  EXPECT_EQ(errors(poly_lines({"0 0 0"}, {})),
            file + ": holds no poly-line; write the ground surface as one line of points\n");
  EXPECT_EQ(errors(poly_lines({"0 0 0", "2 0 0", "1 1 0", "3 1 0"}, {{0, 1, 2, 3}})),
            file + ": the poly-line turns back at x = 1 m; a ground surface has no overhang\n");
  EXPECT_EQ(errors("x_m,y_m\n0,1\n"), file + ": is not a VTK PolyData file (.vtp)\n");
  EXPECT_EQ(errors(""), file + ": is not a VTK PolyData file (.vtp)\n");
  EXPECT_EQ(call({"profile", scratch_ / "none.vtp", "-o", scratch_ / "ground.csv"}).exit_code, 4);
}

// VTK takes a file by its word: points that are not there were read from beyond the array (a segmentation fault), and
// sizes that no ground surface has were asked for.
TEST_F(SlopeSim, ProfileRefusesDamagedFiles) {
  const std::vector<std::string> points{"0 0 0", "1 1 0", "2 2 0"};
  const auto told = [&](const std::string& content) {
    const Outcome outcome = call({"profile", write("ground.vtp", content), "-o", scratch_ / "ground.csv"});
    EXPECT_EQ(outcome.exit_code, 2) << outcome.errors;
    EXPECT_FALSE(fs::exists(scratch_ / "ground.csv"));
    const std::string file = (scratch_ / "ground.vtp").string() + ": ";
    return outcome.errors.starts_with(file) ? outcome.errors.substr(file.size()) : outcome.errors;
  };
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string content = poly_lines(points, {{0, 1, 2}});
    const std::size_t at = content.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return told(content.replace(at, from.size(), to));
  };
  EXPECT_EQ(told(poly_lines(points, {{0, 1, 7}})), "its line goes through point 7 of 3\n");
  EXPECT_EQ(told(poly_lines(points, {{0, 1, 1'000'000'000}})), "its line goes through point 1000000000 of 3\n");
  EXPECT_EQ(told(poly_lines(points, {{0, -5, 2}})), "its line goes through point -5 of 3\n");
  EXPECT_EQ(told(poly_lines({"0 0 0", "1 inf 0", "2 2 0"}, {{0, 1, 2}})), "its point 1 lies at x = 1 m, y = inf m\n");
  EXPECT_EQ(with("NumberOfPoints=\"3\"", "NumberOfPoints=\"1000000000000\""),
            "has NumberOfPoints=\"1000000000000\"; from 0 to 1000000 can be read\n");
  EXPECT_EQ(with("NumberOfLines=\"1\"", "NumberOfLines=\"-1\""),
            "has NumberOfLines=\"-1\"; from 0 to 1000000 can be read\n");
  for (const std::string components : {"1000000000", "-3"}) {
    EXPECT_EQ(with("NumberOfComponents=\"3\"", "NumberOfComponents=\"" + components + "\""),
              "has NumberOfComponents=\"" + components + "\"; from 0 to 9 can be read\n");
  }
  for (const std::string offset : {"30000000 ", "-3 "}) (void)with(">3 <", ">" + offset + "<");
}

}  // namespace
}  // namespace slope::tools::test
