// The pore pressure's force on the grid and the grid's volume change, both through cell averages and with the same
// coefficients: B_c = sum over the particles of cell c of V_p G_ip, wall conditions folded in.

#include <algorithm>

#include "slope/solid/material_point_method.hpp"

namespace slope::solid {

void MaterialPointMethod::sum_cell_gradients() {
  const std::size_t columns = std::size_t(grid_.node_columns());
  cell_gradient_.resize(active_cells_.size());
  cell_volume_.resize(active_cells_.size());
  cell_value_.resize(active_cells_.size());
#pragma omp parallel for schedule(static) num_threads(settings_.threads) if (settings_.threads > 1)
  for (std::size_t c = 0; c < active_cells_.size(); ++c) {
    CellGradient& gradient = cell_gradient_[c];
    std::fill(gradient.x, gradient.x + 16, 0.0);
    std::fill(gradient.y, gradient.y + 16, 0.0);
    double volume = 0.0;
    const std::size_t first = cell_first_node(c);
    for (std::size_t s = cell_start_[c]; s < cell_start_[c + 1]; ++s) {
      const std::size_t p = cell_particles_[s];
      cell_of_[p] = c;
      const ParticleWeights& w = weights_[p];
      const double v = particles_.volume[p];
      volume += v;
      // where the particle's 3 x 3 nodes lie among the cell's 4 x 4
      const std::size_t offset = w.node - first;
      const std::size_t shift = (offset / columns) * 4 + offset % columns;
      for (int b = 0; b < 3; ++b) {
        for (int a = 0; a < 3; ++a) {
          const std::size_t k = shift + std::size_t(4 * b + a);
          gradient.x[k] += v * w.gx[a] * w.ny[b];
          gradient.y[k] += v * w.nx[a] * w.gy[b];
        }
      }
    }
    cell_volume_[c] = volume;
    // wall conditions, as in fold_walls(): index 0 or 3 may lie outside, its mirror image is 2 or 1
    const auto fold = [](double* g, std::size_t outside, std::size_t inside, double sign) {
      g[inside] += sign * g[outside];
      g[outside] = 0.0;
    };
    const auto tangential = [](Wall wall) { return wall == Wall::fixed ? -1.0 : 1.0; };
    const std::size_t column = active_cells_[c] % std::size_t(grid_.columns);
    const std::size_t row = active_cells_[c] / std::size_t(grid_.columns);
    if (row == 0 && grid_.walls.base != Wall::free) {
      for (std::size_t a = 0; a < 4; ++a) {
        fold(gradient.x, a, 8 + a, tangential(grid_.walls.base));
        fold(gradient.y, a, 8 + a, -1.0);
      }
    }
    if (column == 0 && grid_.walls.left != Wall::free) {
      for (std::size_t b = 0; b < 16; b += 4) {
        fold(gradient.x, b, b + 2, -1.0);
        fold(gradient.y, b, b + 2, tangential(grid_.walls.left));
      }
    }
    if (column + 1 == std::size_t(grid_.columns) && grid_.walls.right != Wall::free) {
      for (std::size_t b = 0; b < 16; b += 4) {
        fold(gradient.x, b + 3, b + 1, -1.0);
        fold(gradient.y, b + 3, b + 1, tangential(grid_.walls.right));
      }
    }
  }
}

// cell_value_ = volume-weighted average of q over the particles of each cell.
void MaterialPointMethod::cell_averages(std::span<const double> q) const {
#pragma omp parallel for schedule(static) num_threads(settings_.threads) if (settings_.threads > 1)
  for (std::size_t c = 0; c < active_cells_.size(); ++c) {
    double sum = 0.0;
    for (std::size_t s = cell_start_[c]; s < cell_start_[c + 1]; ++s) {
      const std::size_t p = cell_particles_[s];
      sum += particles_.volume[p] * q[p];
    }
    cell_value_[c] = sum / cell_volume_[c];
  }
}

// f = D^T V Pi q, the force of the cell averages of a pressure on the nodes.
void MaterialPointMethod::add_pressure_force(std::span<const double> q, std::vector<double>& fx,
                                             std::vector<double>& fy) const {
  cell_averages(q);
  const std::size_t columns = std::size_t(grid_.node_columns());
#pragma omp parallel for schedule(dynamic) num_threads(settings_.threads) if (settings_.threads > 1)
  for (std::size_t k = 0; k < chunks_.size(); ++k) {
    const Chunk& chunk = chunks_[k];
    std::vector<double>& nodes = chunk_nodes_[k];
    const std::size_t count = chunk.last_node - chunk.first_node;
    nodes.assign(2 * count, 0.0);
    for (std::size_t c = chunk.first_cell; c < chunk.last_cell; ++c) {
      const double value = cell_value_[c];
      const CellGradient& gradient = cell_gradient_[c];
      double* x = nodes.data() + (cell_first_node(c) - chunk.first_node);
      double* y = x + count;
      for (std::size_t b = 0; b < 4; ++b, x += columns, y += columns) {
        for (std::size_t a = 0; a < 4; ++a) {
          x[a] += value * gradient.x[4 * b + a];
          y[a] += value * gradient.y[4 * b + a];
        }
      }
    }
  }
  std::fill(fx.begin(), fx.end(), 0.0);
  std::fill(fy.begin(), fy.end(), 0.0);
  for (std::size_t k = 0; k < chunks_.size(); ++k) {
    const Chunk& chunk = chunks_[k];
    const std::size_t count = chunk.last_node - chunk.first_node;
    for (std::size_t i = 0; i < count; ++i) {
      fx[chunk.first_node + i] += chunk_nodes_[k][i];
      fy[chunk.first_node + i] += chunk_nodes_[k][count + i];
    }
  }
}

// cell_value_ = (1 / V_c) B_c . v, the divergence of a grid velocity averaged over each cell.
void MaterialPointMethod::cell_divergence(const std::vector<double>& vx, const std::vector<double>& vy) const {
  const std::size_t columns = std::size_t(grid_.node_columns());
#pragma omp parallel for schedule(static) num_threads(settings_.threads) if (settings_.threads > 1)
  for (std::size_t c = 0; c < active_cells_.size(); ++c) {
    const CellGradient& gradient = cell_gradient_[c];
    const double* x = vx.data() + cell_first_node(c);
    const double* y = vy.data() + cell_first_node(c);
    double sum = 0.0;
    for (std::size_t b = 0; b < 4; ++b, x += columns, y += columns) {
      for (std::size_t a = 0; a < 4; ++a) sum += x[a] * gradient.x[4 * b + a] + y[a] * gradient.y[4 * b + a];
    }
    cell_value_[c] = sum / cell_volume_[c];
  }
}

void MaterialPointMethod::volumetric_strain(double dt, std::span<double> strain) const {
  cell_divergence(vx_, vy_);
  for (std::size_t p = 0; p < strain.size(); ++p) strain[p] = dt * cell_value_[cell_of_[p]];
}

void MaterialPointMethod::volume_response(double dt, std::span<const double> q, std::span<double> volume_change) const {
  add_pressure_force(q, work_x_, work_y_);
  for (std::size_t i = 0; i < work_x_.size(); ++i) {
    work_x_[i] *= inverse_mass_x_[i];
    work_y_[i] *= inverse_mass_y_[i];
  }
  cell_divergence(work_x_, work_y_);
  const double scale = dt * dt;
#pragma omp parallel for schedule(static) num_threads(settings_.threads) if (settings_.threads > 1)
  for (std::size_t p = 0; p < volume_change.size(); ++p) {
    volume_change[p] = scale * particles_.volume[p] * cell_value_[cell_of_[p]];
  }
}

void MaterialPointMethod::volume_response_diagonal(double dt, std::span<double> diagonal) const {
  const std::size_t columns = std::size_t(grid_.node_columns());
  for (std::size_t c = 0; c < active_cells_.size(); ++c) {
    const CellGradient& gradient = cell_gradient_[c];
    const double* mx = inverse_mass_x_.data() + cell_first_node(c);
    const double* my = inverse_mass_y_.data() + cell_first_node(c);
    double sum = 0.0;
    for (std::size_t b = 0; b < 4; ++b, mx += columns, my += columns) {
      for (std::size_t a = 0; a < 4; ++a) {
        const std::size_t k = 4 * b + a;
        sum += gradient.x[k] * gradient.x[k] * mx[a] + gradient.y[k] * gradient.y[k] * my[a];
      }
    }
    cell_value_[c] = dt * dt * sum / (cell_volume_[c] * cell_volume_[c]);
  }
  for (std::size_t p = 0; p < diagonal.size(); ++p) {
    diagonal[p] = particles_.volume[p] * particles_.volume[p] * cell_value_[cell_of_[p]];
  }
}

void MaterialPointMethod::correct(double dt, std::span<const double> q) {
  add_pressure_force(q, work_x_, work_y_);
  for (std::size_t i = 0; i < vx_.size(); ++i) {
    vx_[i] += dt * work_x_[i] * inverse_mass_x_[i];
    vy_[i] += dt * work_y_[i] * inverse_mass_y_[i];
  }
}

}  // namespace slope::solid
