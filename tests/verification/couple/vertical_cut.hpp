#pragma once

#include <algorithm>
#include <string>

#include "run_case.hpp"

namespace slope::testing {

inline constexpr double poissons_ratios[] = {0.0, 0.33, 0.45, 0.49};

/// How the cut with so many cells in its height has moved after 6 s, or when it has moved by 30 cm.
inline couple::Summary cut(double factor, int cells, double poissons_ratio) {
  couple::Simulation simulation = start_case(
      "vertical_cut.yaml", {"domain.cell_size=" + std::to_string(9.6 / cells) + " m",
                            "soils.clay.poissons_ratio=" + std::to_string(poissons_ratio),
                            "soils.clay.strength.undrained_strength=" + std::to_string(47.8803 * factor) + " kPa"});
  run(simulation, [](const couple::ParticleTable&) {});
  return simulation.summary();
}

/// The one of all Poisson's ratios that has moved least, and most (m).
struct Range {
  double least = 1.0, most = 0.0;
};
inline Range displacement(double factor, int cells) {
  Range range;
  for (const double nu : poissons_ratios) {
    const double moved = cut(factor, cells, nu).largest_displacement;
    range = {std::min(range.least, moved), std::max(range.most, moved)};
  }
  return range;
}

}  // namespace slope::testing
