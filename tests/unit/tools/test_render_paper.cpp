#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "history_chart.hpp"
#include "mesh_picture.hpp"
#include "panel_picture.hpp"
#include "paper_figures.hpp"
#include "paper_report.hpp"
#include "picture_file.hpp"
#include "retention_chart.hpp"
#include "run_figures.hpp"
#include "scratch_folder.hpp"
#include "slope/couple/read_case.hpp"
#include "synthetic_run.hpp"
#include "synthetic_slope.hpp"

namespace slope::tools::test {
namespace {

namespace fs = std::filesystem;

constexpr int width = 400;

std::vector<fs::path> slope_runs(const fs::path& parent, const std::vector<std::string>& names) {
  std::vector<fs::path> folders;
  for (const auto& name : names) {
    folders.push_back(parent / name);
    write_slope_run(folders.back(), 0.5 + 0.2 * static_cast<double>(folders.size()));
  }
  return folders;
}

std::vector<std::string> stems_of(const std::vector<fs::path>& files) {
  std::vector<std::string> stems;
  for (const auto& file : files) {
    stems.push_back(file.stem().string());
  }
  return stems;
}

TEST(PaperFigures, AreAllWrittenWhenEveryRunIsThere) {
  const ScratchFolder scratch;
  auto folders = slope_runs(scratch.path(), {"slope-w1", "slope-w2", "slope-w3", "slope-h1", "slope-h2", "slope-h3"});
  folders.push_back(scratch.path() / "liakopoulos");
  write_column_run(folders.back());
  const auto figures = write_paper_figures(read_paper_runs(folders), scratch.path() / "out", width);
  EXPECT_TRUE(figures.left_out.empty()) << figures.left_out.front();
  EXPECT_EQ(stems_of(figures.written),
            (std::vector<std::string>{"fig04", "fig06", "fig07", "fig08", "fig09", "fig10", "fig11", "fig12", "fig13",
                                      "fig14", "fig15", "fig16", "fig17", "fig18"}));
  for (const auto& file : figures.written) {
    EXPECT_EQ(PictureFile(file).width(), width) << file;
  }
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

void write_slide(const fs::path& folder, double onset, double suction_left) {
  couple::RunSummary summary = summary_of_a_slide(onset);
  summary.found.zone_at_end.largest_suction = suction_left;
  write_summary(folder, summary);
}

TEST(PaperReport, JudgesByTheSummaries) {
  const ScratchFolder scratch;
  const auto folders = slope_runs(scratch.path(), {"slope-w1", "slope-w2", "slope-w3"});
  const auto report = [&](double third_onset) {
    write_slide(folders[0], 100.0, 61000.0);
    write_slide(folders[1], 200.0, 62000.0);
    write_slide(folders[2], third_onset, 63000.0);
    write_paper_report(read_paper_runs(folders), scratch.path() / "report.md");
    return text_of(scratch.path() / "report.md");
  };
  const std::string in_order = report(300.0);
  EXPECT_NE(in_order.find("| the wetter, the earlier | onset 100.0 / 200.0 / 300.0 s | holds |"), std::string::npos);
  EXPECT_NE(in_order.find("largest at the end 61.0 / 62.0 / 63.0 kPa | holds |"), std::string::npos);
  EXPECT_NE(in_order.find("| the more permeable, the earlier | onset - / - / - s | not judged |"), std::string::npos);
  EXPECT_EQ(report(300.0), in_order);
  EXPECT_NE(report(150.0).find("| the wetter, the earlier | onset 100.0 / 200.0 / 150.0 s | does not hold |"),
            std::string::npos);
}

TEST(Comparison, SetsRunsBesideTheFirst) {
  const ScratchFolder scratch;
  const auto folders = slope_runs(scratch.path(), {"one", "two"});
  write_slide(folders[0], 100.0, 61000.0);
  write_slide(folders[1], 93.0, 62000.0);
  write_comparison(folders, scratch.path() / "table.md");
  const std::string table = text_of(scratch.path() / "table.md");
  EXPECT_NE(table.find("| fails | - | 100.0 s | +0.0 % | - |"), std::string::npos) << table;
  EXPECT_NE(table.find("| fails | - | 93.0 s | -7.0 % | - |"), std::string::npos) << table;
  EXPECT_NE(table.find("| 62.0 kPa |"), std::string::npos) << table;
}

TEST(PaperFigures, NameTheRunsThatAreMissing) {
  const ScratchFolder scratch;
  const auto folders = slope_runs(scratch.path(), {"slope-w2", "slope-w3"});
  const auto figures = write_paper_figures(read_paper_runs(folders), scratch.path() / "out", width);
  EXPECT_EQ(stems_of(figures.written), (std::vector<std::string>{"fig06", "fig07", "fig08", "fig12"}));
  EXPECT_EQ(figures.left_out.front(), "fig04: no run of liakopoulos");
  EXPECT_EQ(figures.left_out[1], "fig09: no run of slope-w1");
  EXPECT_EQ(figures.left_out.back(), "fig18: no run of slope-h1; no run of slope-h2; no run of slope-h3");
  EXPECT_FALSE(fs::exists(scratch.path() / "out" / "fig10.png"));
}

TEST(PaperFigures, SayWhatARunLacks) {
  const ScratchFolder scratch;
  const auto folders = slope_runs(scratch.path(), {"slope-w1", "slope-w2", "slope-w3"});
  couple::RunSummary unfinished = summary_of_a_slide(300.0);
  unfinished.found.end_reason = couple::EndReason::running;
  write_summary(folders[0], unfinished);
  ParticleFileSeries stood(folders[1]);
  stood.write(synthetic_slope(0.0), "start");
  stood.write(synthetic_slope(640.0), "end");
  const auto figures = write_paper_figures(read_paper_runs(folders), scratch.path() / "out", width);
  EXPECT_EQ(stems_of(figures.written), (std::vector<std::string>{"fig06", "fig12"}));
  EXPECT_EQ(figures.left_out[1], "fig07: slope-w2 did not fail");
  EXPECT_EQ(figures.left_out[3], "fig09: the run " + folders[0].string() + " did not come to its end");
}

TEST(PaperRuns, AreToldByTheirFolderAndThenByTheirCaseFile) {
  RunFolder run;
  run.path = fs::path("runs") / "slope-w3" / "";
  run.summary.emplace().case_file = "cases/slope-w2.yaml";
  EXPECT_EQ(paper_case_of(run), "slope-w3");
  run.path = "runs/tuesday";
  EXPECT_EQ(paper_case_of(run), "slope-w2");
  run.summary->case_file = "cases/my-slope.yaml";
  EXPECT_EQ(paper_case_of(run), "");
}

TEST(PaperRuns, OfUnknownCasesOrGivenTwiceAreRefused) {
  const ScratchFolder scratch;
  const auto message = [](const std::vector<fs::path>& folders) {
    try {
      (void)read_paper_runs(folders);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string("nothing was thrown");
  };
  const auto folders = slope_runs(scratch.path(), {"slope-w1", "other", "again/slope-w1"});
  EXPECT_NE(message({folders[1]}).find("none of the paper's cases; give its folder the name of one: liakopoulos"),
            std::string::npos);
  EXPECT_NE(message({folders[0], folders[2]}).find("are both runs of slope-w1"), std::string::npos);
}

StackedPanel panel_of(const couple::ParticleTable& table) {
  StackedPanel panel;
  panel.particles = as_polydata(table);
  panel.domain = {{0.0, 0.0}, {36.0, 14.0}, 0.5, 4};
  panel.failure_strain = 0.02;
  panel.caption = "a synthetic slope";
  return panel;
}

class StackedPanels : public testing::Test {
 protected:
  PictureFile draw(const std::string& field, const std::vector<StackedPanel>& panels) {
    file_ = scratch_.path() / "picture.png";
    write_stacked_panels(file_, 800, field_called(field), panels);
    return PictureFile(file_);
  }
  std::string bytes(const std::string& field, const std::vector<StackedPanel>& panels) {
    (void)draw(field, panels);
    return bytes_of(file_);
  }

 private:
  ScratchFolder scratch_;
  fs::path file_;
};

TEST_F(StackedPanels, ShareOneColourScale) {
  const auto small = panel_of(synthetic_slope(640.0, 0.1, 1.8));
  const auto large = panel_of(synthetic_slope(640.0, 0.9, 1.8));
  const auto alone = draw("deviatoric_strain", {small});
  const auto same = draw("deviatoric_strain", {small, small});
  const auto beside = draw("deviatoric_strain", {small, large});
  const int offset = same.height() - alone.height();
  // On the circle along which the strain is largest: with the larger slide on the same scale, the
  // small one's strain of 0.1 is pale.
  const double em = 0.0225 * 800;
  const auto at = [em](const PictureFile& picture, double x, double y) {
    const double left = std::round(3.9 * em);
    const double metre = std::floor(800 - left - 1.4 * em) / 36.0;
    return picture.pixel(static_cast<int>(left + x * metre), static_cast<int>(std::round(5.9 * em) + y * metre));
  };
  const double metre = std::floor(800 - std::round(3.9 * em) - 1.4 * em) / 36.0;
  const double x = 18.0;
  const double y = 17.5 - std::sqrt(13.0 * 13.0 - (x - 9.5) * (x - 9.5));
  const double upper = y + offset / metre;
  EXPECT_EQ(at(same, x, upper), at(same, x, y)) << "the same slope twice";
  EXPECT_LT(at(same, x, upper)[1], 100) << "dark on its own scale";
  EXPECT_GT(at(beside, x, upper)[1], 180) << "pale beside the larger slide";
  EXPECT_LT(at(beside, x, y)[1], 100) << "which is dark";
}

TEST_F(StackedPanels, DimensionLinesCarryTheSummarysValues) {
  auto panel = panel_of(synthetic_slope(640.0, 0.9, 1.8));
  const auto without = bytes("deviatoric_strain", {panel});
  const auto with_size = [&](double length, double height) {
    panel.zone = zone_dimensions(panel.particles, 0.02, {length, height});
    return bytes("deviatoric_strain", {panel});
  };
  const auto drawn = with_size(12.31, 6.8);
  EXPECT_NE(drawn, without);
  EXPECT_EQ(with_size(12.34, 6.8), drawn) << "tenths of a metre are written";
  EXPECT_NE(with_size(12.4, 6.8), drawn) << "another length";
  EXPECT_NE(with_size(12.31, 6.9), drawn) << "another height";
}

TEST_F(StackedPanels, ShowWhereTheWaterTableIs) {
  auto table = synthetic_slope(0.0);
  const auto before = bytes("deviatoric_strain", {panel_of(table)});
  EXPECT_EQ(bytes("deviatoric_strain", {panel_of(table)}), before);
  for (double& pressure : table.pore_pressure) {
    pressure += 0.5 * 9810.0;
  }
  EXPECT_NE(bytes("deviatoric_strain", {panel_of(table)}), before) << "half a metre higher";
}

TEST(ZoneDimensions, AreThoseOfTheParticlesBeyondTheThreshold) {
  auto table = synthetic_slope(0.0);
  EXPECT_FALSE(zone_dimensions(as_polydata(table), 0.02, {}).has_value());
  couple::Point lower{1.0e9, 1.0e9};
  couple::Point upper{-1.0e9, -1.0e9};
  for (const std::size_t p : {100UL, 900UL, 2500UL}) {
    table.deviatoric_strain[p] = 0.03;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      lower[axis] = std::min(lower[axis], table.position[p][axis] - 0.125);
      upper[axis] = std::max(upper[axis], table.position[p][axis] + 0.125);
    }
  }
  const auto zone = zone_dimensions(as_polydata(table), 0.02, {1.0, 2.0});
  ASSERT_TRUE(zone.has_value());
  for (std::size_t axis = 0; axis < 2; ++axis) {
    EXPECT_NEAR(zone->lower[axis], lower[axis], 1.0e-12);
    EXPECT_NEAR(zone->upper[axis], upper[axis], 1.0e-12);
  }
}

TEST(StackedHistories, ShareTheirScales) {
  const HistoryChart quick{"quick", "u (m)", {0.0, 100.0}, {{"A1", {0.0, 0.3}}}, 80.0};
  const HistoryChart slow{"slow", "u (m)", {0.0, 400.0}, {{"A1", {-0.1, 0.2}}}, std::nullopt};
  const HistoryChart slowest{"slowest", "u (m)", {0.0, 9000.0}, {{"A1", {0.0, 0.1}}}, 8000.0};
  const Range values = common_values({quick, slow});
  EXPECT_DOUBLE_EQ(values.low, -0.1);
  EXPECT_DOUBLE_EQ(values.high, 0.3);
  for (const Range& times : time_ranges({quick, slow})) {
    EXPECT_DOUBLE_EQ(times.high, 400.0);
  }
  const auto own = time_ranges({quick, slow, slowest});
  EXPECT_DOUBLE_EQ(own[0].high, 100.0) << "on a common scale of 9000 s nothing would be seen of it";
  EXPECT_DOUBLE_EQ(own[2].high, 9000.0);

  const ScratchFolder folder;
  write_stacked_histories(folder.path() / "histories.png", 800, {quick, slow});
  auto later = quick;
  later.onset = 90.0;
  write_stacked_histories(folder.path() / "later.png", 800, {later, slow});
  EXPECT_EQ(PictureFile(folder.path() / "later.png").width(), 800);
  EXPECT_NE(bytes_of(folder.path() / "histories.png"), bytes_of(folder.path() / "later.png"));
}

TEST(RetentionChart, MarksTheRangeThatOccurs) {
  const seepage::VanGenuchten law{0.05, 3.0, {}};
  EXPECT_NEAR(saturation_at(law, 9.0 * 9810.0, 9810.0), 0.944, 5.0e-4) << "the crest of W2";
  const ScratchFolder folder;
  write_retention_chart(folder.path() / "low.png", 800, {{"W2", law, {0.0, 60.0e3}}}, 9810.0);
  write_retention_chart(folder.path() / "high.png", 800, {{"W2", law, {0.0, 61.0e3}}}, 9810.0);
  EXPECT_EQ(PictureFile(folder.path() / "low.png").width(), 800);
  EXPECT_NE(bytes_of(folder.path() / "low.png"), bytes_of(folder.path() / "high.png"));
}

TEST(MeshPicture, ShowsEveryPointWhereItIs) {
  const ScratchFolder folder;
  auto input = couple::read_case(fs::path(SLOPE_CASES) / "paper/slope-w2.yaml");
  input.points = {{"P", {30.0, 6.0}}};
  write_mesh_picture(folder.path() / "mesh.png", 800, input);
  const PictureFile picture(folder.path() / "mesh.png");
  const double em = 0.0225 * 800;
  const double left = std::round(3.9 * em);
  const double metre = std::floor(800 - left - 1.4 * em) / 36.0;
  const int x = static_cast<int>(left + 30.0 * metre);
  const int y = static_cast<int>(3.5 * em + 6.0 * metre);
  EXPECT_EQ(picture.pixel(x, y), (std::array{0xd5, 0x5e, 0x00}));
}

}  // namespace
}  // namespace slope::tools::test
