#pragma once

#include <cstddef>
#include <vector>

#include "slope/couple/case.hpp"

namespace slope::couple {

/// Particles of a case before the first step, in the order of their ids (by grid cell, row by row from below).
struct InitialParticles {
  std::vector<double> x, y;    ///< positions (m)
  std::vector<double> volume;  ///< per metre of thickness (m2)
  std::vector<int> soil;       ///< index into Case::soils
  double spacing = 0.0;        ///< lattice spacing (m)
};

/// Fills the regions with a square lattice of particles: those lattice points that lie inside a polygon.
[[nodiscard]] InitialParticles fill_regions(const Domain& domain, const std::vector<Region>& regions);

/// Particles of a place: the uppermost of each lattice column (ground_surface, free_surface), the lowest (base),
/// the outermost of each lattice row (left, right); limited to the range.
[[nodiscard]] std::vector<std::size_t> particles_at(const PlaceRange& where, const InitialParticles& particles);

}  // namespace slope::couple
