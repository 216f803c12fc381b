#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <limits>

#include "progress_line.hpp"
#include "report.hpp"
#include "summary_json.hpp"

namespace slope::tools {
namespace {

couple::Case a_case() {
  couple::Case input;
  input.title = "A \"strange\" title:\n\\ {";
  input.path = "cases/x.yaml";
  input.failure_zone_strain = 0.02;
  input.stop.displacement = 0.3;
  return input;
}

couple::Summary a_failure() {
  couple::Summary summary;
  summary.time = 890.5;
  summary.onset_criterion = 0.02;
  summary.onset_time = 618.25;
  summary.onset_position = {11.5, 5.75};
  summary.displacement_times = {{0.02, 618.25}, {1.0, {}}};
  summary.zone_at_onset = couple::FailureZone{1, 2, 3, 4, 5, 6, 8000};
  summary.zone_at_end = couple::FailureZone{15, 7.75, 2.25, 27, 5, 12.75, 38000};
  summary.water = {1.5, 0.25, 1.25, 1e-9, {{"rain", 1.5}, {"outlet", -0.25}}, 2.5, 1.5, 1.0, 0.125, 0.0625};
  summary.verdict = couple::Verdict::fails;
  summary.displacement_onset = 618.25;
  summary.runaway_onset = 590.5;
  summary.slide_at_end = {31.5, -1.0, 0.28, couple::Point{10, 5}, 0.25, false};
  summary.largest_displacement = 0.3;
  summary.pressure_checkerboard = std::numeric_limits<double>::quiet_NaN();
  summary.particles = 5089;
  summary.steps = 46312;
  return summary;
}

TEST(SummaryJson, IsReadBackWithTheValuesAndUnitsInItsKeys) {
  const YAML::Node json =
      YAML::Load(summary_json(a_case(), a_failure(), {"1.2.3", "displacement", "", 61.5, 2}));  // JSON is YAML
  EXPECT_EQ(json["title"].as<std::string>(), a_case().title);
  EXPECT_EQ(json["version"].as<std::string>(), "1.2.3");
  EXPECT_EQ(json["end"]["reason"].as<std::string>(), "displacement");
  EXPECT_FALSE(json["end"]["message"].IsDefined());
  EXPECT_EQ(json["onset"]["time_s"].as<double>(), 618.25);
  EXPECT_EQ(json["onset"]["displacement_m"].as<double>(), 0.02);
  EXPECT_EQ(json["onset"]["position_m"].as<std::vector<double>>(), (std::vector<double>{11.5, 5.75}));
  EXPECT_EQ(json["displacement_times"][0]["time_s"].as<double>(), 618.25);
  EXPECT_TRUE(json["displacement_times"][1]["time_s"].IsNull());
  EXPECT_EQ(json["failure_zone"]["at_onset"]["largest_suction_Pa"].as<double>(), 8000.0);
  EXPECT_TRUE(json["failure_zone"]["at_10_cm"].IsNull());
  EXPECT_EQ(json["failure_zone"]["at_end"]["length_m"].as<double>(), 15.0);
  EXPECT_EQ(json["water_budget"]["error"].as<double>(), 1e-9);
  EXPECT_EQ(json["water_budget"]["net_inflow_by_boundary_m3_per_m"]["outlet"].as<double>(), -0.25);
  EXPECT_EQ(json["water_budget"]["rain_m3_per_m"].as<double>(), 2.5);
  EXPECT_EQ(json["water_budget"]["rain_infiltration_m3_per_m"].as<double>(), 1.5);
  EXPECT_EQ(json["water_budget"]["run_off_m3_per_m"].as<double>(), 1.0);
  EXPECT_EQ(json["water_budget"]["seepage_m3_per_m"].as<double>(), 0.125);
  EXPECT_EQ(json["water_budget"]["evaporation_m3_per_m"].as<double>(), 0.0625);
  EXPECT_TRUE(json["pressure_checkerboard"].IsNull()) << "JSON has no NaN";
  EXPECT_EQ(json["particles"].as<int>(), 5089);
  EXPECT_EQ(json["steps"].as<int>(), 46312);
  EXPECT_EQ(json["threads"].as<int>(), 2);
  EXPECT_EQ(json["wall_time_s"].as<double>(), 61.5);
}

TEST(SummaryJson, HasTheVerdictFirstAndTheSlideBesideTheZone) {
  couple::Summary summary = a_failure();
  const RunRecord record{"1", "displacement", "", 1.0, 1};
  YAML::Node json = YAML::Load(summary_json(a_case(), summary, record));
  EXPECT_EQ(json.begin()->first.as<std::string>(), "verdict");
  EXPECT_EQ(json["verdict"].as<std::string>(), "fails");
  EXPECT_EQ(json["onset_by_displacement_s"].as<double>(), 618.25);
  EXPECT_EQ(json["onset_by_runaway_s"].as<double>(), 590.5);
  EXPECT_TRUE(json["slide"]["at_10_cm"].IsNull());
  const YAML::Node slide = json["slide"]["at_end"];
  EXPECT_EQ(slide["area_m2"].as<double>(), 31.5);
  EXPECT_EQ(slide["direction"].as<double>(), -1.0);
  EXPECT_EQ(slide["run_out_m"].as<double>(), 0.25);
  EXPECT_EQ(slide["first_toe_m"].as<std::vector<double>>(), (std::vector<double>{10.0, 5.0}));
  EXPECT_EQ(slide["largest_horizontal_displacement_m"].as<double>(), 0.28);
  EXPECT_FALSE(slide["reaches_wall"].as<bool>());

  summary.slide_at_end.run_out.reset();
  summary.slide_at_end.toe.reset();
  json = YAML::Load(summary_json(a_case(), summary, record));
  EXPECT_TRUE(json["slide"]["at_end"]["run_out_m"].IsNull());
  EXPECT_TRUE(json["slide"]["at_end"]["first_toe_m"].IsNull());
  for (const auto& [verdict, text] :
       {std::pair{couple::Verdict::stands, "stands"}, std::pair{couple::Verdict::moves, "moves without failing"},
        std::pair{couple::Verdict::does_not_stand, "does not stand before the start"},
        std::pair{couple::Verdict::water_alone, "water alone"}, std::pair{couple::Verdict::undecided, "undecided"}}) {
    summary.verdict = verdict;
    EXPECT_EQ(YAML::Load(summary_json(a_case(), summary, record))["verdict"].as<std::string>(), text);
  }
}

TEST(SummaryJson, SaysByWhichCriterionTheOnsetIs) {
  couple::Case input = a_case();
  input.onset = couple::Onset::runaway;
  const YAML::Node json = YAML::Load(summary_json(input, a_failure(), {"1", "time", "", 1.0, 1}));
  EXPECT_NE(json["onset"]["criterion"].as<std::string>().find("five times the mean rate before"), std::string::npos);
  EXPECT_EQ(onset_text(input, a_failure()), "618.25 s (the motion runs away), at x = 11.5 m, y = 5.8 m");
}

TEST(SummaryJson, OfASlopeThatStandsHasNoOnset) {
  couple::Summary summary = a_failure();
  summary.onset_time.reset();
  const YAML::Node json = YAML::Load(summary_json(a_case(), summary, {"1", "error", "stress is nan", 1, 1}));
  EXPECT_TRUE(json["onset"].IsNull());
  EXPECT_EQ(json["onset_criterion_m"].as<double>(), 0.02);
  EXPECT_EQ(json["end"]["message"].as<std::string>(), "stress is nan");
}

TEST(Report, NamesTheCriterionBesideTheOnset) {
  EXPECT_EQ(onset_text(a_case(), a_failure()), "618.25 s (largest displacement above 2 cm), at x = 11.5 m, y = 5.8 m");
  couple::Summary standing = a_failure();
  standing.onset_time.reset();
  EXPECT_EQ(onset_text(a_case(), standing), "none (the largest displacement stayed below 2 cm)");
}

TEST(Report, BeginsWithTheVerdict) {
  couple::Case input = a_case();
  couple::Summary summary = a_failure();
  EXPECT_EQ(verdict_text(input, summary), "fails, after 618.25 s");
  input.water_boundaries.emplace_back();
  EXPECT_EQ(verdict_text(input, summary), "fails in the rain, after 618.25 s");
  summary.verdict = couple::Verdict::does_not_stand;
  summary.initial_unbalanced_ratio = 0.0123;
  EXPECT_EQ(verdict_text(input, summary),
            "does not stand before the rain: no balance was found, 1.2 % of the weight stays unbalanced");
  summary.verdict = couple::Verdict::stands;
  EXPECT_EQ(verdict_text(input, summary), "stands until the end, 890.5 s");
  summary.verdict = couple::Verdict::moves;
  summary.largest_displacement = 0.036;
  EXPECT_EQ(
      verdict_text(input, summary),
      "moves without failing, by 3.6 cm until 890.5 s: the motion has not run away, and nothing has sheared by 2 %");
  summary.verdict = couple::Verdict::undecided;
  EXPECT_EQ(verdict_text(input, summary), "undecided: it stands until 890.5 s, where the run was ended");
}

TEST(Report, SaysWhereTheRunOutCannotBeCounted) {
  couple::Summary summary = a_failure();
  const auto report = [&] { return report_text(a_case(), summary, {"1", "displacement", "", 61.5, 2}); };
  summary.slide_at_end.reaches_wall = true;
  EXPECT_NE(report().find("to the left; it has come to the side of the domain"), std::string::npos) << report();
  summary.slide_at_end.run_out.reset();
  EXPECT_NE(report().find("no toe to count it from: the ground falls to the left side"), std::string::npos) << report();
  summary.slide_at_end = {};
  EXPECT_NE(report().find("run-out          0 m\n"), std::string::npos) << report();
}

TEST(Report, SaysWhetherTheSlideCameToRest) {
  couple::Case input = a_case();
  input.stop.at_rest = true;
  const auto report = [&](const char* reason) { return report_text(input, a_failure(), {"1", reason, "", 1.0, 1}); };
  EXPECT_NE(report("at_rest").find("890.5 s (the slide has come to rest)"), std::string::npos);
  EXPECT_NE(report("time").find("(the time asked for; the slide had not come to rest)"), std::string::npos);
}

TEST(Report, SaysZoneSuctionAndWaterWithUnits) {
  const std::string report = report_text(a_case(), a_failure(), {"1", "displacement", "", 61.5, 2});
  for (const char* part :
       {"890.5 s (displacement above 0.3 m)",
        "15.0 m long, 7.8 m high, 2.2 m deep, 27.0 m2 (deviatoric strain above 2 %)",
        "verdict          fails, after 618.25 s", "the motion runs away from 590.5 s on",
        "0.3 m at the end, where it is largest; horizontally 0.28 m",
        "0.25 m beyond the first toe, x = 10.0000 m, y = 5.0000 m, to the left", "31.5 m2 (displacement above 2 cm)",
        "38.0 kPa at most", "1.5 m3/m in, 0.25 m3/m out, 1.25 m3/m stored, error 1.0e-09",
        "2.5 m3/m: 1.5 m3/m infiltrated, 1 m3/m ran off", "0.125 m3/m seeped out, 0.0625 m3/m evaporated",
        "5089 particles, 46312 steps, 61.5 s on 2 threads"}) {
    EXPECT_NE(report.find(part), std::string::npos) << part << "\n" << report;
  }
}

TEST(Report, TellsOfWhatIsOutOfTheOrdinary) {
  couple::Summary summary = a_failure();
  EXPECT_EQ(report_text(a_case(), summary, {"1", "time", "", 1.0, 1}).find("unsettled"), std::string::npos);
  summary.unsettled_steps = 3;
  summary.time = 82080.0;
  const std::string report = report_text(a_case(), summary, {"1", "time", "", 1.0, 1});
  EXPECT_NE(report.find("3 steps whose pore pressures"), std::string::npos) << report;
  EXPECT_NE(report.find("82080 s (22.8 h) (the time asked for)"), std::string::npos) << report;
  const YAML::Node json = YAML::Load(summary_json(a_case(), summary, {"1", "time", "", 1, 1}));
  EXPECT_EQ(json["unsettled_pressure_steps"].as<int>(), 3);
}

TEST(Progress, ShowsTimeShareTimeLeftClockAndDisplacement) {
  EXPECT_EQ(progress_text({412.3, 0.25, 12.4, 0.00123, 1000, {}}, 2400.0, 50.0),
            "412.3 s of 2400 s   25 %  2:30 left  clock x12.4  displacement 1.2 mm");
  EXPECT_EQ(progress_text({2400.0, 1.0, 1.0, 0.25, 1000, {}}, 2400.0, 50.0),
            "2400 s of 2400 s  100 %  clock x1  displacement 0.25 m");
  EXPECT_EQ(progress_text({9000.0, 0.5, 1.0, 0.0, 10, {}}, 18000.0, 7265.0),
            "2.5 h of 5 h   50 %  2:01:05 left  clock x1  displacement 0 mm");
}

TEST(Progress, ShowsTheWatersBooks) {
  couple::Progress progress{2400.0, 1.0, 1.0, 0.0, 1000, {}};
  progress.water.infiltration = progress.water.storage = 0.125;
  EXPECT_EQ(progress_text(progress, 2400.0, 50.0),
            "2400 s of 2400 s  100 %  clock x1  displacement 0 mm  water (m3/m): in 0.125, stored 0.125, error 0e+00");
  progress.water = a_failure().water;
  EXPECT_EQ(
      progress_text(progress, 2400.0, 50.0),
      "2400 s of 2400 s  100 %  clock x1  displacement 0 mm  water (m3/m): rain 2.5, in 1.5, run-off 1, out 0.25, "
      "of it seepage 0.125, evaporation 0.0625, stored 1.25, error 1e-09");
}

}  // namespace
}  // namespace slope::tools
