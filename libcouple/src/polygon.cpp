#include "polygon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slope::couple {

namespace {

/// Twice the area of the triangle a b c; positive if it goes round anticlockwise.
double cross(const Point& a, const Point& b, const Point& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

double distance_to_edge(const Point& a, const Point& b, const Point& point) {
  const double dx = b[0] - a[0];
  const double dy = b[1] - a[1];
  const double length2 = dx * dx + dy * dy;
  const double along = length2 > 0.0 ? ((point[0] - a[0]) * dx + (point[1] - a[1]) * dy) / length2 : 0.0;
  const double t = std::clamp(along, 0.0, 1.0);
  return std::hypot(point[0] - a[0] - t * dx, point[1] - a[1] - t * dy);
}

}  // namespace

double signed_area(const std::vector<Point>& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    twice += cross(polygon.front(), polygon[i], polygon[(i + 1) % polygon.size()]);
  }
  return 0.5 * twice;
}

double distance_to_outline(const std::vector<Point>& polygon, const Point& point) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    nearest = std::min(nearest, distance_to_edge(polygon[i], polygon[(i + 1) % polygon.size()], point));
  }
  return nearest;
}

bool contains(const std::vector<Point>& polygon, const Point& point, double tolerance) {
  if (distance_to_outline(polygon, point) <= tolerance) return true;
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point& a = polygon[i];
    const Point& b = polygon[(i + 1) % polygon.size()];
    if ((a[1] > point[1]) == (b[1] > point[1])) continue;
    const bool left_of_edge = cross(a, b, point) > 0.0;
    if (left_of_edge == (b[1] > a[1])) inside = !inside;
  }
  return inside;
}

std::optional<std::pair<std::size_t, std::size_t>> crossing_edges(const std::vector<Point>& polygon) {
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      const Point& a = polygon[i];
      const Point& b = polygon[(i + 1) % n];
      const Point& c = polygon[j];
      const Point& d = polygon[(j + 1) % n];
      const bool parted_by_first = cross(a, b, c) * cross(a, b, d) < 0.0;
      const bool parted_by_second = cross(c, d, a) * cross(c, d, b) < 0.0;
      if (parted_by_first && parted_by_second) return std::pair(i, j);
    }
  }
  return std::nullopt;
}

}  // namespace slope::couple
