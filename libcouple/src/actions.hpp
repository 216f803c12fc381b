#pragma once

#include <array>
#include <vector>

#include "slope/seepage/boundary.hpp"
#include "slope/solid/material_point_method.hpp"

namespace slope::couple {

/// What acts from outside during one step.
struct Actions {
  std::vector<solid::ParticleTraction> tractions;
  std::array<double, 2> body_acceleration{0.0, 0.0};  ///< besides gravity (m/s2)
  seepage::Boundary water;
};

}  // namespace slope::couple
