#pragma once

#include <cstddef>
#include <vector>

#include "study_results.hpp"

/// Estimates from independent samples, and what parameters explain, by OpenTURNS.
namespace slope::tools {

/// One column of a table of rows.
[[nodiscard]] std::vector<double> column_of(const std::vector<std::vector<double>>& rows, std::size_t j);

/// The probability of an event that happened in some of so many trials, with the interval of Clopper and Pearson.
/// @param trials  above 0
[[nodiscard]] Estimate probability_of(std::size_t happened, std::size_t trials);

/// With Student's interval; none of less than two values.
[[nodiscard]] Estimate mean_of(const std::vector<double>& values);
/// NaN of less than two values.
[[nodiscard]] double standard_deviation_of(const std::vector<double>& values);
/// With the interval between two of the values, whose ranks hold it with a probability of 95 %; no end that would lie
/// beyond the values.
[[nodiscard]] Estimate quantile_of(const std::vector<double>& values, double probability);

/// Spearman's coefficient; NaN if one of the two does not vary.
[[nodiscard]] double rank_correlation(const std::vector<double>& one, const std::vector<double>& other);

/// Of each parameter and the results, with what the other parameters explain taken out of both; NaN of less than two
/// samples more than parameters, or if something does not vary.
/// @param samples  a row each, of at least one parameter
[[nodiscard]] std::vector<double> partial_rank_correlations(const std::vector<std::vector<double>>& samples,
                                                            const std::vector<double>& results);

/// Sobol's indices of each parameter, by Saltelli's estimator with the intervals of its asymptotic distribution.
struct SobolEstimates {
  std::vector<Estimate> first_order, total;
};
/// @param samples  of the design for these indices, row by row, and the results of all of them, which vary
/// @param base  number of samples of each of the two that the design is made of
[[nodiscard]] SobolEstimates sobol_indices(const std::vector<std::vector<double>>& samples,
                                           const std::vector<double>& results, std::size_t base);

}  // namespace slope::tools
