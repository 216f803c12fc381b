// A study of a slope whose factor of safety is known for every sample: the strength over the unit weight of undrained
// clay, times a constant that one search finds.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "program.hpp"
#include "scratch_folder.hpp"
#include "slope/testing/record.hpp"
#include "study_results.hpp"

namespace slope::testing {
namespace {

namespace fs = std::filesystem;
using tools::test::slope_sim;

constexpr double mean_strength = 12.0, variation = 0.2;           // kPa, -
constexpr double mean_grains = 2700.0, grains_deviation = 100.0;  // kg/m3
constexpr double porosity = 0.35, water = 1000.0;                 // -, kg/m3

double density(double grains) {
  return (1.0 - porosity) * grains + porosity * water;
}

/// Of strength over density (kPa m3/kg) when the factor is one, from the factor of the mean slope.
double critical_ratio(double factor) {
  return mean_strength / density(mean_grains) / factor;
}

/// The strength is lognormal, the density of the grains normal: the probability is an integral over the latter.
double probability_of_failure(double critical) {
  const double variance = std::log(1.0 + variation * variation);
  const double place = std::log(mean_strength) - 0.5 * variance;
  constexpr int steps = 2000;
  constexpr double widest = 6.0;
  double sum = 0.0, weights = 0.0;
  for (int i = 0; i <= steps; ++i) {
    const double score = widest * (2.0 * i / steps - 1.0), weight = std::exp(-0.5 * score * score);
    const double strength = critical * density(mean_grains + grains_deviation * score);
    sum += weight * 0.5 * std::erfc((place - std::log(strength)) / std::sqrt(2.0 * variance));
    weights += weight;
  }
  return sum / weights;
}

TEST(Reliability, OfAnUndrainedCutIsItsClosedForm) {
  const tools::test::ScratchFolder folder;
  fs::copy(fs::path(SLOPE_CLI_TESTS) / "cut.yaml", folder.path() / "cut.yaml");
  std::ofstream(folder.path() / "study.yaml")
      << "title: A cut\ncase: cut.yaml\nparameters:\n"
         "  strength: {key: soils.clay.strength.undrained_strength, distribution: lognormal, mean: 12 kPa, "
         "coefficient_of_variation: 20 %}\n"
         "  grains: {key: soils.clay.grain_density, distribution: normal, mean: 2700 kg/m3, standard_deviation: 100 "
         "kg/m3}\n"
         "design: {type: latin_hypercube, samples: 100}\nresults: {factor: {key: factor_of_safety.factor}}\n"
         "failure: factor < 1\n";
  const std::string study = (folder.path() / "study").string(), mean = (folder.path() / "mean").string();
  ASSERT_EQ(
      slope_sim({"safety", (folder.path() / "cut.yaml").string(), "-o", mean, "--quiet"}, folder.path()).exit_code, 0);
  const tools::test::Outcome outcome = slope_sim(
      {"study", (folder.path() / "study.yaml").string(), "-o", study, "--jobs", "2", "--quiet"}, folder.path());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;

  const fs::path table = fs::path(study) / "study.csv";
  const auto strengths = tools::study_column(table, "strength"), grains = tools::study_column(table, "grains");
  const auto factors = tools::study_column(table, "factor");
  std::ifstream safety(fs::path(mean) / "safety.csv");
  std::string header;
  char comma = ' ';
  double time = 0.0, factor = 0.0;
  std::getline(safety, header);
  safety >> time >> comma >> factor;
  const double critical = critical_ratio(factor);

  ASSERT_EQ(factors.size(), 100u);
  double largest = 0.0;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const double expected = strengths[i] / density(grains[i]) / critical;
    largest = std::max(largest, std::abs(factors[i] / expected - 1.0));
  }
  EXPECT_TRUE(record("study-factors",
                     "Undrained cut, strength and weight uncertain, 100 runs: factor off its closed form",
                     at_most(0.02), largest, "%"));
  const tools::StudyResults found = tools::read_study_results(fs::path(study) / "study.json");
  const double exact = probability_of_failure(critical);
  EXPECT_TRUE(record("study-probability", "- probability of failure off its closed form", at_most(0.03),
                     std::abs(found.failure->probability.value - exact), "%"));
  EXPECT_LT(found.failure->probability.lower, exact);
  EXPECT_GT(found.failure->probability.upper, exact);
  EXPECT_GT(found.results[0].influences[0].rank_correlation, 0.9);
  EXPECT_LT(found.results[0].influences[1].partial_rank_correlation, -0.8);
}

}  // namespace
}  // namespace slope::testing
