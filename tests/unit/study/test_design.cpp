// Samples: their distributions, their correlations, and how each design spreads them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "design.hpp"
#include "distributions.hpp"
#include "statistics.hpp"

namespace slope::tools::test {
namespace {

/// Cohesion and friction; their quantiles are known in closed form.
Study study_of(const Design& design, const std::vector<Correlation>& correlations = {}) {
  Study study;
  Lognormal cohesion;
  cohesion.mean = 5.0e3, cohesion.coefficient_of_variation = 0.4;
  Normal friction;
  friction.mean = 0.5, friction.standard_deviation = 0.05;
  study.parameters = {{"cohesion", "c", cohesion, "kPa", 1.0e3}, {"friction", "f", friction, "", 1.0}};
  study.correlations = correlations;
  study.design = design;
  return study;
}

/// Shares of the distribution below the values of a parameter.
std::vector<double> shares(const Samples& samples) {
  const double variance = std::log(1.0 + 0.16), place = std::log(5.0e3) - 0.5 * variance;
  std::vector<double> all;
  for (const auto& sample : samples) {
    all.push_back(0.5 * std::erfc((place - std::log(sample[0])) / std::sqrt(2.0 * variance)));
  }
  return all;
}

double pearson(const Samples& samples) {
  const std::vector<double> x = column_of(samples, 0), y = column_of(samples, 1);
  const double mean_x = mean_of(x).value, mean_y = mean_of(y).value;
  double sum = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += (x[i] - mean_x) * (y[i] - mean_y);
  return sum / (static_cast<double>(x.size() - 1) * standard_deviation_of(x) * standard_deviation_of(y));
}

TEST(Design, TheSameSeedGivesTheSameSamplesAndAnotherOthers) {
  for (const auto& make : {+[](int seed) { return Design{MonteCarlo{.samples = 20, .seed = seed}}; },
                           +[](int seed) {
                             return Design{LatinHypercube{20, seed}};
                           },
                           +[](int seed) {
                             return Design{SobolSequence{20, seed}};
                           },
                           +[](int seed) {
                             return Design{SobolIndices{20, seed}};
                           }}) {
    EXPECT_EQ(samples_of(study_of(make(3))), samples_of(study_of(make(3))));
    EXPECT_NE(samples_of(study_of(make(3))), samples_of(study_of(make(4))));
  }
}

// So that a study can go on with more of them.
TEST(Design, MoreSamplesOfMonteCarloBeginWithTheSame) {
  const Correlation given{{"cohesion", "friction"}, 0.5, std::nullopt};
  const Samples few = samples_of(study_of(MonteCarlo{.samples = 20}, {given}));
  Samples more = samples_of(study_of(MonteCarlo{.samples = 75}, {given}));
  more.resize(20);
  EXPECT_EQ(more, few);
}

TEST(Design, MonteCarloHasTheMomentsOfTheDistributions) {
  constexpr int n = 4000;
  const Samples samples = samples_of(study_of(MonteCarlo{.samples = n}));
  const double four_errors = 4.0 / std::sqrt(n);
  EXPECT_NEAR(mean_of(column_of(samples, 0)).value, 5.0e3, four_errors * 2.0e3);
  EXPECT_NEAR(mean_of(column_of(samples, 1)).value, 0.5, four_errors * 0.05);
  EXPECT_NEAR(standard_deviation_of(column_of(samples, 0)), 2.0e3, 0.1 * 2.0e3);
  EXPECT_NEAR(standard_deviation_of(column_of(samples, 1)), 0.05, 0.05 * 0.05);
  EXPECT_NEAR(pearson(samples), 0.0, four_errors);
}

TEST(Design, LatinHypercubeHasOneSampleInEachShare) {
  constexpr int n = 50;
  const Samples samples = samples_of(study_of(LatinHypercube{n, 7}));
  std::set<int> taken;
  for (const double share : shares(samples)) taken.insert(static_cast<int>(share * n));
  EXPECT_EQ(taken.size(), static_cast<std::size_t>(n));
}

TEST(Design, SobolSequenceHasEquallyManySamplesInEachEighth) {
  const Samples samples = samples_of(study_of(SobolSequence{64, 7}));
  std::vector<int> counts(8);
  for (const double share : shares(samples)) ++counts.at(static_cast<std::size_t>(8.0 * share));
  for (const int count : counts) EXPECT_NEAR(count, 8, 1);
}

TEST(Design, GridHasEveryCombinationOfTheMiddlesOfEqualShares) {
  const Samples samples = samples_of(study_of(Grid{3}));
  ASSERT_EQ(samples.size(), 9u);
  std::set<int> sixths, combinations;
  const std::vector<double> first = shares(samples);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double sixth = 6.0 * first[i];
    EXPECT_NEAR(sixth, std::round(sixth), 1.0e-6);
    sixths.insert(static_cast<int>(std::lround(sixth)));
    combinations.insert(static_cast<int>(std::lround(1.0e6 * first[i]) + std::lround(1.0e3 * samples[i][1])));
  }
  EXPECT_EQ(sixths, (std::set<int>{1, 3, 5}));
  EXPECT_EQ(combinations.size(), 9u);
}

TEST(Design, SamplesHaveTheRankCorrelationAskedFor) {
  constexpr int n = 4000;
  for (const double rank : {-0.7, 0.4}) {
    const Correlation given{{"cohesion", "friction"}, rank, std::nullopt};
    for (const Design& design : {Design{MonteCarlo{.samples = n}}, Design{LatinHypercube{500, 1}}}) {
      const Samples samples = samples_of(study_of(design, {given}));
      const double four_errors = 4.0 / std::sqrt(static_cast<double>(samples.size()));
      EXPECT_NEAR(rank_correlation(column_of(samples, 0), column_of(samples, 1)), rank, four_errors);
    }
  }
}

// Of a lognormal and a normal parameter: that of the normal scores times zeta / sqrt(exp(zeta^2) - 1).
TEST(Design, SamplesHavePearsonsCorrelationAskedFor) {
  constexpr int n = 4000;
  const Correlation given{{"friction", "cohesion"}, std::nullopt, -0.5};
  const Samples samples = samples_of(study_of(MonteCarlo{.samples = n}, {given}));
  EXPECT_NEAR(pearson(samples), -0.5, 4.0 / std::sqrt(n));
  const double zeta = std::sqrt(std::log(1.0 + 0.16)), scores = -0.5 * 0.4 / zeta;
  const double rank = 6.0 / std::numbers::pi * std::asin(0.5 * scores);
  EXPECT_NEAR(rank_correlation(column_of(samples, 0), column_of(samples, 1)), rank, 4.0 / std::sqrt(n));
}

TEST(Design, CorrelationsThatCannotBeAreRefused) {
  Study study = study_of(MonteCarlo{.samples = 10});
  Uniform stiffness;
  stiffness.minimum = 1.0, stiffness.maximum = 2.0;
  study.parameters.push_back({"stiffness", "e", stiffness, "", 1.0});
  const std::vector<std::string> a{"cohesion", "friction"}, b{"friction", "stiffness"}, c{"cohesion", "stiffness"};
  EXPECT_EQ(fault_of(study.parameters, {{a, 0.5, {}}, {b, 0.5, {}}, {c, 0.5, {}}}), "");
  EXPECT_NE(fault_of(study.parameters, {{a, 0.9, {}}, {b, 0.9, {}}, {c, -0.9, {}}}).find("not positive definite"),
            std::string::npos);
  Lognormal steep;
  steep.mean = 1.0, steep.coefficient_of_variation = 3.0;
  study.parameters[0].distribution = steep;
  EXPECT_NE(fault_of(study.parameters, {{a, {}, -0.95}}).find("beyond what two of these"), std::string::npos);
}

}  // namespace
}  // namespace slope::tools::test
