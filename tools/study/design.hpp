#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "study.hpp"

namespace slope::tools {

/// The values of the parameters in each run, in the order of the parameters (SI units).
using Samples = std::vector<std::vector<double>>;

/// All samples of a study, of a Monte Carlo design as many as it may take at most. The same seed gives the same
/// samples.
[[nodiscard]] Samples samples_of(const Study& study);

/// How many of the first samples are independent of each other, or count as if they were. The rest of Saltelli's design
/// is made of these.
[[nodiscard]] std::size_t independent_samples(const Study& study, std::size_t samples);

/// Whether intervals can be told, which a grid, being no random sample, does not have.
[[nodiscard]] bool is_random(const Design& design);

/// "latin_hypercube", as in the study file.
[[nodiscard]] std::string name_of(const Design& design);
/// Of the random numbers; 0 of a grid.
[[nodiscard]] int seed_of(const Design& design);

}  // namespace slope::tools
