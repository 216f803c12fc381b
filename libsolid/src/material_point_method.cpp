#include "slope/solid/material_point_method.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string_view>
#include <utility>

#include "cells.hpp"
#include "pair.hpp"
#include "slope/solid/shape_function.hpp"
#include "threads.hpp"

namespace slope::solid {

namespace {

// Nodes lighter than this share of the heaviest carry no momentum: below it lies only rounding.
constexpr double lightest_node = 1.0e-12;

void require(bool holds, const char* message) {
  if (!holds) throw std::invalid_argument(message);
}

void to_zero(std::vector<double>& field) {
  std::fill(field.begin(), field.end(), 0.0);
}

void check_particles(const Particles& particles, std::size_t soils) {
  Particles::for_each_field(particles, [&](const char* name, const auto& field) {
    if (std::string_view(name) == "internal") return;
    require(field.size() == particles.size(), "the particles' arrays differ in length");
  });
  for (const std::uint16_t soil : particles.soil) require(soil < soils, "a particle names a soil that is not there");
}

}  // namespace

SolidError::SolidError(std::size_t at, const std::string& name, double bad)
    : std::runtime_error("particle " + std::to_string(at) + ": " + name + " is " + std::to_string(bad)),
      particle(at),
      field(name),
      value(bad) {}

MaterialPointMethod::MaterialPointMethod(const Grid& grid, std::vector<Soil> soils, Particles particles,
                                         const Settings& settings)
    : grid_(grid), soils_(std::move(soils)), settings_(settings) {
  state_.particles = std::move(particles);
  require(grid_.cell_size > 0.0 && grid_.columns > 0 && grid_.rows > 0, "the grid has no cells");
  require(settings_.threads > 0, "there must be a thread at least");
  require(settings_.flip_fraction <= 1.0, "the share of FLIP is above one");
  const Walls& walls = grid_.walls;
  const bool absorbs = walls.left == Wall::absorbing || walls.right == Wall::absorbing || walls.base == Wall::absorbing;
  require(!absorbs || walls.absorbing_depth > 0.0, "absorbing walls need a depth");
  check_particles(state_.particles, soils_.size());

  for (const Soil& soil : soils_) {
    materials_.emplace_back(soil, grid_.cell_size);
    internal_count_ = std::max(internal_count_, internal_count(materials_.back().strength));
  }
  kinds_ = soils_.size();
  set_internal_variables();
  find_wall_nodes();
  find_friction_times();
  const std::size_t n = state_.particles.size();
  weights_.resize(n);
  grid_cell_of_.resize(n);
  hat_weights_.resize(n);
  cell_particles_.resize(n);
  velocity_gradient_.resize(n);
  mass_.resize(n);
  const auto material_dilates = [](const Material& material) { return material.dilates; };
  shares_dilation_ = settings_.averages_pressure && std::any_of(materials_.begin(), materials_.end(), material_dilates);
  if (shares_dilation_) {
    trial_stress_.resize(n);
    dilation_.resize(n);
  }
  cell_start_.resize(grid_.cell_count() + 1);
  node_.resize(grid_.node_count());
  hat_at_.resize(grid_.node_count());
  hat_value_.resize(grid_.node_count());
  for (auto* field : {&old_velocity_, &velocity_, &response_, &pressure_force_}) {
    field->assign(grid_.node_count(), Eigen::Array2d::Zero());
  }
}

void MaterialPointMethod::set_state(State state) {
  check_particles(state.particles, soils_.size());
  require(state.particles.size() == state_.particles.size(), "the state has another number of particles");
  require(state.walls.size() == state_.walls.size(), "the state has another number of wall nodes");
  require(state.particles.internal.size() == state_.particles.internal.size(), "the state is of other strength laws");
  state_ = std::move(state);
}

double MaterialPointMethod::stable_step(double courant_number, std::span<const double> water_mass) const {
  double fastest = 0.0;
  for (std::size_t p = 0; p < state_.particles.size(); ++p) {
    const double mass = state_.particles.solid_mass[p] + (water_mass.empty() ? 0.0 : water_mass[p]);
    const Material& material = materials_[state_.particles.soil[p]];
    const double modulus =
        material.has_state ? stiffness(p).constrained_modulus() : material.elastic.constrained_modulus();
    fastest = std::max(fastest, modulus * state_.particles.volume[p] / mass);
  }
  return courant_number * grid_.cell_size / std::sqrt(fastest);
}

void MaterialPointMethod::stop() {
  state_.particles.for_each_velocity(to_zero);
}

void MaterialPointMethod::predict(double dt, const PoreState& pore, const Loads& loads, double damping) {
  require(loads.tractions.empty() || settings_.particle_spacing > 0.0, "tractions need a particle spacing");
  place_on_grid();
  const PoreState inside = less_outside(pore, loads.surface);
  scatter(inside, loads.surface, {loads.body_acceleration[0], loads.body_acceleration[1] - settings_.gravity});
  add_tractions(loads.tractions);
  fold_walls();
  if (settings_.averages_pressure && !inside.pressure.empty()) {
    find_pressure_force(inside.pressure);
    for (std::size_t i = 0; i < node_.size(); ++i) node_[i].force += pressure_force_[i];
  }
  look_at_soil(inside.pressure);
  update_velocity(dt, damping);
}

// What the grid is to the particles; in a search for balance at fixed positions it stays what it was.
void MaterialPointMethod::place_on_grid() {
  const Particles& particles = state_.particles;
  if (particles.x == placed_x_ && particles.y == placed_y_ && particles.volume == placed_volume_) return;
  if (settings_.shape_function == ShapeFunction::quadratic_bspline) {
    find_weights<QuadraticBSpline>();
  } else {
    find_weights<Linear>();
  }
  sort_into_cells();
  find_hats();
  faces_.find(grid_, {cell_start_, cell_particles_}, particles, kinds_);
  placed_x_ = particles.x, placed_y_ = particles.y, placed_volume_ = particles.volume;
}

// The pore state with the pressure on the surface taken off its pressure.
PoreState MaterialPointMethod::less_outside(const PoreState& pore, const SurfacePressure& surface) {
  if (surface.pressure.empty()) return pore;
  excess_.assign(state_.particles.size(), 0.0);
  for (std::size_t p = 0; p < excess_.size(); ++p) {
    excess_[p] = (pore.pressure.empty() ? 0.0 : pore.pressure[p]) - surface.pressure[p];
  }
  return {excess_, pore.water_mass};
}

void MaterialPointMethod::update_velocity(double dt, double damping) {
  double heaviest = 0.0;
  for (const Node& node : node_) heaviest = std::max(heaviest, node.mass);
  const double slow_down = 1.0 / (1.0 + damping * dt);
  state_.balance = {};
  for (std::size_t i = 0; i < node_.size(); ++i) {
    state_.balance.weight += node_[i].mass * settings_.gravity;
    response_[i] = node_[i].mass > lightest_node * heaviest ? 1.0 / node_[i].mass : 0.0;
  }
  hold_walls();
  move_walls(dt);
  for (std::size_t i = 0; i < node_.size(); ++i) {
    const Node& node = node_[i];
    const Eigen::Array2d inverse_mass = response_[i];
    old_velocity_[i] = node.momentum * inverse_mass;
    response_[i] = inverse_mass * slow_down;
    velocity_[i] = (node.momentum + dt * node.force) * response_[i];
    state_.balance.kinetic_energy += 0.5 * (node.momentum * old_velocity_[i]).sum();
    state_.balance.unbalanced_force += (inverse_mass > 0.0).select(node.force.abs(), 0.0).sum();
  }
}

void MaterialPointMethod::advance(double dt, std::span<const double> suction, const StepMode& mode) {
  unfold_walls();
  if (state_.walls_released && mode.moves) {
    for (const WallNode& wall : wall_nodes_) pair(memory_of(wall).displacement) += dt * velocity_[wall.on];
  }
  if (settings_.flip_fraction >= 0.0) {
    gather<Transfer::flip>(dt, mode);
  } else if (settings_.shape_function == ShapeFunction::linear || mode.restored_losses == 0.0) {
    forget_losses();
    gather<Transfer::apic>(dt, mode);
  } else {
    state_.has_losses = true;
    gather<Transfer::restoring_apic>(dt, mode);
  }
  if (settings_.shape_function == ShapeFunction::linear) remap_velocity();
  update_stress(dt, suction, mode);
  check();
}

void MaterialPointMethod::forget_losses() {
  if (!state_.has_losses) return;
  state_.has_losses = false;
  state_.particles.for_each_loss(to_zero);
}

void MaterialPointMethod::refuse_place(std::size_t p) const {
  if (!holds_x_of(p)) throw SolidError(p, "x position (m), outside of the grid,", state_.particles.x[p]);
  throw SolidError(p, "y position (m), outside of the grid,", state_.particles.y[p]);
}

void MaterialPointMethod::check() const {
  const std::size_t n = state_.particles.size();
  const Particles& f = state_.particles;
  const auto velocity = [&f](std::size_t p) { return f.vx[p] + f.vy[p]; };
  const auto stress = [&f](std::size_t p) { return f.sxx[p] + f.syy[p] + f.szz[p] + f.sxy[p]; };
  const auto inside = [this](std::size_t p) { return holds_x_of(p) && holds_y_of(p); };
  std::atomic<bool> good = true;
  for_each_index(n, settings_.threads, [&](std::size_t p) {
    if (!std::isfinite(velocity(p) + stress(p)) || !(f.volume[p] > 0.0) || !inside(p)) good = false;
  });
  if (good) return;
  // what comes first in the step is nearest to the cause
  for (std::size_t p = 0; p < n; ++p) {
    if (!std::isfinite(velocity(p))) throw SolidError(p, "velocity (m/s)", velocity(p));
  }
  for (std::size_t p = 0; p < n; ++p) {
    if (!(f.volume[p] > 0.0)) throw SolidError(p, "volume (m2)", f.volume[p]);
  }
  for (std::size_t p = 0; p < n; ++p) {
    if (!inside(p)) refuse_place(p);
  }
  for (std::size_t p = 0; p < n; ++p) {
    if (!std::isfinite(stress(p))) throw SolidError(p, "effective stress (Pa)", stress(p));
  }
}

}  // namespace slope::solid
