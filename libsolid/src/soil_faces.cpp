#include "slope/solid/soil_faces.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace slope::solid {

namespace {

// All in cells.
constexpr double near = 0.5;         // what a particle is from a face that it is close to, however thick the layer
constexpr double band = 5.0;         // what a slip takes on this grid: that far a thin layer counts, half to each side
constexpr double widest_gap = 0.75;  // between particles that touch
constexpr double past_the_end = 0.5;
constexpr double rough_window = 1.5, line_window = 4.0;

constexpr std::size_t several = SoilFaces::none - 1;

struct CellRange {
  int first_column, last_column, first_row, last_row;
};

// The cells that a square about a place reaches.
CellRange cells_around(const Grid& grid, double x, double y, double distance) {
  const auto at = [&](double coordinate, double lower, int count) {
    return static_cast<int>(std::clamp(std::floor((coordinate - lower) / grid.cell_size), 0.0, count - 1.0));
  };
  return {at(x - distance, grid.lower[0], grid.columns), at(x + distance, grid.lower[0], grid.columns),
          at(y - distance, grid.lower[1], grid.rows), at(y + distance, grid.lower[1], grid.rows)};
}

template <class Visit>
void for_each_cell(const Grid& grid, const CellRange& range, const Visit& visit) {
  for (int row = range.first_row; row <= range.last_row; ++row) {
    for (int column = range.first_column; column <= range.last_column; ++column) visit(grid.cell(column, row));
  }
}

// The cells that a strip reaches from a place along a direction, so far back and ahead and to either side.
template <class Visit>
void for_each_cell_along(const Grid& grid, const Eigen::Vector2d& place, const Eigen::Vector2d& direction, double back,
                         double ahead, double aside, const Visit& visit) {
  const double h = grid.cell_size, half_diagonal = h / std::numbers::sqrt2;
  const CellRange range = cells_around(grid, place[0], place[1], std::hypot(std::max(back, ahead), aside));
  for (int row = range.first_row; row <= range.last_row; ++row) {
    for (int column = range.first_column; column <= range.last_column; ++column) {
      const double x = grid.lower[0] + (column + 0.5) * h - place[0], y = grid.lower[1] + (row + 0.5) * h - place[1];
      const double along = x * direction[0] + y * direction[1];
      if (std::abs(x * direction[1] - y * direction[0]) > aside + half_diagonal) continue;
      if (along > -back - half_diagonal && along < ahead + half_diagonal) visit(grid.cell(column, row));
    }
  }
}

template <class Visit>
void for_each_particle(const SoilFaces::ByCell& by_cell, std::size_t cell, const Visit& visit) {
  for (std::size_t k = cell == 0 ? 0 : by_cell.end[cell - 1]; k < by_cell.end[cell]; ++k) visit(by_cell.particles[k]);
}

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a[0] * b[1] - a[1] * b[0];
}

Eigen::Vector2d place(const Particles& particles, std::size_t p) {
  return {particles.x[p], particles.y[p]};
}

// The straight line through points, by total least squares.
class Line {
 public:
  void add(const Eigen::Vector2d& x, const Eigen::Vector2d& rough_normal, double weight) {
    weight_ += weight;
    mean_ += weight * x;
    square_ += weight * x * x.transpose();
    normal_ += weight * rough_normal;
  }
  [[nodiscard]] Eigen::Vector2d foot() const { return mean_ / weight_; }
  // The mean of the rough ones where the points lie on no line.
  [[nodiscard]] Eigen::Vector2d normal() const {
    constexpr double slender = 0.5;       // least difference of the principal moments, of their sum
    constexpr double least_cosine = 0.7;  // of the angle to the rough one
    const Eigen::Matrix2d moment = square_ / weight_ - foot() * foot().transpose();
    const double twice_xy = 2.0 * moment(0, 1), difference = moment(0, 0) - moment(1, 1);
    const double along = 0.5 * std::atan2(twice_xy, difference);
    const Eigen::Vector2d rough = normal_.normalized();
    Eigen::Vector2d normal{-std::sin(along), std::cos(along)};
    if (normal.dot(rough) < 0.0) normal = -normal;
    if (std::hypot(difference, twice_xy) <= slender * moment.trace() || normal.dot(rough) < least_cosine) return rough;
    return normal;
  }

 private:
  double weight_ = 0.0;
  Eigen::Vector2d mean_ = Eigen::Vector2d::Zero(), normal_ = Eigen::Vector2d::Zero();
  Eigen::Matrix2d square_ = Eigen::Matrix2d::Zero();
};

}  // namespace

template <class Visit>
void SoilFaces::for_each_point_around(const Grid& grid, const Point& point, double distance, const Visit& visit) const {
  for_each_cell(grid, cells_around(grid, point.x[0], point.x[1], distance), [&](std::size_t cell) {
    for (std::size_t k = first_point_[cell]; k != none; k = points_[k].next) visit(points_[k]);
  });
}

void SoilFaces::find(const Grid& grid, const ByCell& by_cell, const Particles& particles, std::size_t kinds) {
  points_.clear();
  beside_.clear();
  particles_beside_.clear();
  if (kinds < 2) return;
  kinds_ = kinds;
  first_beside_.assign(particles.size(), none);
  mark_cells(grid, by_cell, particles);
  pair_up(grid, by_cell, particles);
  draw_lines(grid);
  measure_layers(grid, particles);
  gather(grid, by_cell, particles);
}

void SoilFaces::mark_cells(const Grid& grid, const ByCell& by_cell, const Particles& particles) {
  kind_in_cell_.assign(grid.cell_count(), none);
  for (std::size_t cell = 0; cell < grid.cell_count(); ++cell) {
    for_each_particle(by_cell, cell, [&](std::size_t p) {
      const std::size_t kind = particles.soil[p] % kinds_;
      std::size_t& marked = kind_in_cell_[cell];
      marked = marked == none || marked == kind ? kind : several;
    });
  }
}

// A point between each particle that touches another soil and the nearest one of that.
void SoilFaces::pair_up(const Grid& grid, const ByCell& by_cell, const Particles& particles) {
  first_point_.assign(grid.cell_count(), none);
  least_square_.assign(particles.size(), std::numeric_limits<double>::infinity());
  partner_.assign(particles.size(), none);
  point_of_.resize(particles.size());
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const std::size_t cell = grid.cell(column, row);
      const std::size_t kind_here = kind_in_cell_[cell];
      if (kind_here == none) continue;
      bool one_kind = true;
      const CellRange beside{std::max(column - 1, 0), std::min(column + 1, grid.columns - 1), std::max(row - 1, 0),
                             std::min(row + 1, grid.rows - 1)};
      for_each_cell(grid, beside, [&](std::size_t c) {
        one_kind = one_kind && (kind_in_cell_[c] == none || kind_in_cell_[c] == kind_here);
      });
      if (one_kind && kind_here != several) continue;
      for_each_particle(by_cell, cell, [&](std::size_t p) {
        const Eigen::Vector2d at = place(particles, p);
        const double widest = std::max(widest_gap * grid.cell_size, 1.5 * std::sqrt(particles.volume[p]));
        std::size_t nearest = none;
        double least = widest * widest;
        for_each_cell(grid, beside, [&](std::size_t c) {
          if (kind_in_cell_[c] == particles.soil[p] % kinds_) return;
          for_each_particle(by_cell, c, [&](std::size_t q) {
            if (particles.soil[q] % kinds_ == particles.soil[p] % kinds_) return;
            const double distance = (place(particles, q) - at).squaredNorm();
            if (distance >= least) return;
            least = distance;
            nearest = q;
          });
        });
        if (nearest == none || least == 0.0) return;
        least_square_[p] = least;
        partner_[p] = nearest;
        if (partner_[nearest] == p) {
          points_[point_of_[nearest]].weight = 2.0;
          return;
        }
        point_of_[p] = points_.size();
        std::array<std::size_t, 2> sides{p, nearest};
        std::ranges::sort(sides, {}, [&](std::size_t q) { return particles.soil[q] % kinds_; });
        Point point;
        point.particle = sides;
        point.kind = {particles.soil[sides[0]] % kinds_, particles.soil[sides[1]] % kinds_};
        point.weight = 1.0;
        point.x = 0.5 * (place(particles, sides[0]) + place(particles, sides[1]));
        point.pair_normal = (place(particles, sides[1]) - place(particles, sides[0])).normalized();
        points_.push_back(point);
      });
    }
  }
  // across a face that stands askew to the lattice a second row sees the first one of the other soil
  std::erase_if(points_, [&](const Point& point) {
    constexpr double farther = 1.2;
    const auto [a, b] = point.particle;
    return std::max(least_square_[a], least_square_[b]) >
           farther * farther * std::min(least_square_[a], least_square_[b]);
  });
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const CellRange at = cells_around(grid, points_[k].x[0], points_[k].x[1], 0.0);
    std::size_t& first = first_point_[grid.cell(at.first_column, at.first_row)];
    points_[k].next = first;
    first = k;
  }
}

// Through points of one side of a layer: those of the other side have turned normals.
void SoilFaces::draw_lines(const Grid& grid) {
  const auto for_each_like = [&](const Point& point, double window, const auto& visit) {
    for_each_point_around(grid, point, window, [&](const Point& other) {
      const double square = (other.x - point.x).squaredNorm();
      if (square >= window * window || other.kind != point.kind) return;
      const double distance = std::sqrt(square);
      visit(other, other.weight * (1.0 - distance / window));
    });
  };
  for (Point& point : points_) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for_each_like(point, rough_window * grid.cell_size, [&](const Point& other, double weight) {
      constexpr double least_cosine = -0.1;  // pairs at a step of the lattice stand at right angles
      if (other.pair_normal.dot(point.pair_normal) >= least_cosine) sum += weight * other.pair_normal;
    });
    point.rough_normal = sum.squaredNorm() > 0.0 ? sum.normalized() : point.pair_normal;
  }
  for (Point& point : points_) {
    Line line;
    for_each_like(point, line_window * grid.cell_size, [&](const Point& other, double weight) {
      constexpr double least_cosine = 0.5;
      if (other.rough_normal.dot(point.rough_normal) >= least_cosine)
        line.add(other.x - point.x, other.rough_normal, weight);
    });
    point.normal = line.normal();
    point.foot = point.x + point.normal.dot(line.foot()) * point.normal;
  }
}

// Of the layer on either side of each point, as far as the band reaches.
void SoilFaces::measure_layers(const Grid& grid, const Particles& particles) {
  for (Point& point : points_) {
    const double spacing = std::sqrt(particles.volume[point.particle[0]]);
    const double aside = std::max(0.5 * grid.cell_size, spacing);
    const auto look_at = [&](const Point& other) {
      const Eigen::Vector2d between = other.foot - point.foot;
      if (std::abs(cross(between, point.normal)) > aside) return;
      for (const std::size_t side : {0U, 1U}) {
        const double out = side == 0 ? -1.0 : 1.0;  // of the point's face, into the layer
        const double thickness = out * between.dot(point.normal);
        if (thickness < 0.5 * spacing || thickness >= point.thickness[side]) continue;
        for (const std::size_t inner : {0U, 1U}) {
          const double outer = inner == 0 ? 1.0 : -1.0;  // of the other's normal, out of the layer
          constexpr double least_cosine = 0.5;
          if (other.kind[inner] != point.kind[side]) continue;
          if (outer * out * other.normal.dot(point.normal) < least_cosine) continue;
          point.thickness[side] = thickness;
          point.beyond[side] = other.particle[1 - inner];
        }
      }
    };
    const double far = band * grid.cell_size;
    for_each_cell_along(grid, point.foot, point.normal, far, far, aside, [&](std::size_t cell) {
      for (std::size_t k = first_point_[cell]; k != none; k = points_[k].next) look_at(points_[k]);
    });
  }
}

void SoilFaces::gather(const Grid& grid, const ByCell& by_cell, const Particles& particles) {
  const double h = grid.cell_size;
  for (const Point& point : points_) {
    for (const std::size_t side : {0U, 1U}) {
      const Eigen::Vector2d normal = side == 0 ? point.normal : -point.normal;
      const double spacing = std::sqrt(particles.volume[point.particle[side]]);
      const double closest = std::max(near * h, 0.75 * spacing), aside = past_the_end * h + 0.5 * spacing;
      const double reach = std::max(closest, 0.5 * (band * h - point.thickness[1 - side]));
      for_each_cell_along(grid, point.foot, normal, reach, 0.5 * spacing, aside, [&](std::size_t cell) {
        if (kind_in_cell_[cell] != several && kind_in_cell_[cell] != point.kind[side]) return;
        for_each_particle(by_cell, cell, [&](std::size_t p) {
          if (particles.soil[p] % kinds_ != point.kind[side]) return;
          const Eigen::Vector2d between = point.foot - place(particles, p);
          const double gap = between.dot(normal);
          if (gap < -0.5 * spacing || gap > reach || std::abs(cross(between, normal)) > aside) return;
          const Beside found{point.particle[1 - side], point.beyond[1 - side], normal, std::max(gap, 0.0),
                             between.norm(),           gap <= closest,         none};
          // of the faces of one soil, the nearest
          std::size_t k = first_beside_[p];
          while (k != none && particles.soil[beside_[k].other] % kinds_ != point.kind[1 - side]) k = beside_[k].next;
          if (k != none) {
            const std::size_t next = beside_[k].next;
            if (found.distance < beside_[k].distance) beside_[k] = found, beside_[k].next = next;
            return;
          }
          if (first_beside_[p] == none) particles_beside_.push_back(p);
          beside_.push_back(found);
          beside_.back().next = first_beside_[p];
          first_beside_[p] = beside_.size() - 1;
        });
      });
    }
  }
}

}  // namespace slope::solid
