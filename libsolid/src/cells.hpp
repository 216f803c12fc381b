#pragma once

#include "slope/solid/material_point_method.hpp"

namespace slope::solid {

// Calls visit(c) for each cell that holds particles, such that cells that share nodes are never visited by two threads
// at once, and in an order that does not depend on their number: bands of three rows of cells, the even ones first.
template <class Visit>
void MaterialPointMethod::for_each_cell(const Visit& visit) const {
  const std::size_t bands = bands_.size() - 1;
  for (std::size_t parity = 0; parity < 2; ++parity) {
#pragma omp parallel for schedule(dynamic) num_threads(settings_.threads) if (settings_.threads > 1)
    for (std::size_t band = parity; band < bands; band += 2) {
      for (std::size_t c = bands_[band]; c < bands_[band + 1]; ++c) visit(c);
    }
  }
}

}  // namespace slope::solid
