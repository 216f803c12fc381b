#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numeric>

#include "bar_chart.hpp"
#include "distribution_chart.hpp"
#include "picture_file.hpp"
#include "scratch_folder.hpp"
#include "slope/couple/read_case.hpp"
#include "study_pictures.hpp"
#include "study_results.hpp"

namespace slope::tools::test {
namespace {

namespace fs = std::filesystem;

constexpr std::array blue{0x00, 0x72, 0xb2};  // the first of the curves' colours

int count_of(const PictureFile& picture, const std::array<int, 3>& colour) {
  int count = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) count += picture.pixel(x, y) == colour ? 1 : 0;
  }
  return count;
}

TEST(DistributionChart, EveryValueIsInABinOfARoundWidth) {
  const std::vector<double> values{1.01, 1.09, 1.1, 1.25, 1.31, 1.4, 1.4, 1.55, 1.6};
  const Histogram histogram = histogram_of(values);
  EXPECT_DOUBLE_EQ(histogram.step, 0.2);
  EXPECT_EQ(std::accumulate(histogram.counts.begin(), histogram.counts.end(), 0), 9);
  EXPECT_LE(histogram.first, 1.01);
  EXPECT_EQ(histogram.counts.front(), 3);
}

TEST(DistributionChart, ValuesThatAreAllTheSameHaveOneBin) {
  for (const double value : {0.0, 7.5, -3.0}) {
    EXPECT_EQ(histogram_of({value, value}).counts, std::vector<int>{2}) << value;
  }
}

TEST(DistributionChart, DrawsItsBinsAndTheLimit) {
  const ScratchFolder folder;
  DistributionChart chart;
  chart.title = "Slopes", chart.x_title = "factor (-)";
  chart.values = {1.1, 1.2, 1.3, 1.4, 1.5};
  chart.marks = {{0.5, 1.3, 1.1, std::nan("")}};
  write_distribution_chart(folder.path() / "plain.png", 800, chart);
  EXPECT_GT(count_of(PictureFile(folder.path() / "plain.png"), blue), 20000) << "pixels of the bins";
  chart.limit = 1.25, chart.limit_name = "factor < 1.25";
  write_distribution_chart(folder.path() / "limit.png", 800, chart);
  EXPECT_NE(bytes_of(folder.path() / "plain.png"), bytes_of(folder.path() / "limit.png"));
}

TEST(BarChart, BarsAreAsLongAsTheirValues) {
  const ScratchFolder folder;
  const auto pixels = [&](double value) {
    Bar bar{};
    bar.value = value;
    write_bar_chart(folder.path() / "bars.png", 800,
                    {"Slopes", "rank correlation", {-1.0, 1.0}, {"all"}, {{"c", {bar}}}});
    return count_of(PictureFile(folder.path() / "bars.png"), blue);
  };
  const int legend = pixels(std::nan("")), half = pixels(0.5) - legend;
  EXPECT_GT(half, 1000);
  EXPECT_NEAR(pixels(1.0) - legend, 2 * half, 0.05 * half);
  EXPECT_NEAR(pixels(-0.5) - legend, half, 0.05 * half);
}

class StudyPictures : public testing::Test {
 protected:
  StudyPictures() {
    StudyResults study;
    study.title = "Slopes";
    study.parameters.push_back({"c", "soils.clay.c", "kPa", "normal", 5.0, 1.0, 5.0, 1.0});
    FoundResult factor{"factor", "factor_of_safety.factor", "-", 3, {1.2, 1.0, 1.4}, 0.1, 1.1, 1.3, {}, {}};
    factor.quantiles.push_back({0.5, {1.2, 1.1, 1.3}});
    factor.influences.push_back({"c", 1.0, 1.0, Estimate{0.9, 0.8, 1.0}, Estimate{0.95, 0.9, 1.0}});
    study.results.push_back(factor);
    study.failure = FoundFailure{"factor < 1", "factor", 1.0, 3, 0, {0.0, 0.0, 0.7}, "Clopper-Pearson"};
    write("study.json", study_json(study));
    std::vector<StudyRow> rows;
    for (const double value : {1.1, 1.2, 1.3})
      rows.push_back({{5.0}, {value}, "stands", false, "finished", "runs/0001"});
    write("study.csv", study_csv(study, rows));
  }
  void write(const std::string& name, const std::string& content) const {
    std::ofstream(folder_.path() / name) << content;
  }
  [[nodiscard]] std::vector<std::string> drawn() {
    std::vector<std::string> names;
    for (const fs::path& file : write_study_pictures(folder_.path(), folder_.path() / "figures", 600, losses_)) {
      EXPECT_GT(PictureFile(file).height(), 100);
      names.push_back(file.filename().string());
    }
    return names;
  }

  const ScratchFolder folder_;
  Losses losses_;
};

TEST_F(StudyPictures, AreThoseOfEachResult) {
  EXPECT_TRUE(holds_study(folder_.path()));
  EXPECT_EQ(drawn(), (std::vector<std::string>{"factor_distribution.png", "factor_tornado.png", "factor_indices.png"}));
  EXPECT_TRUE(losses_.messages().empty());
}

TEST_F(StudyPictures, OfADamagedStudyAreLeftOutAndNamed) {
  write("study.csv", "sample,c [kPa],factor [-]\n1,5,1.2\n2,5,high\n");
  EXPECT_TRUE(drawn().empty());
  ASSERT_EQ(losses_.messages().size(), 1u);
  EXPECT_NE(losses_.messages()[0].find("study.csv:3: \"high\" is not a number"), std::string::npos)
      << losses_.messages()[0];
  write("study.csv", "sample,c [kPa],factor [-]\n1,5,1.2\n2,5,1e99\n");
  EXPECT_EQ(drawn().size(), 3u);
  EXPECT_EQ(losses_.messages().size(), 2u);
  write("study.json", "{\"program\": \"slope-sim\"}");
  EXPECT_THROW(static_cast<void>(drawn()), couple::FileError);
}

}  // namespace
}  // namespace slope::tools::test
