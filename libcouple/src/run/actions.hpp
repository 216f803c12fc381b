#pragma once

#include <array>
#include <vector>

#include "slope/seepage/boundary.hpp"
#include "slope/solid/material_point_method.hpp"

namespace slope::couple {

/// A pressure on the soil's surface, continued inside; one entry per particle, or none.
struct StandingWater {
  std::vector<double> pressure;                ///< (Pa), >= 0
  std::vector<double> gradient_x, gradient_y;  ///< (Pa/m)

  [[nodiscard]] solid::SurfacePressure view() const { return {pressure, gradient_x, gradient_y}; }
};

/// What acts from outside during one step.
struct Actions {
  std::vector<solid::ParticleTraction> tractions;
  std::array<double, 2> body_acceleration{0.0, 0.0};  ///< besides gravity (m/s2)
  seepage::Boundary water;
  StandingWater standing_water;

  /// The part that the soil feels.
  [[nodiscard]] solid::Loads loads() const { return {tractions, body_acceleration, standing_water.view()}; }
};

}  // namespace slope::couple
