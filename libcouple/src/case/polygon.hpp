#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "slope/couple/case.hpp"

/// Plane polygons, given by their corners in order.
namespace slope::couple {

/// Enclosed area (m2); negative if the corners go round clockwise.
[[nodiscard]] double signed_area(const std::vector<Point>& polygon);

/// Distance of a point from the outline (m).
[[nodiscard]] double distance_to_outline(const std::vector<Point>& polygon, const Point& point);

/// Distance of a point from the line between two others (m).
[[nodiscard]] double distance_to_edge(const Point& a, const Point& b, const Point& point);

/// Whether the point is inside, or within the tolerance (m) of the outline.
[[nodiscard]] bool contains(const std::vector<Point>& polygon, const Point& point, double tolerance);

/// Two edges that cross each other, by the number of their first corner; none if the outline is simple. Of several such
/// pairs the first.
[[nodiscard]] std::optional<std::pair<std::size_t, std::size_t>> crossing_edges(const std::vector<Point>& polygon);

/// A corner at which the outline turns back on itself; none if there is no such corner.
[[nodiscard]] std::optional<std::size_t> turning_corner(const std::vector<Point>& polygon);

}  // namespace slope::couple
