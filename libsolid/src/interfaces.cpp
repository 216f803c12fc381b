// Where soils meet. The traction on the face between them is the same from both sides, so within half a cell of it no
// soil bears more along the face than the other does. The grid cannot let one soil slide along another without shearing
// both over a cell: without that bound the stronger one would hold the weaker.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "cells.hpp"
#include "slope/solid/material_point_method.hpp"
#include "threads.hpp"

namespace slope::solid {

namespace {

// What a soil bears along a plane on which it slides (Pa). A law that is not known by that sets no bound.
struct BorneAlongSlip {
  double suction, plastic_strain;
  double normal_stress;  // effective (Pa)

  double operator()(const NoYield& /*none*/) const { return std::numeric_limits<double>::infinity(); }
  template <class Law>
  double operator()(const Law& law) const {
    if constexpr (LawWithState<Law>) {
      return std::numeric_limits<double>::infinity();
    } else {
      return std::max(law.at(suction, plastic_strain).shear_along_slip(normal_stress), 0.0);
    }
  }
};

constexpr double reach = 0.5;   // cells, up to the near side of a particle of the other soil
constexpr double window = 1.5;  // cells to all sides in which the direction of a face is seen
constexpr int cells_in_reach = 1, cells_in_window = 2;
// A face is none where other soil lies to either side alike: of its slope, the share over the window (-).
constexpr double least_slope = 0.1;

// Where another soil lies around a particle: the slope of its indicator, 1 in it and 0 elsewhere, by least squares
// over the window, which sees a plane face as it is at the end of the soil too.
class IndicatorSlope {
 public:
  void add(double dx, double dy, double weight, bool other) {
    sum_ += weight;
    x_ += weight * dx, y_ += weight * dy;
    xx_ += weight * dx * dx, xy_ += weight * dx * dy, yy_ += weight * dy * dy;
    if (!other) return;
    other_ += weight;
    other_x_ += weight * dx, other_y_ += weight * dy;
  }
  // (1/m); zero where the particles lie on a line
  [[nodiscard]] std::array<double, 2> value() const {
    const double xx = xx_ - x_ * x_ / sum_, xy = xy_ - x_ * y_ / sum_, yy = yy_ - y_ * y_ / sum_;
    const double x = other_x_ - other_ * x_ / sum_, y = other_y_ - other_ * y_ / sum_;
    const double determinant = xx * yy - xy * xy;
    if (!(determinant > 1.0e-6 * xx * yy)) return {0.0, 0.0};
    return {(yy * x - xy * y) / determinant, (xx * y - xy * x) / determinant};
  }

 private:
  double sum_ = 0.0, x_ = 0.0, y_ = 0.0, xx_ = 0.0, xy_ = 0.0, yy_ = 0.0;
  double other_ = 0.0, other_x_ = 0.0, other_y_ = 0.0;
};

}  // namespace

// The particles within reach of another soil, with the nearest particle of one and the direction of the face.
void MaterialPointMethod::find_neighbours_of_other_soil() {
  beside_.clear();
  if (kinds_ < 2) return;
  const Particles& all = state_.particles;
  constexpr std::size_t none = ~std::size_t{0}, several = none - 1;
  kind_in_cell_.assign(grid_.cell_count(), none);
  for (std::size_t p = 0; p < all.size(); ++p) {
    std::size_t& kind = kind_in_cell_[grid_cell_of_[p]];
    kind = kind == none || kind == kind_of(p) ? kind_of(p) : several;
  }
  const double h = grid_.cell_size;
  const auto for_each_cell_around = [&](int column, int row, int width, const auto& visit) {
    for (int j = std::max(row - width, 0); j <= std::min(row + width, grid_.rows - 1); ++j) {
      for (int i = std::max(column - width, 0); i <= std::min(column + width, grid_.columns - 1); ++i) {
        if (kind_in_cell_[grid_.cell(i, j)] != none) visit(grid_.cell(i, j));
      }
    }
  };
  std::vector<std::size_t> others;  // cells beside that hold another soil
  for (int row = 0; row < grid_.rows; ++row) {
    for (int column = 0; column < grid_.columns; ++column) {
      const std::size_t cell = grid_.cell(column, row);
      if (kind_in_cell_[cell] == none) continue;
      others.clear();
      for_each_cell_around(column, row, cells_in_reach, [&](std::size_t c) {
        if (kind_in_cell_[c] == several || kind_in_cell_[c] != kind_in_cell_[cell]) others.push_back(c);
      });
      if (others.empty()) continue;
      for (const std::size_t p : particles_in(cell)) {
        std::size_t nearest = p;
        double least_gap = reach * h;
        for (const std::size_t c : others) {
          for (const std::size_t q : particles_in(c)) {
            if (kind_of(q) == kind_of(p)) continue;
            const double gap = std::hypot(all.x[q] - all.x[p], all.y[q] - all.y[p]) - 0.5 * std::sqrt(all.volume[q]);
            if (gap >= least_gap) continue;
            least_gap = gap;
            nearest = q;
          }
        }
        if (nearest == p) continue;
        IndicatorSlope slope;
        for_each_cell_around(column, row, cells_in_window, [&](std::size_t c) {
          for (const std::size_t q : particles_in(c)) {
            const double dx = all.x[q] - all.x[p], dy = all.y[q] - all.y[p];
            const double near = std::max(window * h - std::abs(dx), 0.0) * std::max(window * h - std::abs(dy), 0.0);
            if (near > 0.0) slope.add(dx, dy, near * all.volume[q], kind_of(q) != kind_of(p));
          }
        });
        const auto [nx, ny] = slope.value();
        const double length = std::hypot(nx, ny);
        if (length * window * h < least_slope) continue;
        beside_.push_back({p, nearest, nx / length, ny / length});
      }
    }
  }
}

void MaterialPointMethod::bound_traction_between_soils(std::span<const double> suction) {
  Particles& all = state_.particles;
  for_each_index(beside_.size(), settings_.threads, [&](std::size_t k) {
    const auto& [p, other, nx, ny] = beside_[k];
    const double normal = all.sxx[p] * nx * nx + all.syy[p] * ny * ny + 2.0 * all.sxy[p] * nx * ny;
    const double shear = (all.syy[p] - all.sxx[p]) * nx * ny + all.sxy[p] * (nx * nx - ny * ny);
    const auto borne_by = [&](std::size_t q) {
      const BorneAlongSlip borne{suction.empty() ? 0.0 : suction[q], all.plastic_strain[q], normal};
      return std::visit(borne, materials_[all.soil[q]].strength);
    };
    const double most = borne_by(other);
    if (std::abs(shear) <= most || borne_by(p) <= most) return;
    // only the shear along the face goes; the stresses normal to it and along it stay
    const double lost = shear - std::copysign(most, shear);
    all.sxx[p] += 2.0 * nx * ny * lost;
    all.syy[p] -= 2.0 * nx * ny * lost;
    all.sxy[p] -= (nx * nx - ny * ny) * lost;
  });
}

}  // namespace slope::solid
