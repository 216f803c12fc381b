#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "colour_maps.hpp"
#include "contour_picture.hpp"
#include "history_chart.hpp"
#include "picture_difference.hpp"
#include "regression_case.hpp"
#include "run_curves.hpp"
#include "run_folder.hpp"
#include "table_difference.hpp"
#include "time_unit.hpp"

// The comparison itself: each of these changes, made on purpose to what the short slope gave, must be seen.
namespace slope::testing {
namespace {

namespace fs = std::filesystem;

constexpr int picture_width = SLOPE_REGRESSION_WIDTH;

/// A folder of the build tree for what the running test changes.
fs::path changed_folder() {
  const auto folder = short_slope.built() / "changed" / ::testing::UnitTest::GetInstance()->current_test_info()->name();
  fs::create_directories(folder);
  return folder;
}

/// Draws the pictures of the short slope with something changed.
class ChangedPictures : public ::testing::Test {
 protected:
  static fs::path changed(const std::string& name) { return changed_folder() / (name + ".png"); }

  /// The panel of a contour picture as slope-render draws it.
  tools::ContourPanel panel(const std::string& field, double time) {
    std::vector<vtkSmartPointer<vtkPolyData>> moments;
    for (const double t : run_.input.figures.contour_times) {
      moments.push_back(tools::read_particles(tools::nearest_snapshot(run_.snapshots, t).file));
      if (t == time) particles_ = moments.back();
    }
    const tools::Field& drawn = tools::field_called(field);
    return {particles_,
            drawn,
            tools::common_scale(drawn, moments),
            run_.input.domain,
            run_.input.failure_zone_strain,
            run_.input.title,
            "t = " + tools::time_text(time)};
  }

  tools::HistoryChart displacement_chart() {
    auto curves = tools::history_curves(run_.history, "displacement");
    const auto [factor, unit] = tools::length_unit(curves);
    tools::scale_curves(curves, factor);
    return {run_.input.title, "Displacement |u| (" + unit + ")", run_.history.columns.front(), curves,
            run_.onset,       tools::other_onset(run_)};
  }

  static double difference(const fs::path& picture, const std::string& reference) {
    const double found = picture_difference(picture, short_slope.references() / reference).largest;
    fmt::print("{}: {:.3g}\n", picture.filename().string(), found);
    return found;
  }
  [[nodiscard]] double allowed() const { return tolerances_.picture_threshold; }

  tools::RunFolder run_ = tools::read_run_folder(short_slope.run());
  Tolerances tolerances_ = short_slope.tolerances();

 private:
  vtkSmartPointer<vtkPolyData> particles_;
};

TEST_F(ChangedPictures, WithoutAChangeIsAccepted) {
  write_contour_picture(changed("suction_as_it_is"), picture_width, panel("suction", 0.0));
  EXPECT_LE(difference(changed("suction_as_it_is"), "suction_0s.png"), allowed());
  write_history_chart(changed("displacement_as_it_is"), picture_width, displacement_chart());
  EXPECT_LE(difference(changed("displacement_as_it_is"), "displacement.png"), allowed());
}

// The case run with a water table of 3.1 m instead of 3 m, drawn with the colour scale of the reference.
TEST_F(ChangedPictures, WaterLevelTenCentimetresHigherIsRejected) {
  const auto raised = tools::read_run_folder(short_slope.built() / "raised");
  const auto particles = tools::read_particles(raised.snapshots.front().file);
  auto drawn = panel("suction", 0.0);
  drawn.particles = particles;
  write_contour_picture(changed("suction_raised"), picture_width, drawn);
  EXPECT_GT(difference(changed("suction_raised"), "suction_0s.png"), allowed());
}

TEST_F(ChangedPictures, AnotherColourMapIsRejected) {
  auto suction = panel("suction", 420.0);
  suction.field.colours = tools::magma_reversed();
  write_contour_picture(changed("suction_in_magma"), picture_width, suction);
  EXPECT_GT(difference(changed("suction_in_magma"), "suction_420s.png"), allowed());

  auto strain = panel("deviatoric_strain", 540.0);
  strain.field.colours = tools::viridis();
  write_contour_picture(changed("strain_in_viridis"), picture_width, strain);
  EXPECT_GT(difference(changed("strain_in_viridis"), "deviatoric_strain_540s.png"), allowed());
}

TEST_F(ChangedPictures, ColoursTurnedAroundAreRejected) {
  const auto map = tools::viridis();
  const std::vector<tools::Colour> turned(map.rbegin(), map.rend());
  auto drawn = panel("suction", 420.0);
  drawn.field.colours = turned;
  write_contour_picture(changed("suction_turned"), picture_width, drawn);
  EXPECT_GT(difference(changed("suction_turned"), "suction_420s.png"), allowed());
}

TEST_F(ChangedPictures, ScaleATenthLongerIsRejected) {
  auto drawn = panel("suction", 0.0);
  drawn.scale.range.high += 0.1 * drawn.scale.range.length();
  write_contour_picture(changed("suction_longer_scale"), picture_width, drawn);
  EXPECT_GT(difference(changed("suction_longer_scale"), "suction_0s.png"), allowed());
}

// Another machine may draw another digit and a line a fraction of a pixel farther on.
TEST_F(ChangedPictures, OnsetATenthOfASecondLaterIsAccepted) {
  auto chart = displacement_chart();
  chart.onset = chart.onset.value() + 0.1;
  write_history_chart(changed("displacement_other_digit"), picture_width, chart);
  EXPECT_LE(difference(changed("displacement_other_digit"), "displacement.png"), allowed());
}

TEST_F(ChangedPictures, OnsetThreePercentLaterIsRejected) {
  auto chart = displacement_chart();
  chart.onset = 1.03 * chart.onset.value();
  write_history_chart(changed("displacement_late_onset"), picture_width, chart);
  EXPECT_GT(difference(changed("displacement_late_onset"), "displacement.png"), allowed());
}

/// A part of a picture, as shares of its width and height from its upper left corner.
struct Part {
  double left, right, top, bottom;
};

/// The reference with a part painted white.
fs::path without(const Part& part, const fs::path& reference, const fs::path& file) {
  const auto picture = read_picture(short_slope.references() / reference);
  const int* size = picture->GetDimensions();
  const auto pixel = [](double share, int length) { return static_cast<int>(share * length); };
  for (int j = size[1] - pixel(part.bottom, size[1]); j < size[1] - pixel(part.top, size[1]); ++j) {
    for (int i = pixel(part.left, size[0]); i < pixel(part.right, size[0]); ++i) {
      for (int c = 0; c < 3; ++c) picture->SetScalarComponentFromDouble(i, j, 0, c, 255.0);
    }
  }
  write_picture(file, picture);
  return file;
}

TEST_F(ChangedPictures, MissingLegendIsRejected) {
  const Part water_level{0.65, 1.0, 0.07, 0.13};
  EXPECT_GT(difference(without(water_level, "suction_0s.png", changed("suction_no_legend")), "suction_0s.png"),
            allowed());
  const Part zone{0.48, 0.67, 0.07, 0.13};
  EXPECT_GT(difference(without(zone, "deviatoric_strain_540s.png", changed("strain_no_legend")),
                       "deviatoric_strain_540s.png"),
            allowed());
  const Part points{0.82, 1.0, 0.1, 0.7};
  EXPECT_GT(difference(without(points, "displacement.png", changed("displacement_no_legend")), "displacement.png"),
            allowed());
}

TEST_F(ChangedPictures, MissingColourBarIsRejected) {
  const Part bar{0.0, 1.0, 0.88, 1.0};
  EXPECT_GT(difference(without(bar, "suction_0s.png", changed("suction_no_bar")), "suction_0s.png"), allowed());
}

/// A reference table of the short slope with a column multiplied by a factor.
Table stretched(const std::string& file, const std::string& column, double factor) {
  const Table reference(short_slope.references() / file);
  const fs::path written = changed_folder() / file;
  std::ofstream out(written);
  for (const auto& name : reference.names()) out << (&name == &reference.names().front() ? "" : ",") << name;
  for (std::size_t row = 0; row < reference.rows(); ++row) {
    out << '\n';
    for (const auto& name : reference.names()) {
      const double value = (name == column ? factor : 1.0) * reference.column(name)[row];
      out << (&name == &reference.names().front() ? "" : ",") << fmt::format("{:.9g}", value);
    }
  }
  out.close();
  return Table(written);
}

std::string complaints_about(const Table& actual, const std::string& file) {
  const auto found =
      deviations(actual, Table(short_slope.references() / file), short_slope.tolerances().tables.at(file));
  for (const auto& d : found) fmt::print("{}: {:.3g} of what is allowed\n", d.column, d.share);
  return complaints(found);
}

TEST(ChangedTables, WithoutAChangeAreAccepted) {
  EXPECT_EQ(complaints_about(stretched("summary.csv", "", 1.0), "summary.csv"), "");
  EXPECT_EQ(complaints_about(stretched("history.csv", "", 1.0), "history.csv"), "");
}

TEST(ChangedTables, OnsetThreePercentLaterIsRejected) {
  EXPECT_NE(complaints_about(stretched("summary.csv", "onset.time_s", 1.03), "summary.csv").find("onset.time_s"),
            std::string::npos);
}

TEST(ChangedTables, HistoryThreePercentSlowerIsRejected) {
  const std::string found = complaints_about(stretched("history.csv", "time [s]", 1.03), "history.csv");
  EXPECT_NE(found.find("time [s]"), std::string::npos);
  EXPECT_NE(found.find("largest displacement [m]"), std::string::npos);
}

TEST(ChangedTables, WaterLevelTenCentimetresHigherIsRejected) {
  const Table reference(short_slope.references() / "history.csv");
  const auto raised = tools::read_csv(short_slope.built() / "raised" / "history.csv");
  const auto tolerances = short_slope.tolerances().tables.at("history.csv");
  for (const auto& asked : tolerances.columns) {
    if (asked.column.find("suction") == std::string::npos) continue;
    const auto column = std::ranges::find(raised.names, asked.column) - raised.names.begin();
    const double before = reference.column(asked.column).front();
    const double after = raised.columns[static_cast<std::size_t>(column)].front();
    EXPECT_GT(std::abs(after - before), asked.tolerance.at(before)) << asked.column;
  }
}

}  // namespace
}  // namespace slope::testing
