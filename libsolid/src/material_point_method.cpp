#include "slope/solid/material_point_method.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "slope/solid/shape_function.hpp"

namespace slope::solid {

namespace {

// Particles per chunk of the scatter: the sum over chunks has the same order whatever the number of threads.
constexpr std::size_t chunk_size = 2048;

// Nodes lighter than this share of the heaviest carry no momentum.
constexpr double lightest_node = 1.0e-9;

}  // namespace

SolidError::SolidError(std::size_t at, const std::string& name, double bad)
    : std::runtime_error("particle " + std::to_string(at) + ": " + name + " is " + std::to_string(bad)),
      particle(at),
      field(name),
      value(bad) {}

MaterialPointMethod::MaterialPointMethod(const Grid& grid, std::vector<Soil> soils, Particles particles,
                                         const Settings& settings)
    : grid_(grid), soils_(std::move(soils)), particles_(std::move(particles)), settings_(settings) {
  const std::size_t n = particles_.size();
  const std::size_t nodes = grid_.node_count();
  weights_.resize(n);
  cell_of_.resize(n);
  gradient_of_velocity_.resize(4 * n);
  node_.resize(fields * nodes);
  for (auto* field : {&old_vx_, &old_vy_, &vx_, &vy_, &inverse_mass_x_, &inverse_mass_y_, &work_x_, &work_y_}) {
    field->assign(nodes, 0.0);
  }
}

double MaterialPointMethod::stable_step(double courant_number, std::span<const double> water_mass) const {
  double fastest = 0.0;
  for (std::size_t p = 0; p < particles_.size(); ++p) {
    const double mass = particles_.solid_mass[p] + (water_mass.empty() ? 0.0 : water_mass[p]);
    const double modulus = soils_[particles_.soil[p]].elastic.constrained_modulus();
    fastest = std::max(fastest, modulus * particles_.volume[p] / mass);
  }
  return courant_number * grid_.cell_size / std::sqrt(fastest);
}

void MaterialPointMethod::stop() {
  for (auto* field : {&particles_.vx, &particles_.vy, &particles_.cxx, &particles_.cxy, &particles_.cyx,
                      &particles_.cyy}) {
    std::fill(field->begin(), field->end(), 0.0);
  }
}

void MaterialPointMethod::predict(double dt, const PoreState& pore, std::span<const ParticleTraction> tractions,
                                  double damping) {
  if (settings_.shape_function == ShapeFunction::quadratic_bspline) {
    find_weights<QuadraticBSpline>();
  } else {
    find_weights<Linear>();
  }
  sort_into_cells();
  sum_cell_gradients();
  scatter(pore);
  add_tractions(tractions);
  fold_walls();
  if (!pore.pressure.empty()) {
    add_pressure_force(pore.pressure, work_x_, work_y_);
  } else {
    std::fill(work_x_.begin(), work_x_.end(), 0.0);
    std::fill(work_y_.begin(), work_y_.end(), 0.0);
  }
  update_velocity(dt, damping);
}

template <class Shape>
void MaterialPointMethod::find_weights() {
  const double h = grid_.cell_size;
  const double inverse = 1.0 / h;
  const std::size_t n = particles_.size();
  std::size_t outside = n;
#pragma omp parallel for schedule(static) num_threads(settings_.threads) if (settings_.threads > 1) reduction(min : outside)
  for (std::size_t p = 0; p < n; ++p) {
    const double px = (particles_.x[p] - grid_.lower[0]) * inverse;
    const double py = (particles_.y[p] - grid_.lower[1]) * inverse;
    if (!(px >= 0.0 && px < grid_.columns && py >= 0.0 && py < grid_.rows)) {
      outside = std::min(outside, p);
      continue;
    }
    const AxisWeights wx = Shape::weights(px, inverse);
    const AxisWeights wy = Shape::weights(py, inverse);
    ParticleWeights& w = weights_[p];
    w.node = grid_.node(wx.first, wy.first);
    w.dx = (wx.first - px) * h;
    w.dy = (wy.first - py) * h;
    for (int a = 0; a < 3; ++a) {
      w.nx[a] = wx.value[a];
      w.ny[a] = wy.value[a];
      w.gx[a] = wx.gradient[a];
      w.gy[a] = wy.gradient[a];
    }
    const int column = std::min(static_cast<int>(px), grid_.columns - 1);
    const int row = std::min(static_cast<int>(py), grid_.rows - 1);
    cell_of_[p] = std::size_t(row) * std::size_t(grid_.columns) + std::size_t(column);
  }
  if (outside < n) {
    const bool left_in_x = !(particles_.x[outside] >= grid_.lower[0] &&
                             particles_.x[outside] < grid_.lower[0] + grid_.columns * h);
    throw left_in_x ? SolidError(outside, "x position (m), outside of the grid,", particles_.x[outside])
                    : SolidError(outside, "y position (m), outside of the grid,", particles_.y[outside]);
  }
}

void MaterialPointMethod::sort_into_cells() {
  const std::size_t n = particles_.size();
  std::vector<std::size_t>& start = cell_start_;
  start.assign(grid_.cell_count() + 1, 0);
  for (std::size_t p = 0; p < n; ++p) ++start[cell_of_[p] + 1];
  for (std::size_t c = 0; c < grid_.cell_count(); ++c) start[c + 1] += start[c];
  cell_particles_.resize(n);
  for (std::size_t p = n; p-- > 0;) cell_particles_[--start[cell_of_[p] + 1]] = p;
  // start[c + 1] is now where cell c begins; keep the cells that hold particles
  active_cells_.clear();
  std::size_t active = 0;
  for (std::size_t c = 0; c < grid_.cell_count(); ++c) {
    const std::size_t begin = start[c + 1];
    const std::size_t end = c + 1 < grid_.cell_count() ? start[c + 2] : n;
    if (begin == end) continue;
    active_cells_.push_back(c);
    start[active++] = begin;
  }
  start.resize(active + 1);
  start[active] = n;

  chunks_.clear();
  for (std::size_t c = 0; c < active;) {
    Chunk chunk{c, c, 0, 0};
    while (chunk.last_cell < active && start[chunk.last_cell] - start[c] < chunk_size) ++chunk.last_cell;
    chunk.first_node = cell_first_node(chunk.first_cell);
    chunk.last_node = cell_first_node(chunk.last_cell - 1) + 3 * std::size_t(grid_.node_columns()) + 4;
    chunks_.push_back(chunk);
    c = chunk.last_cell;
  }
  if (chunk_nodes_.size() < chunks_.size()) chunk_nodes_.resize(chunks_.size());
}

std::size_t MaterialPointMethod::cell_first_node(std::size_t cell) const {
  const std::size_t c = active_cells_[cell];
  const int column = static_cast<int>(c % std::size_t(grid_.columns));
  const int row = static_cast<int>(c / std::size_t(grid_.columns));
  return grid_.node(column - 1, row - 1);
}

void MaterialPointMethod::scatter(const PoreState& pore) {
  const std::size_t columns = std::size_t(grid_.node_columns());
  const double h = grid_.cell_size;
  const bool affine = settings_.flip_fraction < 0.0;
#pragma omp parallel for schedule(dynamic) num_threads(settings_.threads) if (settings_.threads > 1)
  for (std::size_t k = 0; k < chunks_.size(); ++k) {
    const Chunk& chunk = chunks_[k];
    std::vector<double>& nodes = chunk_nodes_[k];
    nodes.assign(fields * (chunk.last_node - chunk.first_node), 0.0);
    for (std::size_t s = cell_start_[chunk.first_cell]; s < cell_start_[chunk.last_cell]; ++s) {
      const std::size_t p = cell_particles_[s];
      const ParticleWeights& w = weights_[p];
      const double m = particles_.solid_mass[p] + (pore.water_mass.empty() ? 0.0 : pore.water_mass[p]);
      const double v = particles_.volume[p];
      const double cxx = affine ? particles_.cxx[p] : 0.0;
      const double cxy = affine ? particles_.cxy[p] : 0.0;
      const double cyx = affine ? particles_.cyx[p] : 0.0;
      const double cyy = affine ? particles_.cyy[p] : 0.0;
      // value at a node = N (base + affine part) + dN/dx by_gx + dN/dy by_gy
      const double corner_x = m * (particles_.vx[p] + cxx * w.dx + cxy * w.dy);
      const double corner_y = m * (particles_.vy[p] + cyx * w.dx + cyy * w.dy);
      const double per_column_x = m * cxx * h, per_column_y = m * cyx * h;
      const double per_row_x = m * cxy * h, per_row_y = m * cyy * h;
      const double stress_xx = -v * particles_.sxx[p];
      const double stress_xy = -v * particles_.sxy[p];
      const double stress_yy = -v * particles_.syy[p];
      const double weight = -m * settings_.gravity;
      double* row = nodes.data() + fields * (w.node - chunk.first_node);
      for (int b = 0; b < 3; ++b, row += fields * columns) {
        for (int a = 0; a < 3; ++a) {
          const double n = w.nx[a] * w.ny[b];
          const double gx = w.gx[a] * w.ny[b];
          const double gy = w.nx[a] * w.gy[b];
          double* node = row + fields * std::size_t(a);
          node[0] += n * m;
          node[2] += n * (corner_x + a * per_column_x + b * per_row_x);
          node[3] += n * (corner_y + a * per_column_y + b * per_row_y);
          node[4] += gx * stress_xx + gy * stress_xy;
          node[5] += n * weight + gx * stress_xy + gy * stress_yy;
        }
      }
    }
  }
  std::fill(node_.begin(), node_.end(), 0.0);
  for (std::size_t k = 0; k < chunks_.size(); ++k) {
    double* to = node_.data() + fields * chunks_[k].first_node;
    const std::vector<double>& from = chunk_nodes_[k];
    for (std::size_t i = 0; i < from.size(); ++i) to[i] += from[i];
  }
  for (std::size_t i = 0; i < node_.size(); i += fields) node_[i + 1] = node_[i];
}

void MaterialPointMethod::add_tractions(std::span<const ParticleTraction> tractions) {
  const std::size_t columns = std::size_t(grid_.node_columns());
  for (const ParticleTraction& traction : tractions) {
    const ParticleWeights& w = weights_[traction.particle];
    // Eq. 17: the traction acts in a layer one particle thick, over the particle's share of the surface
    for (int b = 0; b < 3; ++b) {
      for (int a = 0; a < 3; ++a) {
        const double n = w.nx[a] * w.ny[b] * settings_.particle_spacing;
        double* node = node_.data() + fields * (w.node + std::size_t(b) * columns + std::size_t(a));
        node[4] += n * traction.x;
        node[5] += n * traction.y;
      }
    }
  }
}

// A node outside of a wall is the mirror image of one inside: opposite velocity components that the wall holds, equal
// ones that it leaves free. What the particles gave it goes to its mirror node, momentum and force with that sign, mass
// as it is: the soil and its mirror image are one body, whose velocity at a node is an average, which makes no energy.
void MaterialPointMethod::fold_walls() {
  const auto fold = [this](std::size_t outside, std::size_t inside, double sign_x, double sign_y) {
    double* from = node_.data() + fields * outside;
    double* to = node_.data() + fields * inside;
    to[0] += from[0];
    to[1] += from[1];
    to[2] += sign_x * from[2];
    to[3] += sign_y * from[3];
    to[4] += sign_x * from[4];
    to[5] += sign_y * from[5];
    std::fill(from, from + fields, 0.0);
  };
  const auto tangential = [](Wall wall) { return wall == Wall::fixed ? -1.0 : 1.0; };
  const int nx = grid_.columns, ny = grid_.rows;
  const Walls& walls = grid_.walls;
  for (int j = -1; j <= ny + 1; ++j) {
    if (walls.left != Wall::free) fold(grid_.node(-1, j), grid_.node(1, j), -1.0, tangential(walls.left));
    if (walls.right != Wall::free) fold(grid_.node(nx + 1, j), grid_.node(nx - 1, j), -1.0, tangential(walls.right));
  }
  for (int i = -1; i <= nx + 1; ++i) {
    if (walls.base != Wall::free) fold(grid_.node(i, -1), grid_.node(i, 1), tangential(walls.base), -1.0);
  }
  // held components: a massless node does not move
  const auto hold = [this](std::size_t node, bool x, bool y) {
    if (x) node_[fields * node] = 0.0;
    if (y) node_[fields * node + 1] = 0.0;
  };
  for (int j = -1; j <= ny + 1; ++j) {
    if (walls.left != Wall::free) hold(grid_.node(0, j), true, walls.left == Wall::fixed);
    if (walls.right != Wall::free) hold(grid_.node(nx, j), true, walls.right == Wall::fixed);
  }
  for (int i = -1; i <= nx + 1; ++i) {
    if (walls.base != Wall::free) hold(grid_.node(i, 0), walls.base == Wall::fixed, true);
  }
}

void MaterialPointMethod::update_velocity(double dt, double damping) {
  double heaviest = 0.0;
  for (std::size_t i = 0; i < node_.size(); i += fields) heaviest = std::max({heaviest, node_[i], node_[i + 1]});
  const double lightest = lightest_node * heaviest;
  const double slow_down = 1.0 / (1.0 + damping * dt);
  balance_ = {};
  for (std::size_t i = 0; i < vx_.size(); ++i) {
    const double* node = node_.data() + fields * i;
    const double fx = node[4] + work_x_[i];
    const double fy = node[5] + work_y_[i];
    const bool free_x = node[0] > lightest;
    const bool free_y = node[1] > lightest;
    inverse_mass_x_[i] = free_x ? 1.0 / node[0] : 0.0;
    inverse_mass_y_[i] = free_y ? 1.0 / node[1] : 0.0;
    old_vx_[i] = node[2] * inverse_mass_x_[i];
    old_vy_[i] = node[3] * inverse_mass_y_[i];
    vx_[i] = (old_vx_[i] + dt * fx * inverse_mass_x_[i]) * slow_down;
    vy_[i] = (old_vy_[i] + dt * fy * inverse_mass_y_[i]) * slow_down;
    balance_.kinetic_energy += 0.5 * (node[0] * old_vx_[i] * old_vx_[i] + node[1] * old_vy_[i] * old_vy_[i]);
    balance_.unbalanced_force += (free_x ? std::abs(fx) : 0.0) + (free_y ? std::abs(fy) : 0.0);
    balance_.weight += node[1] * settings_.gravity;
  }
}

void MaterialPointMethod::advance(double dt, std::span<const double> suction, const StepMode& mode) {
  unfold_walls();
  if (settings_.flip_fraction < 0.0) {
    gather<true>(dt, mode);
  } else {
    gather<false>(dt, mode);
  }
  update_stress(dt, suction, mode);
  check();
}

// Gives the nodes outside of the walls the velocity of their mirror images.
void MaterialPointMethod::unfold_walls() {
  const int nx = grid_.columns, ny = grid_.rows;
  const Walls& walls = grid_.walls;
  const auto mirror = [](std::vector<double>& v, std::size_t outside, std::size_t inside, double sign) {
    v[outside] = sign * v[inside];
  };
  const auto tangential = [](Wall wall) { return wall == Wall::fixed ? -1.0 : 1.0; };
  for (auto [vx, vy] : {std::pair{&vx_, &vy_}, std::pair{&old_vx_, &old_vy_}}) {
    for (int i = -1; i <= nx + 1; ++i) {
      if (walls.base == Wall::free) break;
      mirror(*vx, grid_.node(i, -1), grid_.node(i, 1), tangential(walls.base));
      mirror(*vy, grid_.node(i, -1), grid_.node(i, 1), -1.0);
    }
    for (int j = -1; j <= ny + 1; ++j) {
      if (walls.left != Wall::free) {
        mirror(*vx, grid_.node(-1, j), grid_.node(1, j), -1.0);
        mirror(*vy, grid_.node(-1, j), grid_.node(1, j), tangential(walls.left));
      }
      if (walls.right != Wall::free) {
        mirror(*vx, grid_.node(nx + 1, j), grid_.node(nx - 1, j), -1.0);
        mirror(*vy, grid_.node(nx + 1, j), grid_.node(nx - 1, j), tangential(walls.right));
      }
    }
  }
}

template <bool affine>
void MaterialPointMethod::gather(double dt, const StepMode& mode) {
  const std::size_t columns = std::size_t(grid_.node_columns());
  const double h = grid_.cell_size;
  const double affine_scale = 4.0 / (h * h);
  const bool linear = settings_.shape_function == ShapeFunction::linear;
  const double flip = settings_.flip_fraction;
#pragma omp parallel for schedule(static) num_threads(settings_.threads) if (settings_.threads > 1)
  for (std::size_t p = 0; p < particles_.size(); ++p) {
    const ParticleWeights& w = weights_[p];
    double vx = 0.0, vy = 0.0, ax = 0.0, ay = 0.0;
    double bxx = 0.0, bxy = 0.0, byx = 0.0, byy = 0.0;
    double lxx = 0.0, lxy = 0.0, lyx = 0.0, lyy = 0.0;
    std::size_t node = w.node;
    for (int b = 0; b < 3; ++b, node += columns) {
      // sums along the row, then over the rows
      double sx = 0.0, sy = 0.0, mx = 0.0, my = 0.0, gx = 0.0, gy = 0.0, dx = 0.0, dy = 0.0;
      for (int a = 0; a < 3; ++a) {
        const double nvx = vx_[node + std::size_t(a)];
        const double nvy = vy_[node + std::size_t(a)];
        const double n = w.nx[a];
        sx += n * nvx;
        sy += n * nvy;
        if constexpr (affine) {
          const double arm = n * (w.dx + a * h);
          mx += arm * nvx;
          my += arm * nvy;
        } else {
          dx += n * (nvx - old_vx_[node + std::size_t(a)]);
          dy += n * (nvy - old_vy_[node + std::size_t(a)]);
        }
        gx += w.gx[a] * nvx;
        gy += w.gx[a] * nvy;
      }
      const double n = w.ny[b];
      vx += n * sx;
      vy += n * sy;
      if constexpr (affine) {
        const double arm = n * (w.dy + b * h);
        bxx += n * mx;
        byx += n * my;
        bxy += arm * sx;
        byy += arm * sy;
      } else {
        ax += n * dx;
        ay += n * dy;
      }
      lxx += n * gx;
      lyx += n * gy;
      lxy += w.gy[b] * sx;
      lyy += w.gy[b] * sy;
    }
    double* l = gradient_of_velocity_.data() + 4 * p;
    l[0] = lxx;
    l[1] = lxy;
    l[2] = lyx;
    l[3] = lyy;
    if constexpr (affine) {
      particles_.vx[p] = vx;
      particles_.vy[p] = vy;
      // hat functions: sum of v N_i (x_i - x_p) over its moment is the velocity gradient itself
      particles_.cxx[p] = linear ? lxx : affine_scale * bxx;
      particles_.cxy[p] = linear ? lxy : affine_scale * bxy;
      particles_.cyx[p] = linear ? lyx : affine_scale * byx;
      particles_.cyy[p] = linear ? lyy : affine_scale * byy;
    } else {
      particles_.vx[p] = flip * (particles_.vx[p] + ax) + (1.0 - flip) * vx;
      particles_.vy[p] = flip * (particles_.vy[p] + ay) + (1.0 - flip) * vy;
    }
    if (mode.moves) {
      particles_.x[p] += dt * vx;
      particles_.y[p] += dt * vy;
      particles_.ux[p] += dt * vx;
      particles_.uy[p] += dt * vy;
    }
  }
}

void MaterialPointMethod::check() const {
  const std::size_t n = particles_.size();
  std::size_t bad = n;
#pragma omp parallel for schedule(static) num_threads(settings_.threads) if (settings_.threads > 1) reduction(min : bad)
  for (std::size_t p = 0; p < n; ++p) {
    const double sum = particles_.vx[p] + particles_.vy[p] + particles_.sxx[p] + particles_.syy[p] + particles_.sxy[p];
    if (!std::isfinite(sum) || !(particles_.volume[p] > 0.0)) bad = std::min(bad, p);
  }
  if (bad == n) return;
  if (!(particles_.volume[bad] > 0.0)) throw SolidError(bad, "volume (m2)", particles_.volume[bad]);
  if (!std::isfinite(particles_.vx[bad] + particles_.vy[bad])) {
    throw SolidError(bad, "velocity (m/s)", particles_.vx[bad] + particles_.vy[bad]);
  }
  throw SolidError(bad, "effective stress (Pa)", particles_.sxx[bad] + particles_.syy[bad] + particles_.sxy[bad]);
}

}  // namespace slope::solid
