#pragma once

#include <array>
#include <span>
#include <vector>

#include "slope/couple/case.hpp"

namespace slope::couple {

/// An edge of a region's outline that is not vertical, from left to right.
struct Edge {
  Point left{0.0, 0.0};
  Point right{0.0, 0.0};
  std::size_t region = 0;

  /// y at an x within the edge, exact at its ends (m).
  [[nodiscard]] double height_at(double x) const;
};

/// What of a square is soil.
struct CellCut {
  double area = 0.0;                ///< of all regions together (m2)
  Point centroid{0.0, 0.0};         ///< of that area (m); of no meaning if there is none
  std::vector<double> share;        ///< area of each region, less what later ones take of it (m2)
  std::array<double, 4> contact{};  ///< length of soil on the left, right, lower and upper side (m)
};

/// Areas of the regions in a square, to rounding; later regions overwrite earlier ones. The square is cut into vertical
/// slabs in which no two edges cross, and these are cut into trapezoids.
/// @param corner   lower left corner of the square (m)
/// @param side     of the square (m), > 0
/// @param edges    of outlines that do not cross themselves: at least all that lie above, in or below the square
/// @param regions  number of regions
[[nodiscard]] CellCut cut_cell(const Point& corner, double side, std::span<const Edge> edges, std::size_t regions);

}  // namespace slope::couple
