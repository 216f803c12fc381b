#include <gtest/gtest.h>

#include <limits>

#include "progress_line.hpp"
#include "report.hpp"
#include "slope/couple/results.hpp"

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
  summary.end_reason = couple::EndReason::displacement;
  summary.time = 890.5;
  summary.onset_criterion = 0.02;
  summary.onset_time = 618.25;
  summary.onset_position = {11.5, 5.75};
  summary.displacement_times = {{0.02, 618.25}, {1.0, {}}};
  summary.zone_at_onset = couple::FailureZone{1, 2, 3, 4, 5, 6, 8000};
  summary.zone_at_end = couple::FailureZone{15, 7.75, 2.25, 27, 5, 12.75, 38000};
  summary.water = {1.5, 0.25, 1.25, 1.5e-9, 1e-9, {{"rain", 1.5}, {"outlet", -0.25}}, 2.5, 1.5, 1.0, 0.125, 0.0625};
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

couple::RunSummary run_of(const couple::Case& input, const couple::Summary& summary) {
  couple::RunSummary run = couple::run_summary(input, summary);
  run.wall_time = 61.5;
  run.threads = 2;
  return run;
}

TEST(Report, NamesTheCriterionBesideTheOnset) {
  EXPECT_EQ(onset_text(a_case(), a_failure()), "618.25 s (largest displacement above 2 cm), at x = 11.5 m, y = 5.8 m");
  couple::Summary standing = a_failure();
  standing.onset_time.reset();
  EXPECT_EQ(onset_text(a_case(), standing), "none (the largest displacement stayed below 2 cm)");
}

TEST(Report, SaysByWhichCriterionTheOnsetIs) {
  couple::Case input = a_case();
  input.onset = couple::Onset::runaway;
  EXPECT_EQ(onset_text(input, a_failure()), "618.25 s (the motion runs away), at x = 11.5 m, y = 5.8 m");
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
  const auto report = [&] { return report_text(a_case(), run_of(a_case(), summary)); };
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
  const auto report = [&](couple::EndReason reason) {
    couple::Summary summary = a_failure();
    summary.end_reason = reason;
    return report_text(input, run_of(input, summary));
  };
  EXPECT_NE(report(couple::EndReason::at_rest).find("890.5 s (the slide has come to rest)"), std::string::npos);
  EXPECT_NE(report(couple::EndReason::time).find("(the time asked for; the slide had not come to rest)"),
            std::string::npos);
  EXPECT_NE(report(couple::EndReason::interrupted).find("890.5 s (interrupted)"), std::string::npos);
}

TEST(Report, SaysZoneSuctionAndWaterWithUnits) {
  const std::string report = report_text(a_case(), run_of(a_case(), a_failure()));
  for (const char* part :
       {"890.5 s (displacement above 0.3 m)",
        "15.0 m long, 7.8 m high, 2.2 m deep, 27.0 m2 (deviatoric strain above 2 %)",
        "verdict          fails, after 618.25 s", "the motion runs away from 590.5 s on",
        "0.3 m at the end, where it is largest; horizontally 0.28 m",
        "0.25 m beyond the first toe, x = 10.0000 m, y = 5.0000 m, to the left", "31.5 m2 (displacement above 2 cm)",
        "38.0 kPa at most", "1.5 m3/m in, 0.25 m3/m out, 1.25 m3/m stored, balance error 1.0e-09",
        "2.5 m3/m fell: 1.5 m3/m infiltrated, 1 m3/m ran off", "0.125 m3/m seeped out, 0.0625 m3/m evaporated",
        "5089 particles, 46312 steps, 61.5 s on 2 threads"}) {
    EXPECT_NE(report.find(part), std::string::npos) << part << "\n" << report;
  }
}

TEST(Report, TellsOfWhatIsOutOfTheOrdinary) {
  couple::Summary summary = a_failure();
  summary.end_reason = couple::EndReason::time;
  EXPECT_EQ(report_text(a_case(), run_of(a_case(), summary)).find("unsettled"), std::string::npos);
  summary.unsettled_steps = 3;
  summary.time = 82080.0;
  const std::string report = report_text(a_case(), run_of(a_case(), summary));
  EXPECT_NE(report.find("3 steps whose pore pressures"), std::string::npos) << report;
  EXPECT_NE(report.find("82080 s (22.8 h) (the time asked for)"), std::string::npos) << report;
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
            "2400 s of 2400 s  100 %  clock x1  displacement 0 mm  water (m3/m): in 0.125, stored 0.125, balance error "
            "0e+00");
  progress.water = a_failure().water;
  EXPECT_EQ(
      progress_text(progress, 2400.0, 50.0),
      "2400 s of 2400 s  100 %  clock x1  displacement 0 mm  water (m3/m): rain 2.5, in 1.5, run-off 1, out 0.25, "
      "of it seepage 0.125, evaporation 0.0625, stored 1.25, balance error 1e-09");
}

}  // namespace
}  // namespace slope::tools
