// Estimates and their intervals against closed forms and tables.

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "design.hpp"
#include "statistics.hpp"

namespace slope::tools::test {
namespace {

TEST(Statistics, IntervalOfAProbabilityIsThatOfClopperAndPearson) {
  const Estimate half = probability_of(5, 10);
  EXPECT_EQ(half.value, 0.5);
  EXPECT_NEAR(half.lower, 0.1871, 5.0e-5);
  EXPECT_NEAR(half.upper, 0.8129, 5.0e-5);
  const Estimate none = probability_of(0, 10);
  EXPECT_EQ(none.lower, 0.0);
  EXPECT_NEAR(none.upper, 1.0 - std::pow(0.025, 0.1), 1.0e-9);
  const Estimate all = probability_of(10, 10);
  EXPECT_EQ(all.upper, 1.0);
  EXPECT_NEAR(all.lower, std::pow(0.025, 0.1), 1.0e-9);
}

// With the interval's ends as probabilities, so many or more, and so many or fewer, happen with 2.5 %.
TEST(Statistics, IntervalOfAProbabilityLeavesAFortiethOutsideOnEitherSide) {
  const Estimate found = probability_of(3, 20);
  const auto at_most = [](int k, double p) {
    double sum = 0.0;
    for (int i = 0; i <= k; ++i) {
      sum += std::exp(std::lgamma(21.0) - std::lgamma(i + 1.0) - std::lgamma(21.0 - i)) * std::pow(p, i) *
             std::pow(1.0 - p, 20 - i);
    }
    return sum;
  };
  EXPECT_NEAR(at_most(3, found.upper), 0.025, 1.0e-9);
  EXPECT_NEAR(1.0 - at_most(2, found.lower), 0.025, 1.0e-9);
}

TEST(Statistics, MeanHasStudentsInterval) {
  const Estimate mean = mean_of({1.0, 2.0, 3.0, 4.0, 5.0});
  EXPECT_EQ(mean.value, 3.0);
  EXPECT_NEAR(mean.upper - 3.0, 2.776445 * std::sqrt(2.5 / 5.0), 1.0e-5);
  EXPECT_NEAR(3.0 - mean.lower, 2.776445 * std::sqrt(2.5 / 5.0), 1.0e-5);
  EXPECT_NEAR(standard_deviation_of({1.0, 2.0, 3.0, 4.0, 5.0}), std::sqrt(2.5), 1.0e-12);
  EXPECT_TRUE(std::isnan(mean_of({1.0}).lower));
  EXPECT_TRUE(std::isnan(mean_of({}).value));
}

// Of the median of a hundred values: the 40th and the 61st, as tables have it.
TEST(Statistics, QuantileHasTheIntervalOfItsRanks) {
  std::vector<double> values(100);
  std::iota(values.rbegin(), values.rend(), 1.0);
  const Estimate median = quantile_of(values, 0.5);
  EXPECT_NEAR(median.value, 50.5, 0.5);
  EXPECT_EQ(median.lower, 40.0);
  EXPECT_EQ(median.upper, 61.0);
  const Estimate high = quantile_of({1.0, 2.0, 3.0}, 0.95);
  EXPECT_TRUE(std::isnan(high.upper)) << "three values say nothing of what is above them";
}

TEST(Statistics, RankCorrelationFollowsTheRanksAlone) {
  EXPECT_NEAR(rank_correlation({1.0, 2.0, 3.0, 4.0}, {1.0, 10.0, 100.0, 1000.0}), 1.0, 1.0e-12);
  EXPECT_NEAR(rank_correlation({1.0, 2.0, 3.0, 4.0}, {4.0, 3.0, 2.0, 1.0}), -1.0, 1.0e-12);
  EXPECT_NEAR(rank_correlation({1.0, 2.0, 3.0, 4.0, 5.0}, {2.0, 1.0, 4.0, 3.0, 5.0}), 0.8, 1.0e-12);
  EXPECT_TRUE(std::isnan(rank_correlation({1.0, 1.0, 1.0}, {1.0, 2.0, 3.0})));
}

Study two_normals(const Design& design, double rank) {
  Study study;
  Normal standard;
  standard.mean = 0.0, standard.standard_deviation = 1.0;
  study.parameters = {{"a", "a", standard, "", 1.0}, {"b", "b", standard, "", 1.0}};
  if (rank != 0.0) study.correlations = {{{"a", "b"}, rank, std::nullopt}};
  study.design = design;
  return study;
}

std::vector<double> sums(const Samples& samples, double of_a, double of_b) {
  std::vector<double> all;
  for (const auto& sample : samples) all.push_back(of_a * sample[0] + of_b * sample[1]);
  return all;
}

// b has nothing to do with the result; what it seems to have is its correlation with a.
TEST(Statistics, PartialRankCorrelationTakesOutWhatAnotherParameterExplains) {
  const Samples samples = samples_of(two_normals(MonteCarlo{.samples = 2000}, 0.6));
  std::vector<double> results = sums(samples, 1.0, 0.0);
  const Samples noise = samples_of(two_normals(MonteCarlo{.samples = 2000, .seed = 9}, 0.0));
  for (std::size_t i = 0; i < results.size(); ++i) results[i] += 0.5 * noise[i][0];
  EXPECT_GT(rank_correlation(column_of(samples, 1), results), 0.4);
  const std::vector<double> partial = partial_rank_correlations(samples, results);
  EXPECT_NEAR(partial[1], 0.0, 4.0 / std::sqrt(2000.0));
  EXPECT_GT(partial[0], 0.7);
}

// Of a sum, the share of each term's variance; first order and total are the same.
TEST(Statistics, SobolIndicesOfASumAreTheSharesOfItsTerms) {
  constexpr int base = 2000;
  const Samples samples = samples_of(two_normals(SobolIndices{base, 1}, 0.0));
  ASSERT_EQ(samples.size(), 4u * base);
  const SobolEstimates found = sobol_indices(samples, sums(samples, 2.0, 1.0), base);
  for (const auto& estimates : {found.first_order, found.total}) {
    EXPECT_NEAR(estimates[0].value, 0.8, 0.1);
    EXPECT_NEAR(estimates[1].value, 0.2, 0.1);
    EXPECT_LE(estimates[0].lower, estimates[0].value);
    EXPECT_GE(estimates[0].upper, estimates[0].value);
  }
}

}  // namespace
}  // namespace slope::tools::test
