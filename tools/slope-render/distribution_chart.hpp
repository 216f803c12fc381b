#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "plot_frame.hpp"

namespace slope::tools {

/// A quantile of a distribution with the ends of its interval; NaN: none.
struct QuantileMark {
  double probability = 0.5, value = 0.0;
  double lower = 0.0, upper = 0.0;
};

/// How values are distributed: a histogram, and below it the share of values up to each.
struct DistributionChart {
  std::string title;
  std::string x_title;              ///< with unit
  std::vector<double> values;       ///< at least one, finite
  std::vector<QuantileMark> marks;  ///< drawn with their intervals
  std::optional<double> limit;      ///< a value that is marked
  std::string limit_name;           ///< what is written there
};

/// Counts of values in equal steps.
struct Histogram {
  double first = 0.0, step = 1.0;  ///< lower end of the first bin, and its width
  std::vector<int> counts;
};
/// Bins of a round width, about as many as the square root of the number of values. All values are in a bin.
[[nodiscard]] Histogram histogram_of(const std::vector<double>& values);

/// @throws couple::FileError if it cannot be written.
void write_distribution_chart(const std::filesystem::path& file, int width, const DistributionChart& chart);

}  // namespace slope::tools
