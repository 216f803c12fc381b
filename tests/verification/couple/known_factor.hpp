#pragma once

#include <string>
#include <vector>

#include "slope/couple/simulation.hpp"

namespace slope::testing {

/// The slope of slope_factor.yaml, 1:1.5 and 4 m high, in a soil with which its factor of safety is known.
struct KnownFactor {
  std::vector<std::string> overrides;
  double factor = 0.0;  ///< (-)

  /// What strength reduction finds on so many cells in the height, over what is known (-).
  [[nodiscard]] double found_on(int cells) const;
};

/// The factor of safety that strength reduction finds at the start (-).
[[nodiscard]] double found_factor(couple::Simulation simulation);

/// Soil that keeps its volume, by the lowest slip circle (Bishop).
[[nodiscard]] KnownFactor frictional_slope();
/// With associated flow, as limit analysis has it; by the same circle.
[[nodiscard]] KnownFactor dilatant_slope();
/// Undrained clay, by the mean of two bounds.
[[nodiscard]] KnownFactor undrained_slope();

}  // namespace slope::testing
