// The projection of pressure and volume change on the hat functions of the grid's nodes, and the pore pressure's force
// and the grid's volume change through it: both with the same coefficients, per node n of the hats
// B_n = sum over the particles of V_p N_n(x_p) G_ip, wall conditions folded in, over M_n = sum of V_p N_n(x_p).

#include <algorithm>

#include "cells.hpp"
#include "hats.hpp"
#include "threads.hpp"

namespace slope::solid {

namespace {

// The components of five nodes in a row as one array, which the processor can treat at once.
using FiveNodes = Eigen::Array<double, 10, 1>;
auto five_nodes(Eigen::Array2d* first) {
  return Eigen::Map<FiveNodes>(first->data());
}
auto five_nodes(const Eigen::Array2d* first) {
  return Eigen::Map<const FiveNodes>(first->data());
}

}  // namespace

// The hats that reach a particle, in grid order, and their gradients B_n / M_n.
void MaterialPointMethod::find_hats() {
  constexpr std::size_t none = ~std::size_t{0};
  constexpr int rows_per_band = 4;  // a hat's gradient reaches two rows of nodes to either side
  const std::size_t columns = std::size_t(grid_.node_columns());
  std::fill(hat_at_.begin(), hat_at_.end(), none);
  for (std::size_t c = 0; c + 1 < cells_.size(); ++c) {
    const std::size_t corner = cells_[c].corner;
    for (const std::size_t n : {corner, corner + 1, corner + columns, corner + columns + 1}) hat_at_[n] = 0;
  }
  hat_bands_.clear();
  std::size_t count = 0;
  for (int j = 0; j <= grid_.rows; ++j) {
    if (j % rows_per_band == 0) hat_bands_.push_back(count);
    for (int i = 0; i <= grid_.columns; ++i) {
      const std::size_t n = grid_.node(i, j);
      if (hat_at_[n] == none) continue;
      if (count == hats_.size()) hats_.emplace_back();
      Hat& hat = hats_[count];
      hat.column = i;
      hat.row = j;
      hat.node = n;
      hat.first = grid_.node(i - 2, j - 2);
      hat.volume = 0.0;
      hat.gradient.fill(Eigen::Array2d::Zero());
      hat_at_[n] = count++;
    }
  }
  hats_.resize(count);
  hat_bands_.push_back(count);

  for_each_cell([&](std::size_t c) {
    const std::size_t corner = cells_[c].corner;
    for (std::size_t s = cells_[c].particle; s < cells_[c + 1].particle; ++s) {
      const std::size_t p = cell_particles_[s];
      const ParticleWeights& w = weights_[p];
      // where the particle's 3 x 3 nodes lie among the 5 x 5 of the hat at the cell's lower left corner
      const std::size_t offset = w.node - (corner - columns - 1);
      const std::size_t first = 6 + (offset < columns ? offset : offset - columns + 5);
      const Eigen::Array2d x[3] = {{w.gx[0], w.nx[0]}, {w.gx[1], w.nx[1]}, {w.gx[2], w.nx[2]}};
      for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t right = k % 2, up = k / 2;
        Hat& hat = hats_[hat_at_[corner + right + up * columns]];
        const double v = state_.particles.volume[p] * hat_weights_[p].value[k];
        hat.volume += v;
        Eigen::Array2d* row = hat.gradient.data() + (first - right - 5 * up);
        for (std::size_t b = 0; b < 3; ++b, row += 5) {
          const Eigen::Array2d y(v * w.ny[b], v * w.gy[b]);
          for (std::size_t a = 0; a < 3; ++a) row[a] += x[a] * y;
        }
      }
    }
  });
  for_each_index(hats_.size(), settings_.threads, [&](std::size_t k) {
    Hat& hat = hats_[k];
    fold_walls(hat);
    const double share = hat.volume > 0.0 ? 1.0 / hat.volume : 0.0;
    for (Eigen::Array2d& node : hat.gradient) node *= share;
  });
}

// hat_value_ = N^T V q.
void MaterialPointMethod::sum_over_hats(std::span<const double> q) const {
  const std::size_t columns = std::size_t(grid_.node_columns());
  std::fill(hat_value_.begin(), hat_value_.end(), 0.0);
  for_each_cell([&](std::size_t c) {
    double* lower = hat_value_.data() + cells_[c].corner;
    double* upper = lower + columns;
    for (std::size_t s = cells_[c].particle; s < cells_[c + 1].particle; ++s) {
      const std::size_t p = cell_particles_[s];
      const std::array<double, 4>& n = hat_weights_[p].value;
      const double vq = state_.particles.volume[p] * q[p];
      lower[0] += n[0] * vq;
      lower[1] += n[1] * vq;
      upper[0] += n[2] * vq;
      upper[1] += n[3] * vq;
    }
  });
}

// D^T V Pi q: the force on the nodes of the projection Pi q of a pressure.
void MaterialPointMethod::find_pressure_force(std::span<const double> q) const {
  sum_over_hats(q);
  const std::size_t columns = std::size_t(grid_.node_columns());
  std::fill(pressure_force_.begin(), pressure_force_.end(), Eigen::Array2d::Zero());
  for_each_in_bands(hat_bands_, [&](std::size_t k) {
    const Hat& hat = hats_[k];
    const double value = hat_value_[hat.node];
    const Eigen::Array2d* gradient = hat.gradient.data();
    Eigen::Array2d* force = pressure_force_.data() + hat.first;
    for (std::size_t b = 0; b < 5; ++b, force += columns, gradient += 5) {
      five_nodes(force) += value * five_nodes(gradient);
    }
  });
}

// hat_value_ = (1 / M_n) B_n . v, the divergence of a grid velocity averaged over each hat.
void MaterialPointMethod::find_hat_divergence(const std::vector<Eigen::Array2d>& velocity) const {
  const std::size_t columns = std::size_t(grid_.node_columns());
  for_each_index(hats_.size(), settings_.threads, [&](std::size_t k) {
    const Hat& hat = hats_[k];
    const Eigen::Array2d* gradient = hat.gradient.data();
    const Eigen::Array2d* v = velocity.data() + hat.first;
    FiveNodes sum = FiveNodes::Zero();
    for (std::size_t b = 0; b < 5; ++b, v += columns, gradient += 5) sum += five_nodes(v) * five_nodes(gradient);
    hat_value_[hat.node] = sum.sum();
  });
}

void MaterialPointMethod::volumetric_strain(double dt, std::span<double> strain) const {
  find_hat_divergence(velocity_);
  for_each_index(strain.size(), settings_.threads, [&](std::size_t p) { strain[p] = dt * from_hats(p); });
}

void MaterialPointMethod::volume_response(double dt, std::span<const double> q, std::span<double> volume_change) const {
  find_pressure_force(q);
  respond(pressure_force_);
  find_hat_divergence(pressure_force_);
  const double scale = dt * dt;
  for_each_index(volume_change.size(), settings_.threads,
                 [&](std::size_t p) { volume_change[p] = scale * state_.particles.volume[p] * from_hats(p); });
}

// By convexity the mean over the four hats of a particle of what each alone would answer is no less than the diagonal.
void MaterialPointMethod::volume_response_diagonal(double dt, std::span<double> diagonal) const {
  const std::size_t columns = std::size_t(grid_.node_columns());
  for_each_index(hats_.size(), settings_.threads, [&](std::size_t k) {
    const Hat& hat = hats_[k];
    const Eigen::Array2d* gradient = hat.gradient.data();
    const Eigen::Array2d* response = response_.data() + hat.first;
    FiveNodes sum = FiveNodes::Zero();
    for (std::size_t b = 0; b < 5; ++b, response += columns, gradient += 5) {
      sum += five_nodes(gradient).square() * five_nodes(response);
    }
    hat_value_[hat.node] = dt * dt * sum.sum();
  });
  for_each_index(diagonal.size(), settings_.threads, [&](std::size_t p) {
    diagonal[p] = state_.particles.volume[p] * state_.particles.volume[p] * from_hats(p);
  });
}

void MaterialPointMethod::correct(double dt, std::span<const double> q) {
  find_pressure_force(q);
  respond(pressure_force_);
  for (std::size_t i = 0; i < velocity_.size(); ++i) velocity_[i] += dt * pressure_force_[i];
}

}  // namespace slope::solid
