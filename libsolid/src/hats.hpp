#pragma once

#include "slope/solid/material_point_method.hpp"

namespace slope::solid {

// What the values at the nodes of the hats are at a particle.
inline double MaterialPointMethod::from_hats(std::size_t p) const {
  const HatWeights& w = hat_weights_[p];
  const double* lower = hat_value_.data() + w.corner;
  const double* upper = lower + grid_.node_columns();
  return w.value[0] * lower[0] + w.value[1] * lower[1] + w.value[2] * upper[0] + w.value[3] * upper[1];
}

}  // namespace slope::solid
