#include "statistics.hpp"

#include <algorithm>
#include <cmath>
#include <openturns/Binomial.hxx>
#include <openturns/CorrelationAnalysis.hxx>
#include <openturns/DistFunc.hxx>
#include <openturns/Log.hxx>
#include <openturns/SaltelliSensitivityAlgorithm.hxx>
#include <openturns/Sample.hxx>

namespace slope::tools {

namespace {

constexpr double outside = 0.025;  // probability beyond either end of an interval

OT::Sample sample_of(const std::vector<double>& values) {
  OT::Sample sample(values.size(), 1);
  for (std::size_t i = 0; i < values.size(); ++i) sample(i, 0) = values[i];
  return sample;
}

OT::Sample sample_of(const std::vector<std::vector<double>>& rows) {
  OT::Sample sample(rows.size(), rows.front().size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < rows[i].size(); ++j) sample(i, j) = rows[i][j];
  }
  return sample;
}

bool varies(const std::vector<double>& values) {
  return std::ranges::any_of(values, [&](double value) { return value != values.front(); });
}

}  // namespace

std::vector<double> column_of(const std::vector<std::vector<double>>& rows, std::size_t j) {
  std::vector<double> column;
  for (const std::vector<double>& row : rows) column.push_back(row[j]);
  return column;
}

Estimate probability_of(std::size_t happened, std::size_t trials) {
  const auto k = static_cast<double>(happened), n = static_cast<double>(trials);
  return {k / n, happened == 0 ? 0.0 : OT::DistFunc::qBeta(k, n - k + 1.0, outside),
          happened == trials ? 1.0 : OT::DistFunc::qBeta(k + 1.0, n - k, 1.0 - outside)};
}

Estimate mean_of(const std::vector<double>& values) {
  Estimate mean;
  if (values.empty()) return mean;
  mean.value = sample_of(values).computeMean()[0];
  if (values.size() < 2) return mean;
  const auto n = static_cast<double>(values.size());
  const double half = OT::DistFunc::qStudent(n - 1.0, 1.0 - outside) * standard_deviation_of(values) / std::sqrt(n);
  mean.lower = mean.value - half;
  mean.upper = mean.value + half;
  return mean;
}

double standard_deviation_of(const std::vector<double>& values) {
  return values.size() < 2 ? std::nan("") : sample_of(values).computeStandardDeviation()[0];
}

Estimate quantile_of(const std::vector<double>& values, double probability) {
  Estimate quantile;
  if (values.empty()) return quantile;
  quantile.value = sample_of(values).computeQuantilePerComponent(probability)[0];
  std::vector<double> sorted = values;
  std::ranges::sort(sorted);
  // the number of values below the quantile is binomial
  const OT::Binomial below(values.size(), probability);
  const auto low = static_cast<std::size_t>(below.computeQuantile(outside)[0]);
  const auto high = static_cast<std::size_t>(below.computeQuantile(1.0 - outside)[0]) + 1;
  if (low >= 1) quantile.lower = sorted[low - 1];
  if (high <= sorted.size()) quantile.upper = sorted[high - 1];
  return quantile;
}

double rank_correlation(const std::vector<double>& one, const std::vector<double>& other) {
  if (one.size() < 3 || !varies(one) || !varies(other)) return std::nan("");
  return OT::CorrelationAnalysis(sample_of(one), sample_of(other)).computeSpearmanCorrelation()[0];
}

std::vector<double> partial_rank_correlations(const std::vector<std::vector<double>>& samples,
                                              const std::vector<double>& results) {
  const std::size_t parameters = samples.empty() ? 0 : samples.front().size();
  if (samples.size() < parameters + 3 || !varies(results)) return std::vector<double>(parameters, std::nan(""));
  if (parameters == 1) return {rank_correlation(column_of(samples, 0), results)};
  for (std::size_t j = 0; j < parameters; ++j) {
    if (!varies(column_of(samples, j))) return std::vector<double>(parameters, std::nan(""));
  }
  const OT::Point found = OT::CorrelationAnalysis(sample_of(samples), sample_of(results)).computePRCC();
  return {found.begin(), found.end()};
}

SobolEstimates sobol_indices(const std::vector<std::vector<double>>& samples, const std::vector<double>& results,
                             std::size_t base) {
  OT::Log::Show(OT::Log::NONE);  // it warns of what the intervals tell
  OT::SaltelliSensitivityAlgorithm algorithm(sample_of(samples), sample_of(results), base);
  algorithm.setUseAsymptoticDistribution(true);
  const auto estimates = [](const OT::Point& values, const OT::Interval& intervals) {
    std::vector<Estimate> all;
    for (OT::UnsignedInteger j = 0; j < values.getSize(); ++j) {
      all.push_back({values[j], intervals.getLowerBound()[j], intervals.getUpperBound()[j]});
    }
    return all;
  };
  return {estimates(algorithm.getFirstOrderIndices(), algorithm.getFirstOrderIndicesInterval()),
          estimates(algorithm.getTotalOrderIndices(), algorithm.getTotalOrderIndicesInterval())};
}

}  // namespace slope::tools
