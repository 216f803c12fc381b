#pragma once

#include <Eigen/Core>
#include <array>

namespace slope::solid {

// The two components of a plain state as an array to compute with.
inline Eigen::Map<Eigen::Array2d> pair(std::array<double, 2>& components) {
  return Eigen::Map<Eigen::Array2d>(components.data());
}

}  // namespace slope::solid
