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

/// The place of an edge in the order of the outline and the box around it.
struct Box {
  std::size_t edge = 0;
  Point low{0.0, 0.0}, high{0.0, 0.0};
};

/// The boxes of all edges, from left to right.
std::vector<Box> boxes_of(const std::vector<Point>& polygon) {
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    boxes.push_back({i, {std::min(a[0], b[0]), std::min(a[1], b[1])}, {std::max(a[0], b[0]), std::max(a[1], b[1])}});
  }
  std::ranges::sort(boxes, {}, [](const Box& box) { return box.low[0]; });
  return boxes;
}

bool cross_each_other(const std::vector<Point>& polygon, std::size_t i, std::size_t j) {
  const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
  const Point &c = polygon[j], &d = polygon[(j + 1) % polygon.size()];
  return cross(a, b, c) * cross(a, b, d) < 0.0 && cross(c, d, a) * cross(c, d, b) < 0.0;
}

}  // namespace

double distance_to_edge(const Point& a, const Point& b, const Point& point) {
  const double dx = b[0] - a[0];
  const double dy = b[1] - a[1];
  const double length2 = dx * dx + dy * dy;
  const double along = length2 > 0.0 ? ((point[0] - a[0]) * dx + (point[1] - a[1]) * dy) / length2 : 0.0;
  const double t = std::clamp(along, 0.0, 1.0);
  return std::hypot(point[0] - a[0] - t * dx, point[1] - a[1] - t * dy);
}

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
  std::optional<std::pair<std::size_t, std::size_t>> first;
  std::vector<Box> reached;  // from the left, and not yet left behind
  for (const Box& box : boxes_of(polygon)) {
    std::erase_if(reached, [&](const Box& other) { return other.high[0] < box.low[0]; });
    for (const Box& other : reached) {
      if (other.high[1] < box.low[1] || other.low[1] > box.high[1]) continue;
      const std::pair<std::size_t, std::size_t> pair = std::minmax(box.edge, other.edge);
      if ((!first || pair < *first) && cross_each_other(polygon, pair.first, pair.second)) first = pair;
    }
    reached.push_back(box);
  }
  return first;
}

std::optional<std::size_t> turning_corner(const std::vector<Point>& polygon) {
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Point &before = polygon[(i + n - 1) % n], &here = polygon[i], &after = polygon[(i + 1) % n];
    const double back = (before[0] - here[0]) * (after[0] - here[0]) + (before[1] - here[1]) * (after[1] - here[1]);
    if (back > 0.0 && std::abs(cross(here, before, after)) <= 1.0e-12 * back) return i;
  }
  return std::nullopt;
}

}  // namespace slope::couple
