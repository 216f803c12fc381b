// Particles to grid and back (paper, Eq. 17).

#include <algorithm>
#include <atomic>
#include <utility>

#include "cells.hpp"
#include "slope/solid/shape_function.hpp"
#include "threads.hpp"

namespace slope::solid {

template <class Shape>
void MaterialPointMethod::find_weights() {
  const double h = grid_.cell_size;
  const double inverse = 1.0 / h;
  const std::size_t n = state_.particles.size();
  std::atomic<bool> all_inside = true;
  for_each_index(n, settings_.threads, [&](std::size_t p) {
    const double px = (state_.particles.x[p] - grid_.lower[0]) * inverse;
    const double py = (state_.particles.y[p] - grid_.lower[1]) * inverse;
    if (!(px >= 0.0 && px < grid_.columns && py >= 0.0 && py < grid_.rows)) {
      all_inside = false;
      return;
    }
    const AxisWeights x = Shape::weights(px, inverse);
    const AxisWeights y = Shape::weights(py, inverse);
    ParticleWeights& w = weights_[p];
    w.node = grid_.node(x.first, y.first);
    w.dx = (x.first - px) * h;
    w.dy = (y.first - py) * h;
    for (std::size_t a = 0; a < 3; ++a) {
      w.nx[a] = x.value[a];
      w.ny[a] = y.value[a];
      w.gx[a] = x.gradient[a];
      w.gy[a] = y.gradient[a];
    }
    const int column = static_cast<int>(px), row = static_cast<int>(py);
    const double right = px - column, up = py - row;
    hat_weights_[p] = {grid_.node(column, row),
                       {(1.0 - right) * (1.0 - up), right * (1.0 - up), (1.0 - right) * up, right * up}};
    grid_cell_of_[p] = std::size_t(row) * std::size_t(grid_.columns) + std::size_t(column);
  });
  if (all_inside) return;
  for (std::size_t p = 0; p < n; ++p) {
    if (!holds_x_of(p) || !holds_y_of(p)) refuse_place(p);
  }
}

template void MaterialPointMethod::find_weights<QuadraticBSpline>();
template void MaterialPointMethod::find_weights<Linear>();

// The integral of a traction t over a face is taken through the body behind it, on the particles that carry the stress:
// with w falling smoothly from one at the face to zero at some depth, N t at the face is the integral of d(N w)/dn t
// over the strip of soil behind. What a particle's quadrature does to the stress it so does to the load as well, and
// soil under uniform load stays uniform wherever its surface lies in the grid.
void MaterialPointMethod::add_tractions(std::span<const ParticleTraction> tractions) {
  constexpr double depth_in_cells = 3.0;
  const double spacing = settings_.particle_spacing;
  const std::size_t columns = std::size_t(grid_.node_columns());
  for (const ParticleTraction& traction : tractions) {
    const double distance = std::hypot(traction.face_x, traction.face_y);
    const double nx = distance > 0.0 ? traction.face_x / distance : 0.0;
    const double ny = distance > 0.0 ? traction.face_y / distance : 0.0;
    find_strip(traction, nx, ny, depth_in_cells * grid_.cell_size);
    double depth = 0.0;
    for (const Behind& q : strip_) depth += state_.particles.volume[q.particle] / spacing;
    const auto fade = [depth](double behind) {
      const double t = std::clamp(behind / depth, 0.0, 1.0);
      return 1.0 - t * t * (3.0 - 2.0 * t);
    };
    // what w falls by over a particle's height is its share of the load
    double sum = 0.0;
    for (Behind& q : strip_) {
      const double half = 0.5 * state_.particles.volume[q.particle] / spacing;
      q.share = strip_.size() == 1 ? 1.0 : fade(q.distance - half) - fade(q.distance + half);
      sum += q.share;
    }
    const Eigen::Array2d force = spacing * Eigen::Array2d(traction.x, traction.y);
    for (const Behind& q : strip_) {
      const ParticleWeights& w = weights_[q.particle];
      const double height = state_.particles.volume[q.particle] / spacing * fade(q.distance);
      for (std::size_t b = 0; b < 3; ++b) {
        for (std::size_t a = 0; a < 3; ++a) {
          const double slope = nx * w.gx[a] * w.ny[b] + ny * w.nx[a] * w.gy[b];
          node_[w.node + b * columns + a].force += (height * slope + q.share / sum * w.nx[a] * w.ny[b]) * force;
        }
      }
    }
  }
}

// The particles behind the face of a traction, no deeper than a limit. A traction that acts at its particle has no
// face, and nothing behind it.
void MaterialPointMethod::find_strip(const ParticleTraction& traction, double nx, double ny, double limit) {
  strip_.clear();
  const double spacing = settings_.particle_spacing;
  const double x = state_.particles.x[traction.particle] + traction.face_x;
  const double y = state_.particles.y[traction.particle] + traction.face_y;
  strip_.push_back({traction.particle, std::hypot(traction.face_x, traction.face_y), 0.0});
  if (nx == 0.0 && ny == 0.0) return;
  const double half = 0.5 * spacing * (1.0 - 1.0e-6);
  const auto cell_at = [&](double position, double lower, int cells) {
    return std::clamp(static_cast<int>((position - lower) / grid_.cell_size), 0, cells - 1);
  };
  const double far_x = x - limit * nx, far_y = y - limit * ny;
  const double wide_x = std::abs(ny) * half, wide_y = std::abs(nx) * half;
  const int left = cell_at(std::min(x, far_x) - wide_x, grid_.lower[0], grid_.columns);
  const int right = cell_at(std::max(x, far_x) + wide_x, grid_.lower[0], grid_.columns);
  const int low = cell_at(std::min(y, far_y) - wide_y, grid_.lower[1], grid_.rows);
  const int high = cell_at(std::max(y, far_y) + wide_y, grid_.lower[1], grid_.rows);
  for (int row = low; row <= high; ++row) {
    for (int column = left; column <= right; ++column) {
      for (const std::size_t p : particles_in(grid_.cell(column, row))) {
        if (p == traction.particle) continue;
        const double dx = x - state_.particles.x[p], dy = y - state_.particles.y[p];
        const double behind = nx * dx + ny * dy;
        if (behind > 0.0 && behind < limit && std::abs(ny * dx - nx * dy) < half) strip_.push_back({p, behind, 0.0});
      }
    }
  }
}

void MaterialPointMethod::sort_into_cells() {
  constexpr std::size_t rows_per_band = 3;  // a cell reaches the nodes of the cells beside it, see for_each_cell()
  const std::size_t columns = std::size_t(grid_.columns);
  std::fill(cell_start_.begin(), cell_start_.end(), 0);
  for (const std::size_t cell : grid_cell_of_) ++cell_start_[cell];
  cells_.clear();
  bands_.clear();
  std::size_t first = 0;
  for (std::size_t cell = 0; cell < grid_.cell_count(); ++cell) {
    if (cell % (rows_per_band * columns) == 0) bands_.push_back(cells_.size());
    const std::size_t count = std::exchange(cell_start_[cell], first);
    if (count == 0) continue;
    const int column = static_cast<int>(cell % columns);
    const int row = static_cast<int>(cell / columns);
    cells_.push_back({grid_.node(column, row), first});
    first += count;
  }
  bands_.push_back(cells_.size());
  cells_.push_back({0, first});
  for (std::size_t p = 0; p < grid_cell_of_.size(); ++p) cell_particles_[cell_start_[grid_cell_of_[p]]++] = p;
}

void MaterialPointMethod::scatter(const PoreState& pore, const SurfacePressure& surface,
                                  const Eigen::Array2d& acceleration) {
  using Eigen::Array2d;
  const std::size_t columns = std::size_t(grid_.node_columns());
  const double h = grid_.cell_size;
  const bool affine = settings_.flip_fraction < 0.0;
  const bool own_pressure = !settings_.averages_pressure && !pore.pressure.empty();
  std::fill(node_.begin(), node_.end(), Node{Array2d::Zero(), Array2d::Zero(), 0.0});
  for_each_cell([&](std::size_t c) {
    for (std::size_t s = cells_[c].particle; s < cells_[c + 1].particle; ++s) {
      const std::size_t p = cell_particles_[s];
      const ParticleWeights w = weights_[p];
      const double mass = state_.particles.solid_mass[p] + (pore.water_mass.empty() ? 0.0 : pore.water_mass[p]);
      mass_[p] = mass;
      const double volume = state_.particles.volume[p];
      // momentum at node (a, b): corner + a along_row + b along_column
      Array2d corner = mass * Array2d(state_.particles.vx[p], state_.particles.vy[p]);
      Array2d along_row = Array2d::Zero(), along_column = Array2d::Zero();
      if (affine) {
        const Array2d cx = mass * Array2d(state_.particles.cxx[p], state_.particles.cyx[p]);
        const Array2d cy = mass * Array2d(state_.particles.cxy[p], state_.particles.cyy[p]);
        corner += cx * w.dx + cy * w.dy;
        along_row = h * cx;
        along_column = h * cy;
      }
      const double pressure = own_pressure ? pore.pressure[p] : 0.0;
      const Array2d stress_x = -volume * Array2d(state_.particles.sxx[p] - pressure, state_.particles.sxy[p]);
      const Array2d stress_y = -volume * Array2d(state_.particles.sxy[p], state_.particles.syy[p] - pressure);
      Array2d weight = mass * acceleration;
      if (!surface.pressure.empty()) weight -= volume * Array2d(surface.gradient_x[p], surface.gradient_y[p]);
      Node* row = node_.data() + w.node;
      for (int b = 0; b < 3; ++b, row += columns) {
        const double row_mass = w.ny[b] * mass;
        const Array2d row_momentum = w.ny[b] * (corner + b * along_column);
        const Array2d row_slope = w.ny[b] * along_row;
        const Array2d row_force = w.ny[b] * weight + w.gy[b] * stress_y;
        const Array2d row_stress = w.ny[b] * stress_x;
        for (int a = 0; a < 3; ++a) {
          row[a].momentum += w.nx[a] * (row_momentum + a * row_slope);
          row[a].force += w.nx[a] * row_force + w.gx[a] * row_stress;
          row[a].mass += w.nx[a] * row_mass;
        }
      }
    }
  });
}

namespace {

// Steps over which losses are averaged before they are given back: ten of them see a cell vibrate four times.
constexpr double loss_memory = 20.0;

// A velocity field of the grid as a particle sees it: sum N v, and sum N v (x_i - x_p) along x and y.
struct Moments {
  Eigen::Array2d value = Eigen::Array2d::Zero(), x = Eigen::Array2d::Zero(), y = Eigen::Array2d::Zero();

  // Adds row b of the particle's nodes; the arm is dx + a h along it and dy + b h across.
  template <class Weights>
  void add_row(const Weights& w, int b, double h, const Eigen::Array2d* v) {
    const Eigen::Array2d along = w.nx[0] * v[0] + w.nx[1] * v[1] + w.nx[2] * v[2];
    value += w.ny[b] * along;
    x += w.ny[b] * (w.dx * along + h * (w.nx[1] * v[1] + 2.0 * w.nx[2] * v[2]));
    y += w.ny[b] * (w.dy + b * h) * along;
  }
};

}  // namespace

template <MaterialPointMethod::Transfer transfer>
void MaterialPointMethod::gather(double dt, const StepMode& mode) {
  using Eigen::Array2d;
  const std::size_t columns = std::size_t(grid_.node_columns());
  const double h = grid_.cell_size;
  const double affine_scale = 4.0 / (h * h);
  const bool linear = settings_.shape_function == ShapeFunction::linear;
  const double flip = settings_.flip_fraction;
  Particles& f = state_.particles;
  for_each_index(f.size(), settings_.threads, [&](std::size_t p) {
    const ParticleWeights& w = weights_[p];
    Moments after, before;
    Array2d gradient_x = Array2d::Zero(), gradient_y = Array2d::Zero();
    std::size_t node = w.node;
    for (int b = 0; b < 3; ++b, node += columns) {
      const Array2d* v = velocity_.data() + node;
      gradient_x += w.ny[b] * (w.gx[0] * v[0] + w.gx[1] * v[1] + w.gx[2] * v[2]);
      gradient_y += w.gy[b] * (w.nx[0] * v[0] + w.nx[1] * v[1] + w.nx[2] * v[2]);
      after.add_row(w, b, h, v);
      if constexpr (transfer != Transfer::apic) before.add_row(w, b, h, old_velocity_.data() + node);
    }
    velocity_gradient_[p] = {gradient_x.x(), gradient_y.x(), gradient_x.y(), gradient_y.y()};
    if constexpr (transfer == Transfer::flip) {
      f.vx[p] = flip * (f.vx[p] + after.value.x() - before.value.x()) + (1.0 - flip) * after.value.x();
      f.vy[p] = flip * (f.vy[p] + after.value.y() - before.value.y()) + (1.0 - flip) * after.value.y();
    } else if constexpr (transfer == Transfer::apic) {
      f.vx[p] = after.value.x();
      f.vy[p] = after.value.y();
      if (!linear) {
        f.cxx[p] = affine_scale * after.x.x();
        f.cyx[p] = affine_scale * after.x.y();
        f.cxy[p] = affine_scale * after.y.x();
        f.cyy[p] = affine_scale * after.y.y();
      }
    } else {
      const bool keeps = !beside_absorbing_wall_[grid_cell_of_[p]];
      const auto restore = [&](double& moved, double& lost, double now, double kept) {
        lost = keeps ? lost + (moved - kept - lost) / loss_memory : 0.0;
        moved = now + mode.restored_losses * lost;
      };
      restore(f.vx[p], f.lost_vx[p], after.value.x(), before.value.x());
      restore(f.vy[p], f.lost_vy[p], after.value.y(), before.value.y());
      restore(f.cxx[p], f.lost_cxx[p], affine_scale * after.x.x(), affine_scale * before.x.x());
      restore(f.cyx[p], f.lost_cyx[p], affine_scale * after.x.y(), affine_scale * before.x.y());
      restore(f.cxy[p], f.lost_cxy[p], affine_scale * after.y.x(), affine_scale * before.y.x());
      restore(f.cyy[p], f.lost_cyy[p], affine_scale * after.y.y(), affine_scale * before.y.y());
    }
    if (mode.moves) {
      f.x[p] += dt * after.value.x();
      f.y[p] += dt * after.value.y();
      f.ux[p] += dt * after.value.x();
      f.uy[p] += dt * after.value.y();
    }
  });
}

template void MaterialPointMethod::gather<MaterialPointMethod::Transfer::flip>(double, const StepMode&);
template void MaterialPointMethod::gather<MaterialPointMethod::Transfer::apic>(double, const StepMode&);
template void MaterialPointMethod::gather<MaterialPointMethod::Transfer::restoring_apic>(double, const StepMode&);

// Linear shape functions: the gradient does not vanish with the shape function, so a node that a particle just touches
// would strain the soil without bound. The strain therefore comes from the particles' new velocities, mapped to the
// grid once more ("modified update stress last", Sulsky et al. 1995); so does the affine field, which over hat
// functions is the velocity gradient itself.
void MaterialPointMethod::remap_velocity() {
  using Eigen::Array2d;
  const std::size_t columns = std::size_t(grid_.node_columns());
  const bool affine = settings_.flip_fraction < 0.0;
  std::fill(velocity_.begin(), velocity_.end(), Array2d::Zero());
  for_each_cell([&](std::size_t c) {
    for (std::size_t s = cells_[c].particle; s < cells_[c + 1].particle; ++s) {
      const std::size_t p = cell_particles_[s];
      const ParticleWeights& w = weights_[p];
      const Array2d momentum = mass_[p] * Array2d(state_.particles.vx[p], state_.particles.vy[p]);
      for (std::size_t b = 0; b < 2; ++b) {
        for (std::size_t a = 0; a < 2; ++a) velocity_[w.node + b * columns + a] += w.nx[a] * w.ny[b] * momentum;
      }
    }
  });
  for (std::size_t i = 0; i < node_.size(); ++i) {
    velocity_[i] = (response_[i] > 0.0).select(velocity_[i] / node_[i].mass, 0.0);
  }
  for_each_index(state_.particles.size(), settings_.threads, [&](std::size_t p) {
    const ParticleWeights& w = weights_[p];
    const Array2d* v = velocity_.data() + w.node;
    const Array2d* above = v + columns;
    const Array2d x = w.gx[0] * (w.ny[0] * v[0] + w.ny[1] * above[0]) + w.gx[1] * (w.ny[0] * v[1] + w.ny[1] * above[1]);
    const Array2d y = w.gy[0] * (w.nx[0] * v[0] + w.nx[1] * v[1]) + w.gy[1] * (w.nx[0] * above[0] + w.nx[1] * above[1]);
    velocity_gradient_[p] = {x.x(), y.x(), x.y(), y.y()};
    if (affine) {
      state_.particles.cxx[p] = x.x();
      state_.particles.cyx[p] = x.y();
      state_.particles.cxy[p] = y.x();
      state_.particles.cyy[p] = y.y();
    }
  });
}

}  // namespace slope::solid
