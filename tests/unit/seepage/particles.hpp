#pragma once

#include <cstddef>
#include <random>
#include <vector>

#include "slope/seepage/skeleton.hpp"

namespace slope::seepage::testing {

/// Particles of a rectangle with its lower left corner at the origin, row by row from below.
struct Particles {
  std::vector<double> x, y, volume, porosity;

  [[nodiscard]] Skeleton skeleton() const { return {x, y, volume, porosity}; }
  [[nodiscard]] std::size_t size() const { return x.size(); }
};

/// A square lattice whose particles are displaced at random by up to `jitter` spacings in each direction.
inline Particles lattice(int columns, int rows, double spacing, double jitter = 0.0, unsigned seed = 1) {
  Particles result;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> offset(-jitter * spacing, jitter * spacing);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      result.x.push_back((column + 0.5) * spacing + (jitter > 0.0 ? offset(random) : 0.0));
      result.y.push_back((row + 0.5) * spacing + (jitter > 0.0 ? offset(random) : 0.0));
    }
  }
  result.volume.assign(result.x.size(), spacing * spacing);
  result.porosity.assign(result.x.size(), 0.4);
  return result;
}

}  // namespace slope::seepage::testing
