#include "slide.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace slope::couple {

namespace {

constexpr double flattest_face = 0.1;  // fall over distance, below which the ground may end a face
constexpr double reach_cells = 2.0;
constexpr double link = 2.0;        // spacings within which particles hang together
constexpr std::size_t splash = 10;  // so few particles that hang together with no others are no front

/// A straight piece of an outline between two neighbouring corners' x.
struct Piece {
  double left = 0.0, right = 0.0;  // heights at its ends

  [[nodiscard]] double middle() const { return 0.5 * (left + right); }
};

double height_on(const Point& a, const Point& b, double x) {
  return std::lerp(a[1], b[1], (x - a[0]) / (b[0] - a[0]));
}

/// The uppermost pieces of each region between two x that no corner lies between.
std::vector<Piece> tops_between(const std::vector<Region>& regions, double left, double right) {
  const double middle = 0.5 * (left + right);
  std::vector<Piece> tops;
  for (const Region& region : regions) {
    std::optional<Piece> top;
    for (std::size_t i = 0; i < region.polygon.size(); ++i) {
      const Point &a = region.polygon[i], &b = region.polygon[(i + 1) % region.polygon.size()];
      if (std::min(a[0], b[0]) >= middle || std::max(a[0], b[0]) <= middle) continue;
      const Piece piece{height_on(a, b, left), height_on(a, b, right)};
      if (!top || piece.middle() > top->middle()) top = piece;
    }
    if (top) tops.push_back(*top);
  }
  return tops;
}

std::vector<double> sorted_once(std::vector<double> values) {
  std::ranges::sort(values);
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

}  // namespace

GroundLine::GroundLine(const Domain& domain, const std::vector<Region>& regions)
    : reach_(reach_cells * domain.cell_size) {
  const double left = domain.lower[0], right = domain.upper[0], base = domain.lower[1];
  std::vector<double> corners{left, right};
  for (const Region& region : regions) {
    for (const Point& corner : region.polygon) corners.push_back(std::clamp(corner[0], left, right));
  }
  corners = sorted_once(std::move(corners));
  const auto add = [this](double x, double y) {
    if (points_.empty() || points_.back() != Point{x, y}) points_.push_back({x, y});
  };
  for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
    const double a = corners[k], b = corners[k + 1];
    std::vector<Piece> tops = tops_between(regions, a, b);
    tops.push_back({base, base});
    std::vector<double> shares{0.0, 1.0};  // of the way from a to b, at which another region may become the highest
    for (std::size_t i = 0; i < tops.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const double at_left = tops[i].left - tops[j].left, at_right = tops[i].right - tops[j].right;
        if (at_left * at_right < 0.0) shares.push_back(at_left / (at_left - at_right));
      }
    }
    for (const double share : sorted_once(std::move(shares))) {
      double highest = base;
      for (const Piece& top : tops) highest = std::max(highest, std::lerp(top.left, top.right, share));
      add(std::lerp(a, b, share), highest);
    }
  }
}

double GroundLine::height(double x) const {
  const auto right = std::ranges::lower_bound(points_, x, {}, [](const Point& point) { return point[0]; });
  if (right == points_.end()) return points_.back()[1];
  if (right == points_.begin() || (*right)[0] == x) {
    double highest = (*right)[1];
    for (auto k = right; k != points_.end() && (*k)[0] == (*right)[0]; ++k) highest = std::max(highest, (*k)[1]);
    return highest;
  }
  return height_on(*(right - 1), *right, x);
}

// How far the ground falls from a point on over the reach, as a share of the distance; rises count.
double GroundLine::fall_after(std::size_t point, int step) const {
  const auto count = static_cast<std::ptrdiff_t>(points_.size());
  const double x = points_[point][0], y = points_[point][1];
  auto k = static_cast<std::ptrdiff_t>(point);
  while (k + step >= 0 && k + step < count && std::abs(points_[static_cast<std::size_t>(k)][0] - x) < reach_) k += step;
  const Point& end = points_[static_cast<std::size_t>(k)];
  const double distance = std::abs(end[0] - x);
  if (distance <= reach_) return distance > 0.0 ? (y - end[1]) / distance : never;
  const double target = x + (end[0] > x ? reach_ : -reach_);
  return (y - height_on(points_[static_cast<std::size_t>(k - step)], end, target)) / reach_;
}

std::vector<Point> GroundLine::toes(double x, double direction) const {
  const int step = direction > 0.0 ? 1 : -1;
  const auto count = static_cast<std::ptrdiff_t>(points_.size());
  std::vector<Point> toes;
  std::optional<Point> top;  // where the ground began to fall
  for (std::ptrdiff_t k = step > 0 ? 0 : count - 1; k + step >= 0 && k + step < count; k += step) {
    const Point &here = points_[static_cast<std::size_t>(k)], &next = points_[static_cast<std::size_t>(k + step)];
    if ((next[0] - x) * step < 0.0) continue;
    if (top && here[1] < (*top)[1]) {
      const double distance = std::abs(here[0] - (*top)[0]);
      const double mean = distance > 0.0 ? ((*top)[1] - here[1]) / distance : never;
      if (fall_after(static_cast<std::size_t>(k), step) < std::min(flattest_face, 0.5 * mean)) {
        toes.push_back(here);
        top.reset();
      }
    }
    if (!top && next[1] < here[1]) top = (here[0] - x) * step < 0.0 ? Point{x, height_on(here, next, x)} : here;
    if (top && next[1] >= (*top)[1]) top.reset();
  }
  return toes;
}

namespace {

/// A particle, seen along a direction: how far it reaches, and its height (m).
using Reach = std::array<double, 2>;

/// The toe of the last face that a mass stood on, or if it stood on none as far as its toe, of the next.
std::optional<Point> first_toe(const GroundLine& ground, const std::vector<Reach>& mass, double direction,
                               double spacing) {
  const double rear = std::ranges::min(mass)[0], front = std::ranges::max(mass)[0] + spacing;
  std::optional<Point> toe;
  for (const Point& next : ground.toes(direction * rear, direction)) {
    if (toe && direction * next[0] > front) break;
    toe = next;
  }
  return toe;
}

/// Particles by square cells as wide as the distance within which they hang together.
class Neighbourhood {
 public:
  Neighbourhood(const std::vector<Reach>& soil, double distance) : soil_(soil), distance_(distance) {
    for (std::size_t p = 0; p < soil.size(); ++p) cells_[cell_of(soil[p])].push_back(p);
  }
  /// Calls visit(q) for each particle within the distance of p, p included.
  template <class Visit>
  void for_each_near(std::size_t p, const Visit& visit) const {
    const auto [column, row] = cell_of(soil_[p]);
    for (const double i : {column - 1.0, column, column + 1.0}) {
      for (const double j : {row - 1.0, row, row + 1.0}) {
        const auto cell = cells_.find({i, j});
        if (cell == cells_.end()) continue;
        for (const std::size_t q : cell->second) {
          if (std::hypot(soil_[p][0] - soil_[q][0], soil_[p][1] - soil_[q][1]) < distance_) visit(q);
        }
      }
    }
  }

 private:
  [[nodiscard]] Reach cell_of(const Reach& at) const {
    return {std::floor(at[0] / distance_), std::floor(at[1] / distance_)};
  }
  const std::vector<Reach>& soil_;
  double distance_;
  std::map<Reach, std::vector<std::size_t>> cells_;
};

/// The reach of the foremost particle that is no splash.
double front_of(const std::vector<Reach>& soil, double spacing) {
  const Neighbourhood neighbourhood(soil, link * spacing);
  std::vector<char> seen(soil.size(), 0);
  std::optional<double> front;
  for (std::size_t p = 0; p < soil.size(); ++p) {
    if (seen[p] || (front && soil[p][0] <= *front)) continue;
    std::vector<std::size_t> group{p};  // all that hangs together with p
    seen[p] = 1;
    double foremost = soil[p][0];
    for (std::size_t k = 0; k < group.size(); ++k) {
      foremost = std::max(foremost, soil[group[k]][0]);
      neighbourhood.for_each_near(group[k], [&](std::size_t q) {
        if (!seen[q]) group.push_back(q);
        seen[q] = 1;
      });
    }
    if (group.size() >= splash) front = std::max(front.value_or(foremost), foremost);
  }
  return front.value_or(std::ranges::max(soil)[0]);
}

/// How far ahead of the toe the ground has been pushed up: the reach of the foremost place at which ground that lay
/// there has risen by more than `rise` above the first ground line and gone forward by more than `moved`; none if none.
std::optional<double> front_of_pushed_ground(const solid::Particles& particles, const GroundLine& ground,
                                             const Point& toe, double direction, double spacing, double rise,
                                             double moved) {
  std::vector<Reach> surface;  // reach, and how much it has risen; less than that if it was not pushed
  for (std::size_t p = 0; p < particles.size(); ++p) {
    const double x = particles.x[p] - particles.ux[p], y = particles.y[p] - particles.uy[p];
    if ((x - toe[0]) * direction <= 0.0 || y < ground.height(x) - spacing) continue;
    const double risen = particles.uy[p] - (ground.height(particles.x[p]) - ground.height(x));
    const bool pushed = direction * particles.ux[p] > moved;
    surface.push_back({direction * particles.x[p], pushed ? risen : std::min(risen, 0.0)});
  }
  std::ranges::sort(surface, std::ranges::greater());
  const auto front = std::ranges::find_if(surface, [rise](const Reach& at) { return at[1] > rise; });
  if (front == surface.end()) return std::nullopt;
  if (front == surface.begin()) return (*front)[0];
  const Reach& ahead = *(front - 1);
  return std::lerp((*front)[0], ahead[0], ((*front)[1] - rise) / ((*front)[1] - ahead[1]));
}

}  // namespace

Slide find_slide(const solid::Particles& particles, const GroundLine& ground, const Domain& domain, double spacing,
                 double moved) {
  Slide slide;
  double drift = 0.0;
  for (std::size_t p = 0; p < particles.size(); ++p) {
    slide.largest_horizontal_displacement = std::max(slide.largest_horizontal_displacement, std::abs(particles.ux[p]));
    if (std::hypot(particles.ux[p], particles.uy[p]) <= moved) continue;
    slide.area += particles.volume[p];
    drift += particles.volume[p] * particles.ux[p];
  }
  if (slide.area <= 0.0) return slide;
  slide.direction = drift < 0.0 ? -1.0 : 1.0;
  std::vector<Reach> mass;
  for (std::size_t p = 0; p < particles.size(); ++p) {
    if (slide.direction * particles.ux[p] <= 0.0 || std::hypot(particles.ux[p], particles.uy[p]) <= moved) continue;
    mass.push_back({slide.direction * (particles.x[p] - particles.ux[p]), 0.0});
  }
  if (!mass.empty()) slide.toe = first_toe(ground, mass, slide.direction, spacing);
  if (!slide.toe) {
    slide.run_out.reset();
    return slide;
  }
  // the soil that stood behind the toe and above it
  std::vector<Reach> before, now;
  for (std::size_t p = 0; p < particles.size(); ++p) {
    const double x = particles.x[p] - particles.ux[p], y = particles.y[p] - particles.uy[p];
    if (y <= (*slide.toe)[1] || (x - (*slide.toe)[0]) * slide.direction > 0.0) continue;
    before.push_back({slide.direction * x, y});
    now.push_back({slide.direction * particles.x[p], particles.y[p]});
  }
  if (before.empty()) return slide;
  slide.run_out = std::max(0.0, front_of(now, spacing) - front_of(before, spacing));
  const double rise = std::max(moved, 0.5 * spacing);
  const auto pushed = front_of_pushed_ground(particles, ground, *slide.toe, slide.direction, spacing, rise, moved);
  if (pushed) slide.run_out = std::max(*slide.run_out, *pushed - slide.direction * (*slide.toe)[0]);
  const double wall = slide.direction > 0.0 ? domain.upper[0] : -domain.lower[0];
  slide.reaches_wall = std::ranges::max(now)[0] > wall - domain.cell_size;
  return slide;
}

}  // namespace slope::couple
