#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include "csv_table.hpp"
#include "picture_file.hpp"
#include "pictures.hpp"
#include "run_curves.hpp"
#include "scratch_folder.hpp"
#include "slope/couple/read_case.hpp"
#include "synthetic_run.hpp"

namespace slope::tools::test {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> names_of(const std::vector<fs::path>& files) {
  std::vector<std::string> names;
  for (const auto& file : files) {
    names.push_back(file.filename().string());
  }
  return names;
}

TEST(RunFolder, GivesTheStandardPictures) {
  const ScratchFolder scratch;
  write_slope_run(scratch.path() / "run");
  const auto run = read_run_folder(scratch.path() / "run");
  EXPECT_EQ(run.snapshots.size(), 4U);
  EXPECT_EQ(run.onset, 459.1);
  ASSERT_TRUE(run.summary.has_value());
  EXPECT_EQ(run.summary->found.end_reason, couple::EndReason::displacement);
  EXPECT_EQ(run.summary->case_file, "cases/some.yaml");
  EXPECT_EQ(run.summary->found.zone_at_end.length, 12.3);
  EXPECT_TRUE(run.notes.empty());

  const auto written = write_pictures(run, {run.path / "figures", 400, {}, {}}).written;
  EXPECT_EQ(names_of(written),
            (std::vector<std::string>{"suction_start.png", "suction_onset.png", "suction_end.png",
                                      "deviatoric_strain_start.png", "deviatoric_strain_onset.png",
                                      "deviatoric_strain_end.png", "displacement.png", "suction.png"}));
  for (const auto& file : written) {
    EXPECT_EQ(PictureFile(file).width(), 400) << file;
  }
}

TEST(RunFolder, DrawsTheFactorOfSafetyAndHowTheSlopeWouldFlow) {
  const ScratchFolder scratch;
  write_slope_run(scratch.path());
  RunFolder run = read_run_folder(scratch.path());
  run.summary->found.safety = {{0.0, 1.5, 1.4, 1.6, 5, 0.0, 0.0}, {300.0, 0.99, 0.98, 1.0, 4, 12.0, 1.5}};
  const PictureOptions options{scratch.path() / "figures", 400, {}, {}};
  auto names = names_of(write_pictures(run, options).written);
  for (const char* name : {"mechanism.png", "safety.png"}) {
    EXPECT_EQ(std::ranges::count(names, name), 1) << name;
    EXPECT_EQ(PictureFile(options.folder / name).width(), 400);
  }
  run.summary->found.safety.pop_back();
  names = names_of(write_pictures(run, options).written);
  EXPECT_EQ(std::ranges::count(names, "mechanism.png"), 0) << "nothing flows";
  EXPECT_EQ(std::ranges::count(names, "safety.png"), 0) << "one time makes no curve";
}

TEST(RunFolder, TellsTheOnsetThatTheCaseDidNotChoose) {
  RunFolder run;
  EXPECT_FALSE(other_onset(run));
  run.summary = summary_of_a_slide(590.0);
  run.summary->found.displacement_onset = 590.0;
  run.summary->found.runaway_onset = 650.0;
  ASSERT_TRUE(other_onset(run));
  EXPECT_EQ(other_onset(run)->time, 650.0);
  EXPECT_EQ(other_onset(run)->name, "runs away");
  run.input.onset = couple::Onset::runaway;
  EXPECT_EQ(other_onset(run)->time, 590.0);
  EXPECT_EQ(other_onset(run)->name, "2 cm");
}

TEST(RunFolder, DrawsFieldsAndTimesThatAreAskedFor) {
  const ScratchFolder scratch;
  write_slope_run(scratch.path());
  const auto run = read_run_folder(scratch.path());
  EXPECT_EQ(nearest_snapshot(run.snapshots, 290.0).time, 300.0);
  const auto pictures = write_pictures(run, {scratch.path() / "out", 400, {290.0, 300.0, 5000.0}, {"saturation"}});
  EXPECT_EQ(names_of(pictures.written).front(), "saturation_290s.png");
  EXPECT_EQ(pictures.notes,
            (std::vector<std::string>{"t = 290 s: there is no snapshot; the nearest one, of 300 s, was drawn",
                                      "t = 5000 s: there is no snapshot; the nearest one, of 640 s, was drawn"}));
  try {
    write_pictures(run, {scratch.path() / "out", 400, {}, {"sucktion"}});
    FAIL() << "no such field";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("suction, deviatoric_strain"), std::string::npos) << error.what();
  }
}

TEST(RunFolder, OfAKilledRunCanBeRead) {
  const ScratchFolder scratch;
  write_slope_run(scratch.path());
  fs::remove(scratch.path() / "summary.json");
  std::ofstream(scratch.path() / "history.csv", std::ios::app) << "641,1,0.9";
  const auto run = read_run_folder(scratch.path());
  EXPECT_EQ(run.onset, 459.1) << "from the snapshot";
  EXPECT_FALSE(run.summary);
  EXPECT_EQ(run.history.columns.front().size(), 4U) << "the broken row is left out";
}

TEST(RunFolder, SaysWhatOfAnotherVersionsSummaryItDoesNotUnderstand) {
  const ScratchFolder scratch;
  write_slope_run(scratch.path());
  couple::RunSummary summary = summary_of_a_slide(300.0);
  summary.version = "99.1";
  const std::string text = couple::summary_json(summary);
  std::ofstream(scratch.path() / "summary.json") << text;
  EXPECT_TRUE(read_run_folder(scratch.path()).notes.empty()) << "it has all the same keys";
  std::ofstream(scratch.path() / "summary.json") << "{\"colour\": 1, " << text.substr(1);
  const auto run = read_run_folder(scratch.path());
  EXPECT_EQ(run.onset, 300.0);
  ASSERT_EQ(run.notes.size(), 2u);
  EXPECT_NE(run.notes[0].find("summary.json:4: version: \"99.1\", and this program is"), std::string::npos)
      << run.notes[0];
  EXPECT_NE(run.notes[1].find("colour: unknown key"), std::string::npos) << run.notes[1];
}

TEST(RunFolder, SaysWhatIsMissing) {
  const ScratchFolder scratch;
  const auto message = [](const fs::path& folder) {
    try {
      (void)read_run_folder(folder);
    } catch (const couple::FileError& error) {
      return std::string(error.what());
    }
    return std::string("nothing was thrown");
  };
  EXPECT_NE(message(scratch.path() / "nowhere").find("nowhere: no such folder"), std::string::npos);
  EXPECT_NE(message(scratch.path()).find("particles.pvd: cannot be read: No such file"), std::string::npos);
  write_slope_run(scratch.path());
  fs::remove(scratch.path() / "history.csv");
  EXPECT_NE(message(scratch.path()).find("history.csv"), std::string::npos);
}

TEST(CsvTable, NumbersMustBeNumbersAndRowsComplete) {
  const ScratchFolder scratch;
  const auto file = scratch.path() / "table.csv";
  std::ofstream(file) << "# from a book\na [m],b\n1,2\n# a remark\n3,4e-2\n";
  const CsvTable table = read_csv(file);
  EXPECT_EQ(table.names, (std::vector<std::string>{"a [m]", "b"}));
  EXPECT_EQ(table.columns, (std::vector<std::vector<double>>{{1.0, 3.0}, {2.0, 0.04}}));

  std::ofstream(file) << "a,b\n1,2\n3,four\n";
  EXPECT_THROW((void)read_csv(file), couple::FileError);
  std::ofstream(file) << "a,b\n1\n3,4\n";
  EXPECT_THROW((void)read_csv(file), couple::FileError);
}

}  // namespace
}  // namespace slope::tools::test
