// The pore pressure's force on the grid and the grid's volume change, both through cell averages and with the same
// coefficients: B_c = sum over the particles of cell c of V_p G_ip, wall conditions folded in.

#include <algorithm>

#include "cells.hpp"

namespace slope::solid {

namespace {

// The components of four nodes in a row as one array, which the processor can treat at once.
using FourNodes = Eigen::Array<double, 8, 1>;
auto four_nodes(Eigen::Array2d* first) {
  return Eigen::Map<FourNodes>(first->data());
}
auto four_nodes(const Eigen::Array2d* first) {
  return Eigen::Map<const FourNodes>(first->data());
}

}  // namespace

void MaterialPointMethod::sum_cell_gradients() {
  const std::size_t columns = std::size_t(grid_.node_columns());
  const std::size_t count = cells_.size() - 1;
  cell_gradient_.resize(count);
  cell_value_.resize(count);
#pragma omp parallel for schedule(static) num_threads(settings_.threads) if (settings_.threads > 1)
  for (std::size_t c = 0; c < count; ++c) {
    CellGradient gradient;
    gradient.fill(Eigen::Array2d::Zero());
    double volume = 0.0;
    for (std::size_t s = cells_[c].particle; s < cells_[c + 1].particle; ++s) {
      const std::size_t p = cell_particles_[s];
      cell_of_[p] = c;
      const ParticleWeights& w = weights_[p];
      const double v = particles_.volume[p];
      volume += v;
      // where the particle's 3 x 3 nodes lie among the cell's 4 x 4
      const std::size_t offset = w.node - cells_[c].node;
      Eigen::Array2d* row = gradient.data() + (offset < columns ? offset : offset - columns + 4);
      for (std::size_t b = 0; b < 3; ++b, row += 4) {
        const double n = v * w.ny[b], g = v * w.gy[b];
        for (std::size_t a = 0; a < 3; ++a) row[a] += Eigen::Array2d(w.gx[a] * n, w.nx[a] * g);
      }
    }
    fold_walls(cells_[c].index, gradient);
    cell_gradient_[c] = gradient;
    cells_[c].volume = volume;
  }
}

// D^T V Pi q: the force on the nodes of the cell averages Pi q of a pressure, volume-weighted over their particles.
void MaterialPointMethod::find_pressure_force(std::span<const double> q) const {
  const std::size_t columns = std::size_t(grid_.node_columns());
  std::fill(pressure_force_.begin(), pressure_force_.end(), Eigen::Array2d::Zero());
  for_each_cell([&](std::size_t c) {
    double sum = 0.0;
    for (std::size_t s = cells_[c].particle; s < cells_[c + 1].particle; ++s) {
      sum += particles_.volume[cell_particles_[s]] * q[cell_particles_[s]];
    }
    const double average = sum / cells_[c].volume;
    const Eigen::Array2d* gradient = cell_gradient_[c].data();
    Eigen::Array2d* force = pressure_force_.data() + cells_[c].node;
    for (std::size_t b = 0; b < 4; ++b, force += columns, gradient += 4) {
      four_nodes(force) += average * four_nodes(gradient);
    }
  });
}

// cell_value_ = (1 / V_c) B_c . v, the divergence of a grid velocity averaged over each cell.
void MaterialPointMethod::find_cell_divergence(const std::vector<Eigen::Array2d>& velocity) const {
  const std::size_t columns = std::size_t(grid_.node_columns());
#pragma omp parallel for schedule(static) num_threads(settings_.threads) if (settings_.threads > 1)
  for (std::size_t c = 0; c < cell_gradient_.size(); ++c) {
    const Eigen::Array2d* gradient = cell_gradient_[c].data();
    const Eigen::Array2d* v = velocity.data() + cells_[c].node;
    FourNodes sum = FourNodes::Zero();
    for (std::size_t b = 0; b < 4; ++b, v += columns, gradient += 4) sum += four_nodes(v) * four_nodes(gradient);
    cell_value_[c] = sum.sum() / cells_[c].volume;
  }
}

void MaterialPointMethod::volumetric_strain(double dt, std::span<double> strain) const {
  find_cell_divergence(velocity_);
  for (std::size_t p = 0; p < strain.size(); ++p) strain[p] = dt * cell_value_[cell_of_[p]];
}

void MaterialPointMethod::volume_response(double dt, std::span<const double> q, std::span<double> volume_change) const {
  find_pressure_force(q);
  respond(pressure_force_);
  find_cell_divergence(pressure_force_);
  const double scale = dt * dt;
#pragma omp parallel for schedule(static) num_threads(settings_.threads) if (settings_.threads > 1)
  for (std::size_t p = 0; p < volume_change.size(); ++p) {
    volume_change[p] = scale * particles_.volume[p] * cell_value_[cell_of_[p]];
  }
}

void MaterialPointMethod::volume_response_diagonal(double dt, std::span<double> diagonal) const {
  const std::size_t columns = std::size_t(grid_.node_columns());
  for (std::size_t c = 0; c < cell_gradient_.size(); ++c) {
    const Eigen::Array2d* gradient = cell_gradient_[c].data();
    const Eigen::Array2d* response = response_.data() + cells_[c].node;
    FourNodes sum = FourNodes::Zero();
    for (std::size_t b = 0; b < 4; ++b, response += columns, gradient += 4) {
      sum += four_nodes(gradient).square() * four_nodes(response);
    }
    cell_value_[c] = dt * dt * sum.sum() / (cells_[c].volume * cells_[c].volume);
  }
  for (std::size_t p = 0; p < diagonal.size(); ++p) {
    diagonal[p] = particles_.volume[p] * particles_.volume[p] * cell_value_[cell_of_[p]];
  }
}

void MaterialPointMethod::correct(double dt, std::span<const double> q) {
  find_pressure_force(q);
  respond(pressure_force_);
  for (std::size_t i = 0; i < velocity_.size(); ++i) velocity_[i] += dt * pressure_force_[i];
}

}  // namespace slope::solid
