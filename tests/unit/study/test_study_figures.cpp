// From the summaries of runs to the figures of a study.

#include <gtest/gtest.h>

#include <cmath>

#include "dotted_keys.hpp"
#include "scratch_folder.hpp"
#include "slope/couple/results.hpp"
#include "study_figures.hpp"
#include "text_file.hpp"

namespace slope::tools::test {
namespace {

Study study_of(const Design& design, const Failure& failure) {
  Study study;
  study.title = "Slopes";
  Uniform cohesion;
  cohesion.minimum = 0.0, cohesion.maximum = 1.0e4;
  study.parameters = {{"cohesion", "c", cohesion, "kPa", 1.0e3}};
  study.design = design;
  study.questions = {{"wet", "factor_of_safety.factor", 3600.0, "-"},
                     {"least", "factor_of_safety.factor", std::nullopt, "-"},
                     {"onset", "onset.time_s", std::nullopt, "s"},
                     {"slid", "slide.at_end.area_m2", std::nullopt, "m2"}};
  study.failure = failure;
  return study;
}

couple::Summary standing(double wet) {
  couple::Summary summary;
  summary.verdict = couple::Verdict::stands;
  summary.end_reason = couple::EndReason::time;
  summary.safety.resize(2);
  summary.safety[0].factor = 1.5, summary.safety[0].lower = 1.49, summary.safety[0].upper = 1.51;
  summary.safety[1].factor = wet, summary.safety[1].lower = 0.99 * wet, summary.safety[1].upper = 1.01 * wet;
  summary.safety[1].time = 3600.0;
  return summary;
}

RunOutcome outcome(const couple::Summary& summary, RunState state = RunState::finished) {
  return {state, summary.verdict, couple::summary_document(couple::run_summary({}, summary))};
}

const Failure by_verdict{"verdict", "", true, 0.0};

TEST(StudyFigures, FindNumbersOfASummaryByTheirKeys) {
  couple::Summary summary = standing(1.2);
  summary.slide_at_end.area = 7.5;
  summary.slide_at_end.reaches_wall = true;
  const couple::Document document = outcome(summary).summary;
  EXPECT_EQ(number_in(document, "factor_of_safety.factor", 3600.0), 1.2);
  EXPECT_EQ(number_in(document, "factor_of_safety.factor", std::nullopt), 1.2);
  EXPECT_EQ(number_in(document, "factor_of_safety.factor", 0.0), 1.5);
  EXPECT_EQ(number_in(document, "factor_of_safety.factor", 7200.0), std::nullopt);
  EXPECT_EQ(number_in(document, "slide.at_end.area_m2", std::nullopt), 7.5);
  EXPECT_EQ(number_in(document, "slide.at_end.reaches_wall", std::nullopt), 1.0);
  EXPECT_EQ(number_in(document, "onset.time_s", std::nullopt), std::nullopt);
}

// What was interrupted, killed or damaged is taken up again.
TEST(StudyFigures, TellFromASummaryWhatHasBecomeOfARun) {
  const ScratchFolder folder;
  const auto state_after = [&](couple::EndReason reason) {
    couple::Summary summary = standing(1.2);
    summary.end_reason = reason;
    write_at_once(folder.path() / "summary.json", couple::summary_json(couple::run_summary({}, summary)));
    return outcome_of(folder.path()).state;
  };
  EXPECT_EQ(outcome_of(folder.path()).state, RunState::unfinished);
  EXPECT_EQ(state_after(couple::EndReason::running), RunState::unfinished);
  EXPECT_EQ(state_after(couple::EndReason::interrupted), RunState::unfinished);
  EXPECT_EQ(state_after(couple::EndReason::error), RunState::broke_off);
  EXPECT_EQ(state_after(couple::EndReason::time), RunState::finished);
  EXPECT_EQ(state_after(couple::EndReason::displacement), RunState::finished);
  write_at_once(folder.path() / "summary.json", "{\"program\": \"slope-sim\", \"ver");
  EXPECT_EQ(outcome_of(folder.path()).state, RunState::unfinished);
}

TEST(StudyFigures, KnowTheUnitsOfASummary) {
  EXPECT_EQ(summary_number("slide.at_end.area_m2").unit, "m2");
  EXPECT_EQ(summary_number("factor_of_safety.factor").unit, "-");
  EXPECT_EQ(summary_number("factor_of_safety.depth_m").unit, "m");
  EXPECT_EQ(summary_number("water_budget.net_inflow_by_boundary_m3_per_m.rain").unit, "m3/m");
  EXPECT_EQ(summary_number("displacement_times.0.time_s").unit, "s");
  EXPECT_EQ(summary_number("particles").unit, "-");
}

TEST(StudyFigures, TellFailureFromTheVerdictOrAResult) {
  couple::Summary fails = standing(0.9);
  fails.verdict = couple::Verdict::fails;
  fails.onset_time = 1000.0;
  const std::vector<RunOutcome> outcomes{outcome(standing(1.2)), outcome(fails)};
  const auto failed = [&](const Failure& failure) {
    return found_failure(study_of(MonteCarlo{.samples = 2}, failure), outcomes)->failed;
  };
  EXPECT_EQ(failed(by_verdict), 1u);
  EXPECT_EQ(failed({"wet < 1", "wet", true, 1.0}), 1u);
  EXPECT_EQ(failed({"wet < 1.5", "wet", true, 1.5}), 2u);
  EXPECT_EQ(failed({"onset < 1 h", "onset", true, 3600.0}), 1u) << "no onset is no failure";
  EXPECT_EQ(failed({"slid > 1 m2", "slid", false, 1.0}), 0u);
}

// Neither what a run that broke off has come to, nor a factor that was not found, is taken for an answer.
TEST(StudyFigures, LeaveOutWhatIsNotKnown) {
  couple::Summary early = standing(1.2);
  early.safety.pop_back();
  couple::Summary broken = standing(1.2);
  broken.verdict = couple::Verdict::undecided;
  broken.slide_at_end.area = 3.0;
  const std::vector<RunOutcome> outcomes{outcome(early), outcome(broken, RunState::broke_off)};
  const Study study = study_of(MonteCarlo{.samples = 2}, {"wet < 1", "wet", true, 1.0});
  EXPECT_EQ(found_failure(study, outcomes)->runs, 1u);
  EXPECT_EQ(found_failure(study_of(MonteCarlo{.samples = 2}, by_verdict), outcomes)->runs, 1u);
  const StudyRow row = study_row(study, {2.0e3}, outcomes[1]);
  EXPECT_EQ(row.parameters, std::vector<double>{2.0});
  EXPECT_EQ(row.results[0], 1.2);
  EXPECT_EQ(row.results[3], std::nullopt);
  EXPECT_EQ(row.state, "broke off");
  EXPECT_EQ(row.failed, false);
  EXPECT_EQ(study_row(study, {2.0e3}, outcomes[0]).failed, std::nullopt);
}

// Left out, such runs would make a slope look safer than it is.
TEST(StudyFigures, ASlopeThatSlidBeforeItsFactorWasFoundHasFailed) {
  couple::Summary slid = standing(1.2);
  slid.safety.pop_back();
  slid.verdict = couple::Verdict::fails;
  slid.end_reason = couple::EndReason::displacement;
  const Study study = study_of(MonteCarlo{.samples = 1}, {"wet < 1", "wet", true, 1.0});
  EXPECT_EQ(study_row(study, {2.0e3}, outcome(slid)).failed, true);
  EXPECT_EQ(found_failure(study, {outcome(slid)})->probability.value, 1.0);
}

// The middle of a bracket that was not found is no factor: of a slope that slides already, or of one that nothing
// moves.
TEST(StudyFigures, AFactorWithoutABracketCountsForFailureAlone) {
  couple::Summary slides = standing(0.01), firm = standing(20.0);
  slides.safety[1].lower = 0.0, slides.safety[1].upper = 0.02;
  firm.safety[1].lower = 20.0, firm.safety[1].upper.reset();
  const std::vector<RunOutcome> outcomes{outcome(slides), outcome(firm), outcome(standing(1.2))};
  const Samples samples{{1.0e3}, {2.0e3}, {3.0e3}};
  const Study below = study_of(MonteCarlo{.samples = 3}, {"wet < 1", "wet", true, 1.0});
  const StudyResults results = study_results(below, samples, outcomes);
  EXPECT_EQ(results.results[0].runs, 1u);
  EXPECT_NEAR(results.results[0].mean.value, 1.2, 1.0e-12);
  EXPECT_EQ(results.failure->runs, 3u);
  EXPECT_EQ(results.failure->failed, 1u);
  EXPECT_EQ(study_row(below, samples[0], outcomes[0]).results[0], std::nullopt);
  EXPECT_EQ(found_failure(study_of(MonteCarlo{.samples = 3}, {"wet > 1.3", "wet", false, 1.3}), outcomes)->failed, 1u);
}

TEST(StudyFigures, AGridHasNoIntervals) {
  const Study study = study_of(Grid{2}, by_verdict);
  const std::vector<RunOutcome> outcomes{outcome(standing(1.2)), outcome(standing(1.4))};
  const StudyResults results = study_results(study, {{2.5e3}, {7.5e3}}, outcomes);
  EXPECT_EQ(results.failure->probability.value, 0.0);
  EXPECT_TRUE(std::isnan(results.failure->probability.upper));
  EXPECT_TRUE(std::isnan(results.results[0].mean.upper));
  EXPECT_NEAR(results.results[0].mean.value, 1.3, 1.0e-12);
}

TEST(StudyFigures, AreReadBackAsTheyAreWritten) {
  Study study = study_of(SobolIndices{2, 5}, by_verdict);
  std::vector<RunOutcome> outcomes;
  Samples samples;
  for (int i = 0; i < 6; ++i) {
    outcomes.push_back(outcome(standing(1.0 + 0.1 * i)));
    samples.push_back({1.0e3 * i});
  }
  outcomes.back().state = RunState::broke_off;
  const StudyResults results = study_results(study, samples, outcomes);
  EXPECT_EQ(results.broken, 1u);
  const ScratchFolder folder;
  write_at_once(folder.path() / "study.json", study_json(results));
  EXPECT_EQ(study_json(read_study_results(folder.path() / "study.json")), study_json(results));
  std::vector<StudyRow> rows;
  for (std::size_t i = 0; i < samples.size(); ++i) rows.push_back(study_row(study, samples[i], outcomes[i]));
  write_at_once(folder.path() / "study.csv", study_csv(results, rows));
  EXPECT_EQ(study_column(folder.path() / "study.csv", "cohesion"), (std::vector<double>{0, 1, 2, 3, 4, 5}));
  EXPECT_TRUE(std::isnan(study_column(folder.path() / "study.csv", "slid").back()));
  EXPECT_THROW(static_cast<void>(study_column(folder.path() / "study.csv", "suction")), couple::FileError);
  write_at_once(folder.path() / "study.json", "{\"program\": \"slope-sim study\", \"runs\": -3}");
  EXPECT_THROW(static_cast<void>(read_study_results(folder.path() / "study.json")), couple::FileError);
}

}  // namespace
}  // namespace slope::tools::test
