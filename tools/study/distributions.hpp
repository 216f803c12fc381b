#pragma once

#include <string>
#include <vector>

#include "study.hpp"

/// What OpenTURNS knows of the distributions of a study. Values are in SI units.
namespace slope::tools {

/// "lognormal", "beta", …
[[nodiscard]] std::string name_of(const Distribution& distribution);

/// What makes a distribution impossible, such as a mean outside of its ends; empty: nothing.
[[nodiscard]] std::string fault_of(const Distribution& distribution);

/// The value that is not exceeded with a probability, between 0 and 1.
[[nodiscard]] double quantile(const Distribution& distribution, double probability);
/// The mean and standard deviation of what is left between the limits.
[[nodiscard]] double mean(const Distribution& distribution);
[[nodiscard]] double standard_deviation(const Distribution& distribution);

/// What makes the correlations impossible; empty: nothing.
[[nodiscard]] std::string fault_of(const std::vector<Parameter>& parameters,
                                   const std::vector<Correlation>& correlations);

}  // namespace slope::tools
