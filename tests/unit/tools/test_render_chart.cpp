#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "history_chart.hpp"
#include "picture_file.hpp"
#include "plot_frame.hpp"
#include "profile_chart.hpp"
#include "run_curves.hpp"
#include "scratch_folder.hpp"
#include "slope/couple/read_case.hpp"
#include "synthetic_slope.hpp"
#include "time_unit.hpp"

namespace slope::tools::test {
namespace {

TEST(PlotFrame, StepsAreRoundAndNumbersHaveTheirDecimals) {
  EXPECT_DOUBLE_EQ(round_step({0.0, 36.0}, 7.0), 10.0);
  EXPECT_DOUBLE_EQ(round_step({-29.0, 87.0}, 6.0), 20.0);
  EXPECT_DOUBLE_EQ(round_step({0.0, 0.35}, 4.0), 0.1);
  EXPECT_EQ(multiples({-30.0, 90.0}, 20.0), (std::vector<double>{-20.0, 0.0, 20.0, 40.0, 60.0, 80.0}));
  const Range wide = widened({-29.0, 87.0}, 10.0);
  EXPECT_DOUBLE_EQ(wide.low, -30.0);
  EXPECT_DOUBLE_EQ(wide.high, 90.0);
  EXPECT_EQ(number_text(-20.0, 20.0), "\u221220");
  EXPECT_EQ(number_text(0.30000000000000004, 0.1), "0.3");
  EXPECT_EQ(number_text(-1.0e-17, 0.1), "0.0") << "no minus before zero";
  EXPECT_EQ(number_text(0.125, 0.125), "0.125");
  EXPECT_EQ(time_text(459.13), "459.1 s");
  EXPECT_EQ(time_text(600.0), "600 s");
  EXPECT_EQ(time_text(10799.0), "10799 s");
  EXPECT_EQ(time_text(82080.0), "22.8 h");
  EXPECT_EQ(time_text(20777.0), "5.771 h");
  EXPECT_EQ(time_text(4536.0, time_unit(11797.0)), "1.26 h");
  EXPECT_EQ(time_text(5.0 * 86400.0), "5 d");
}

TEST(HistoryChart, DrawsCurvesAndOnset) {
  const ScratchFolder folder;
  HistoryChart chart{"A slope", "Suction s (kPa)", {0.0, 100.0, 200.0}, {{"A1", {30.0, 20.0, 5.0}}}, std::nullopt};
  write_history_chart(folder.path() / "stood.png", 800, chart);
  chart.onset = 150.0;
  write_history_chart(folder.path() / "failed.png", 800, chart);
  const PictureFile picture(folder.path() / "stood.png");
  EXPECT_EQ(picture.width(), 800);
  EXPECT_EQ(picture.height(), 450);
  int blue = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      blue += picture.pixel(x, y) == std::array{0x00, 0x72, 0xb2} ? 1 : 0;
    }
  }
  EXPECT_GT(blue, 500) << "pixels of the curve";
  EXPECT_NE(bytes_of(folder.path() / "stood.png"), bytes_of(folder.path() / "failed.png"));
  chart.other_onset = TimeMark{170.0, "runs away"};
  write_history_chart(folder.path() / "both.png", 800, chart);
  EXPECT_NE(bytes_of(folder.path() / "both.png"), bytes_of(folder.path() / "failed.png"));
}

TEST(BudgetCurves, AreThoseThatOccur) {
  CsvTable budget;
  budget.names = {"time [s]",       "rain [m3/m]",        "infiltration [m3/m]", "run-off [m3/m]",
                  "seepage [m3/m]", "evaporation [m3/m]", "outflow [m3/m]",      "storage [m3/m]"};
  budget.columns = {{0, 60}, {0, 3}, {0, 2}, {0, 1}, {0, 0.5}, {0, 0}, {0, 0.5}, {0, 1.5}};
  std::vector<std::string> names;
  for (const Curve& curve : budget_curves(budget)) names.push_back(curve.name);
  EXPECT_EQ(names, (std::vector<std::string>{"rain", "infiltration", "run-off", "seepage", "storage"}))
      << "the outflow is the seepage";
  EXPECT_EQ(budget_curves(budget)[1].values, (std::vector<double>{0.0, 2.0}));
  EXPECT_TRUE(budget_curves({}).empty());
}

TEST(ProfileChart, ProfileIsTheMeanOfEachLayer) {
  auto table = synthetic_column(300.0, 0.8);
  table.suction[0] += 4.0 * 9810.0;  // one of the lowest layer's four
  const Profile profile = suction_profile(as_polydata(table), 9810.0);
  ASSERT_EQ(profile.head.size(), 50U);
  EXPECT_NEAR(profile.height.front(), 0.01, 1.0e-12);
  EXPECT_NEAR(profile.head.front(), 0.8 * std::pow(0.01, 1.5) + 1.0, 1.0e-9);
  EXPECT_NEAR(profile.height.back(), 0.99, 1.0e-12);
  EXPECT_NEAR(profile.head.back(), 0.8 * std::pow(0.99, 1.5), 1.0e-9);
}

TEST(ProfileChart, ReferenceIsReadByItsTime) {
  const ScratchFolder folder;
  const auto file = folder.path() / "reference.csv";
  std::ofstream(file) << "# a source\n# z_m,suction_head_m_t300,suction_Pa_t300,suction_head_m_t1200\n"
                         "0,-0,-0,0.1\n0.5,0.25,2452.5,0.35\n";
  const Profile early = reference_profile(file, 300.0);
  EXPECT_EQ(early.height, (std::vector<double>{0.0, 0.5}));
  EXPECT_EQ(early.head, (std::vector<double>{0.0, 0.25}));
  EXPECT_EQ(reference_profile(file, 1200.0).head, (std::vector<double>{0.1, 0.35}));
  EXPECT_TRUE(reference_profile(file, 600.0).head.empty());

  std::ofstream(file) << "height,head\n0,1\n";
  EXPECT_THROW((void)reference_profile(file, 300.0), couple::FileError);
  EXPECT_THROW((void)reference_profile(folder.path() / "missing.csv", 300.0), couple::FileError);
}

TEST(ProfileChart, IsWritten) {
  const ScratchFolder folder;
  const Profile computed = suction_profile(as_polydata(synthetic_column(300.0, 0.8)), 9810.0);
  write_profile_chart(folder.path() / "profile.png", 800, "A column",
                      {{300.0, 300.0, computed, {{0.0, 0.4}, {0.0, 1.0}}}, {600.0, 612.0, computed, {}}});
  EXPECT_EQ(PictureFile(folder.path() / "profile.png").width(), 800);
}

}  // namespace
}  // namespace slope::tools::test
