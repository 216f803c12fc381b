#include "slope/solid/material_point_method.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "slope/solid/shape_function.hpp"

namespace slope::solid {

namespace {

// Nodes lighter than this share of the heaviest carry no momentum: below it lies only rounding.
constexpr double lightest_node = 1.0e-12;

void require(bool holds, const char* message) {
  if (!holds) throw std::invalid_argument(message);
}

}  // namespace

SolidError::SolidError(std::size_t at, const std::string& name, double bad)
    : std::runtime_error("particle " + std::to_string(at) + ": " + name + " is " + std::to_string(bad)),
      particle(at),
      field(name),
      value(bad) {}

MaterialPointMethod::MaterialPointMethod(const Grid& grid, std::vector<Soil> soils, Particles particles,
                                         const Settings& settings)
    : grid_(grid), soils_(std::move(soils)), particles_(std::move(particles)), settings_(settings) {
  require(grid_.cell_size > 0.0 && grid_.columns > 0 && grid_.rows > 0, "the grid has no cells");
  require(settings_.threads > 0, "there must be a thread at least");
  require(settings_.flip_fraction <= 1.0, "the share of FLIP is above one");
  const Walls& walls = grid_.walls;
  const bool absorbs = walls.left == Wall::absorbing || walls.right == Wall::absorbing || walls.base == Wall::absorbing;
  require(!absorbs || walls.absorbing_depth > 0.0, "absorbing walls need a depth");
  const std::size_t n = particles_.size();
  const Particles& p = particles_;
  for (const auto* field : {&p.y,
                            &p.ux,
                            &p.uy,
                            &p.vx,
                            &p.vy,
                            &p.cxx,
                            &p.cxy,
                            &p.cyx,
                            &p.cyy,
                            &p.sxx,
                            &p.syy,
                            &p.szz,
                            &p.sxy,
                            &p.exx,
                            &p.eyy,
                            &p.exy,
                            &p.plastic_strain,
                            &p.volume,
                            &p.solid_mass,
                            &p.porosity}) {
    require(field->size() == n, "the particles' arrays differ in length");
  }
  require(p.soil.size() == n, "the particles' arrays differ in length");
  for (const std::uint16_t soil : p.soil) require(soil < soils_.size(), "a particle names a soil that is not there");

  for (const Soil& soil : soils_) materials_.emplace_back(soil, grid_.cell_size);
  find_wall_nodes();
  find_friction_times();
  weights_.resize(n);
  grid_cell_of_.resize(n);
  hat_weights_.resize(n);
  cell_particles_.resize(n);
  velocity_gradient_.resize(n);
  mass_.resize(n);
  cell_start_.resize(grid_.cell_count() + 1);
  node_.resize(grid_.node_count());
  hat_at_.resize(grid_.node_count());
  hat_value_.resize(grid_.node_count());
  for (auto* field : {&old_velocity_, &velocity_, &response_, &pressure_force_}) {
    field->assign(grid_.node_count(), Eigen::Array2d::Zero());
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
  for (auto* field :
       {&particles_.vx, &particles_.vy, &particles_.cxx, &particles_.cxy, &particles_.cyx, &particles_.cyy}) {
    std::fill(field->begin(), field->end(), 0.0);
  }
}

void MaterialPointMethod::predict(double dt, const PoreState& pore, std::span<const ParticleTraction> tractions,
                                  double damping, std::array<double, 2> body_acceleration,
                                  const SurfacePressure& surface) {
  require(tractions.empty() || settings_.particle_spacing > 0.0, "tractions need a particle spacing");
  if (settings_.shape_function == ShapeFunction::quadratic_bspline) {
    find_weights<QuadraticBSpline>();
  } else {
    find_weights<Linear>();
  }
  sort_into_cells();
  find_hats();
  const PoreState inside = less_outside(pore, surface);
  scatter(inside, surface, {body_acceleration[0], body_acceleration[1] - settings_.gravity});
  add_tractions(tractions);
  fold_walls();
  if (settings_.averages_pressure && !inside.pressure.empty()) {
    find_pressure_force(inside.pressure);
    for (std::size_t i = 0; i < node_.size(); ++i) node_[i].force += pressure_force_[i];
  }
  look_at_soil(inside.pressure);
  update_velocity(dt, damping);
}

// The pore state with the pressure on the surface taken off its pressure.
PoreState MaterialPointMethod::less_outside(const PoreState& pore, const SurfacePressure& surface) {
  if (surface.pressure.empty()) return pore;
  excess_.assign(particles_.size(), 0.0);
  for (std::size_t p = 0; p < excess_.size(); ++p) {
    excess_[p] = (pore.pressure.empty() ? 0.0 : pore.pressure[p]) - surface.pressure[p];
  }
  return {excess_, pore.water_mass};
}

void MaterialPointMethod::update_velocity(double dt, double damping) {
  double heaviest = 0.0;
  for (const Node& node : node_) heaviest = std::max(heaviest, node.mass);
  const double slow_down = 1.0 / (1.0 + damping * dt);
  balance_ = {};
  for (std::size_t i = 0; i < node_.size(); ++i) {
    balance_.weight += node_[i].mass * settings_.gravity;
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
    balance_.kinetic_energy += 0.5 * (node.momentum * old_velocity_[i]).sum();
    balance_.unbalanced_force += (inverse_mass > 0.0).select(node.force.abs(), 0.0).sum();
  }
}

void MaterialPointMethod::advance(double dt, std::span<const double> suction, const StepMode& mode) {
  unfold_walls();
  if (walls_released_ && mode.moves) {
    for (WallNode& wall : wall_nodes_) wall.displacement += dt * velocity_[wall.on];
  }
  if (settings_.flip_fraction < 0.0) {
    gather<true>(dt, mode);
  } else {
    gather<false>(dt, mode);
  }
  if (settings_.shape_function == ShapeFunction::linear) remap_velocity();
  update_stress(dt, suction, mode);
  check();
}

void MaterialPointMethod::check() const {
  const std::size_t n = particles_.size();
  const Particles& f = particles_;
  const auto velocity = [&f](std::size_t p) { return f.vx[p] + f.vy[p]; };
  const auto stress = [&f](std::size_t p) { return f.sxx[p] + f.syy[p] + f.szz[p] + f.sxy[p]; };
  std::size_t bad = 0;
#pragma omp parallel for schedule(static) num_threads(settings_.threads) if (settings_.threads > 1) reduction(+ : bad)
  for (std::size_t p = 0; p < n; ++p) {
    if (!std::isfinite(velocity(p) + stress(p)) || !(f.volume[p] > 0.0)) ++bad;
  }
  if (bad == 0) return;
  // what comes first in the step is nearest to the cause
  for (std::size_t p = 0; p < n; ++p) {
    if (!std::isfinite(velocity(p))) throw SolidError(p, "velocity (m/s)", velocity(p));
  }
  for (std::size_t p = 0; p < n; ++p) {
    if (!(f.volume[p] > 0.0)) throw SolidError(p, "volume (m2)", f.volume[p]);
  }
  for (std::size_t p = 0; p < n; ++p) {
    if (!std::isfinite(stress(p))) throw SolidError(p, "effective stress (Pa)", stress(p));
  }
}

}  // namespace slope::solid
