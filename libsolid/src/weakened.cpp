// Strength reduction.

#include <stdexcept>

#include "slope/solid/material_point_method.hpp"

namespace slope::solid {

namespace {

Soil weakened_soil(Soil soil, double factor) {
  std::visit(
      [factor](auto& strength) {
        if constexpr (requires { strength.reduction; }) strength.reduction *= factor;
      },
      soil.strength);
  return soil;
}

}  // namespace

MaterialPointMethod MaterialPointMethod::weakened(double factor, std::span<const std::uint8_t> where) const {
  if (!(factor > 0.0)) throw std::invalid_argument("a factor of strength must be above zero");
  MaterialPointMethod result = *this;
  const std::size_t count = soils_.size();
  for (std::size_t k = 0; k < count; ++k) {
    const Soil soil = weakened_soil(soils_[k], factor);
    result.soils_.push_back(soil);
    result.materials_.emplace_back(soil, grid_.cell_size);
  }
  std::vector<std::uint16_t>& soil = result.state_.particles.soil;
  for (std::size_t p = 0; p < soil.size(); ++p) {
    if (where.empty() || where[p] != 0) soil[p] = static_cast<std::uint16_t>(soil[p] + count);
  }
  if (!where.empty()) return result;
  for (double* friction :
       {&result.grid_.walls.left_friction, &result.grid_.walls.right_friction, &result.grid_.walls.base_friction}) {
    *friction /= factor;
  }
  for (WallNode& wall : result.wall_nodes_) wall.friction /= factor;
  return result;
}

}  // namespace slope::solid
