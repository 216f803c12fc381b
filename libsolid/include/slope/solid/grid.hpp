#pragma once

#include <array>
#include <cstddef>

namespace slope::solid {

/// How a wall holds the soil: not at all; normal to itself only; altogether; against motion into itself, and along
/// itself up to a share of the effective normal force; or as more of the same soil would, which takes waves away.
enum class Wall { free, roller, fixed, friction, absorbing };

struct Walls {
  Wall left = Wall::roller;
  Wall right = Wall::roller;
  Wall base = Wall::fixed;
  double left_friction = 0.0;    ///< coefficient (-), >= 0, of a wall of the kind `friction`
  double right_friction = 0.0;   ///< (-)
  double base_friction = 0.0;    ///< (-)
  double absorbing_depth = 0.0;  ///< how far the soil goes on behind an absorbing wall until it is fixed (m), > 0
};

/// The background grid: square cells in a box whose left, right and lower sides are walls. Nodes stand at the corners
/// of the cells, with two more rings outside of the box. Quadratic B-splines reach the first; with the second, five by
/// five nodes lie around each node on the box.
struct Grid {
  std::array<double, 2> lower{0.0, 0.0};  ///< lower left corner of the box (m)
  double cell_size = 0.0;                 ///< (m), > 0
  int columns = 0;                        ///< cells in x, > 0
  int rows = 0;                           ///< cells in y, > 0
  Walls walls;

  [[nodiscard]] int node_columns() const { return columns + 5; }
  [[nodiscard]] int node_rows() const { return rows + 5; }
  [[nodiscard]] std::size_t node_count() const { return std::size_t(node_columns()) * std::size_t(node_rows()); }
  [[nodiscard]] std::size_t cell_count() const { return std::size_t(columns) * std::size_t(rows); }
  /// Index of the cell at column i and row j, from 0.
  [[nodiscard]] std::size_t cell(int i, int j) const { return std::size_t(j) * std::size_t(columns) + std::size_t(i); }
  /// Index of the node at column i and row j, each from -2 to the number of cells + 2.
  [[nodiscard]] std::size_t node(int i, int j) const {
    return std::size_t(j + 2) * std::size_t(node_columns()) + std::size_t(i + 2);
  }
};

}  // namespace slope::solid
