#pragma once

#include <array>

namespace slope::solid {

/// Weights of the nodes around a particle along one axis, and their derivatives.
struct AxisWeights {
  int first = 0;                     ///< grid column (or row) of the first node
  std::array<double, 3> value{};     ///< N (-)
  std::array<double, 3> gradient{};  ///< dN/dx (1/m)
};

/// Quadratic B-spline over three nodes: continuous gradient, no noise when a particle crosses a cell.
struct QuadraticBSpline {
  /// @param position  coordinate in cells from the box's corner (-), >= 0
  /// @param inverse_size  1 / cell size (1/m)
  [[nodiscard]] static AxisWeights weights(double position, double inverse_size) {
    AxisWeights w;
    w.first = static_cast<int>(position + 0.5) - 1;
    const double t = position - w.first;  // in [0.5, 1.5)
    w.value = {0.5 * (1.5 - t) * (1.5 - t), 0.75 - (t - 1.0) * (t - 1.0), 0.5 * (t - 0.5) * (t - 0.5)};
    w.gradient = {(t - 1.5) * inverse_size, -2.0 * (t - 1.0) * inverse_size, (t - 0.5) * inverse_size};
    return w;
  }
};

/// Linear hat functions over two nodes; the third weight is zero.
struct Linear {
  [[nodiscard]] static AxisWeights weights(double position, double inverse_size) {
    AxisWeights w;
    w.first = static_cast<int>(position);
    const double t = position - w.first;
    w.value = {1.0 - t, t, 0.0};
    w.gradient = {-inverse_size, inverse_size, 0.0};
    return w;
  }
};

}  // namespace slope::solid
