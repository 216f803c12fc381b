#pragma once

#include <vector>

#include "slope/seepage/boundary.hpp"
#include "slope/solid/material_point_method.hpp"

namespace slope::couple {

/// What acts from outside during one step.
struct Actions {
  std::vector<solid::ParticleTraction> tractions;
  seepage::Boundary water;
};

}  // namespace slope::couple
