#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "slope/solid/material_point_method.hpp"

namespace slope::solid::testing {

constexpr double degree = std::numbers::pi / 180.0;

/// The soil of the paper's Table 2; it yields only where a test says so.
inline Soil table_2_soil() {
  return {.elastic = {.youngs_modulus = 1.0e7, .poissons_ratio = 0.33}, .strength = NoYield{}, .grain_density = 2700.0};
}

inline DruckerPrager table_2_strength() {
  return {.cohesion = 1.0e3,
          .friction_angle = 25.0 * degree,
          .dilatancy_angle = 0.0,
          .maximum_cohesion_increase = 1.0e5,
          .cohesion_suction_rate = 0.07,
          .friction_angle_suction_rate = 0.0};
}

/// A rectangle of soil, four particles to a cell, in a box that may be larger.
struct Block {
  double cell_size = 0.5;
  int columns = 2;       ///< of the box
  int rows = 24;         ///< of the box
  int first_column = 0;  ///< of the soil
  int first_row = 0;     ///< of the soil
  int soil_columns = 2;
  int soil_rows = 20;
  Walls walls{.left = Wall::roller, .right = Wall::roller, .base = Wall::fixed};
  Soil soil = table_2_soil();
  double porosity = 0.35;
  Settings settings;

  [[nodiscard]] double spacing() const { return 0.5 * cell_size; }
  [[nodiscard]] double dry_density() const { return (1.0 - porosity) * soil.grain_density; }
  [[nodiscard]] double saturated_density() const { return dry_density() + porosity * 1000.0; }

  [[nodiscard]] MaterialPointMethod build() const {
    std::vector<double> x, y;
    for (int j = 0; j < 2 * soil_rows; ++j) {
      for (int i = 0; i < 2 * soil_columns; ++i) {
        x.push_back(first_column * cell_size + (i + 0.5) * spacing());
        y.push_back(first_row * cell_size + (j + 0.5) * spacing());
      }
    }
    const std::size_t n = x.size();
    const std::vector<double> volume(n, spacing() * spacing());
    const std::vector<double> porosities(n, porosity);
    const std::vector<std::uint16_t> soil_index(n, 0);
    const std::vector<double> grain_density{soil.grain_density};
    const Grid grid{.lower = {0.0, 0.0}, .cell_size = cell_size, .columns = columns, .rows = rows, .walls = walls};
    Settings with_layer = settings;
    with_layer.particle_spacing = spacing();
    return {grid, {soil}, Particles::at(x, y, volume, porosities, soil_index, grain_density), with_layer};
  }

  /// n rho_w V of water in each particle, so that the block has its saturated density.
  [[nodiscard]] std::vector<double> pore_water(const MaterialPointMethod& solid) const {
    std::vector<double> mass = solid.particles().volume;
    for (double& m : mass) m *= porosity * 1000.0;
    return mass;
  }
};

inline double fastest(const Particles& particles) {
  double speed = 0.0;
  for (std::size_t p = 0; p < particles.size(); ++p) {
    speed = std::max(speed, std::hypot(particles.vx[p], particles.vy[p]));
  }
  return speed;
}

}  // namespace slope::solid::testing
