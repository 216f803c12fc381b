#include "cell_cut.hpp"

#include <algorithm>
#include <optional>

namespace slope::couple {

namespace {

/// What is this close (in sides of the square) is in the same place, whatever the rounding.
constexpr double tolerance = 1.0e-9;

/// A part of an edge within a slab, its heights limited to those of the square.
struct Part {
  double left = 0.0, right = 0.0;
  std::size_t region = 0;
};

/// Where two edges cross, if they do.
std::optional<double> crossing_of(const Edge& a, const Edge& b) {
  const double from = std::max(a.left[0], b.left[0]), to = std::min(a.right[0], b.right[0]);
  if (!(from < to)) return std::nullopt;
  const double before = a.height_at(from) - b.height_at(from), after = a.height_at(to) - b.height_at(to);
  if (!(before * after < 0.0)) return std::nullopt;
  return from + (to - from) * before / (before - after);
}

/// The area between two edges in a slab, with what the square needs to know of it.
class Sum {
 public:
  Sum(const Point& corner, double side) : corner_(corner), side_(side) {}

  void add(CellCut& cut, double from, double to, const Part& low, const Part& high, std::size_t region) {
    const double width = to - from;
    const double left = high.left - low.left, right = high.right - low.right;
    const double area = 0.5 * width * (left + right);
    cut.area += area;
    cut.share[region] += area;
    moment_x_ += 0.5 * width * (left + right) * (from - corner_[0]) + width * width * (left + 2.0 * right) / 6.0;
    moment_y_ += width * (square_of(high) - square_of(low)) / 6.0;
    const double margin = tolerance * side_;
    if (area <= margin * width) return;  // a line above or below the square
    const double bottom = corner_[1] + margin, top = corner_[1] + side_ - margin;
    if (from == corner_[0]) cut.contact[0] += left;
    if (to == corner_[0] + side_) cut.contact[1] += right;
    if (low.left <= bottom && low.right <= bottom) cut.contact[2] += width;
    if (high.left >= top && high.right >= top) cut.contact[3] += width;
  }

  [[nodiscard]] Point centroid(double area) const {
    return {corner_[0] + moment_x_ / area, corner_[1] + moment_y_ / area};
  }

 private:
  /// Three times the mean square of the height above the corner.
  [[nodiscard]] double square_of(const Part& part) const {
    const double a = part.left - corner_[1], b = part.right - corner_[1];
    return a * a + a * b + b * b;
  }

  Point corner_;
  double side_;
  double moment_x_ = 0.0, moment_y_ = 0.0;  // of the area about the corner (m3)
};

/// The borders of the slabs, from the left side of the square to its right one.
std::vector<double> slab_borders(const Point& corner, double side, std::span<const Edge> edges) {
  const double end = corner[0] + side;
  std::vector<double> borders{corner[0], end};
  const auto add = [&](double x) {
    if (x > corner[0] && x < end) borders.push_back(x);
  };
  const Edge bottom{{corner[0], corner[1]}, {end, corner[1]}, 0};
  const Edge top{{corner[0], corner[1] + side}, {end, corner[1] + side}, 0};
  for (std::size_t i = 0; i < edges.size(); ++i) {
    add(edges[i].left[0]);
    add(edges[i].right[0]);
    for (const Edge& line : {bottom, top}) {
      if (const auto x = crossing_of(edges[i], line)) add(*x);
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (const auto x = crossing_of(edges[i], edges[j])) add(*x);
    }
  }
  std::sort(borders.begin(), borders.end());
  borders.erase(std::unique(borders.begin(), borders.end()), borders.end());
  return borders;
}

}  // namespace

double Edge::height_at(double x) const {
  if (x >= right[0]) return right[1];
  return left[1] + (right[1] - left[1]) * ((x - left[0]) / (right[0] - left[0]));
}

CellCut cut_cell(const Point& corner, double side, std::span<const Edge> edges, std::size_t regions) {
  CellCut cut;
  cut.share.assign(regions, 0.0);
  Sum sum(corner, side);
  const double bottom = corner[1], top = corner[1] + side;
  const std::vector<double> borders = slab_borders(corner, side, edges);
  std::vector<Part> parts;
  std::vector<char> inside(regions);
  for (std::size_t slab = 0; slab + 1 < borders.size(); ++slab) {
    const double from = borders[slab], to = borders[slab + 1];
    parts.clear();
    for (const Edge& edge : edges) {
      if (edge.left[0] > from || edge.right[0] < to) continue;
      parts.push_back({edge.height_at(from), edge.height_at(to), edge.region});
    }
    std::sort(parts.begin(), parts.end(),
              [](const Part& a, const Part& b) { return a.left + a.right < b.left + b.right; });
    inside.assign(regions, 0);
    Part low{bottom, bottom, 0};
    std::size_t region = regions;  // the last one that holds what is above `low`; none
    const auto rise_to = [&](const Part& part) {
      const Part high{std::clamp(part.left, bottom, top), std::clamp(part.right, bottom, top), 0};
      if (region < regions) sum.add(cut, from, to, low, high, region);
      low = high;
    };
    for (const Part& part : parts) {
      rise_to(part);
      inside[part.region] ^= 1;
      region = regions;
      for (std::size_t i = 0; i < regions; ++i) {
        if (inside[i] != 0) region = i;
      }
    }
    rise_to({top, top, 0});
  }
  if (cut.area > 0.0) cut.centroid = sum.centroid(cut.area);
  return cut;
}

}  // namespace slope::couple
