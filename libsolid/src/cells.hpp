#pragma once

#include "slope/solid/material_point_method.hpp"

namespace slope::solid {

// Calls visit(k) for each entry of bands of rows, the even bands first, such that two threads are never in bands that
// touch, and in an order that does not depend on their number. `bands` has the first entry of each, and the end.
template <class Visit>
void MaterialPointMethod::for_each_in_bands(const std::vector<std::size_t>& bands, const Visit& visit) const {
  const std::size_t count = bands.size() - 1;
  for (std::size_t parity = 0; parity < 2; ++parity) {
#pragma omp parallel for schedule(dynamic) num_threads(settings_.threads) if (settings_.threads > 1)
    for (std::size_t band = parity; band < count; band += 2) {
      for (std::size_t k = bands[band]; k < bands[band + 1]; ++k) visit(k);
    }
  }
}

// Calls visit(c) for each cell that holds particles; cells that share nodes are never visited by two threads at once.
template <class Visit>
void MaterialPointMethod::for_each_cell(const Visit& visit) const {
  for_each_in_bands(bands_, visit);
}

}  // namespace slope::solid
