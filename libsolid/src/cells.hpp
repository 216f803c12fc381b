#pragma once

#include "slope/solid/material_point_method.hpp"
#include "threads.hpp"

namespace slope::solid {

// Calls visit(k) for each entry of bands of rows, the even bands first, such that two threads are never in bands that
// touch, and in an order that does not depend on their number. `bands` has the first entry of each, and the end.
template <class Visit>
void MaterialPointMethod::for_each_in_bands(const std::vector<std::size_t>& bands, const Visit& visit) const {
  const std::size_t count = bands.size() - 1;
  for (std::size_t parity = 0; parity < 2; ++parity) {
    const std::size_t parts = (count + 1 - parity) / 2;
    share_out(parts, settings_.threads, [&](std::size_t part) {
      const std::size_t band = 2 * part + parity;
      for (std::size_t k = bands[band]; k < bands[band + 1]; ++k) visit(k);
    });
  }
}

// Calls visit(c) for each cell that holds particles; cells that share nodes are never visited by two threads at once.
template <class Visit>
void MaterialPointMethod::for_each_cell(const Visit& visit) const {
  for_each_in_bands(bands_, visit);
}

// The particles in a grid cell, in the order of their indices.
inline std::span<const std::size_t> MaterialPointMethod::particles_in(std::size_t cell) const {
  const std::size_t first = cell == 0 ? 0 : cell_start_[cell - 1];
  return std::span(cell_particles_).subspan(first, cell_start_[cell] - first);
}

// Whether the grid holds a coordinate of a particle.
inline bool MaterialPointMethod::holds_x_of(std::size_t p) const {
  const double place = (state_.particles.x[p] - grid_.lower[0]) * (1.0 / grid_.cell_size);
  return place >= 0.0 && place < grid_.columns;
}

inline bool MaterialPointMethod::holds_y_of(std::size_t p) const {
  const double place = (state_.particles.y[p] - grid_.lower[1]) * (1.0 / grid_.cell_size);
  return place >= 0.0 && place < grid_.rows;
}

}  // namespace slope::solid
