#include "mixture.hpp"

#include <algorithm>
#include <cmath>

namespace slope::couple {

namespace {

std::vector<std::uint16_t> soil_indices(const InitialParticles& particles) {
  return {particles.soil.begin(), particles.soil.end()};
}

solid::MaterialPointMethod make_soil(const Case& input, const InitialParticles& particles, int threads) {
  const auto wall = [](Wall w) { return static_cast<solid::Wall>(w); };
  solid::Grid grid;
  grid.lower = input.domain.lower;
  grid.cell_size = input.domain.cell_size;
  grid.columns = static_cast<int>(std::lround((input.domain.upper[0] - input.domain.lower[0]) / grid.cell_size));
  grid.rows = static_cast<int>(std::lround((input.domain.upper[1] - input.domain.lower[1]) / grid.cell_size));
  grid.walls = {.left = wall(input.walls.left),
                .right = wall(input.walls.right),
                .base = wall(input.walls.base),
                .left_friction = input.walls.left_friction.value_or(0.0),
                .right_friction = input.walls.right_friction.value_or(0.0),
                .base_friction = input.walls.base_friction.value_or(0.0),
                .absorbing_depth = input.walls.absorbing_depth.value_or(0.0)};
  std::vector<solid::Soil> soils;
  std::vector<double> grain_density, porosity;
  for (const Soil& soil : input.soils) {
    soils.push_back(soil.solid);
    grain_density.push_back(soil.solid.grain_density);
  }
  for (const int soil : particles.soil) porosity.push_back(input.soils[static_cast<std::size_t>(soil)].porosity);
  solid::Settings settings;
  settings.shape_function = input.numerics.shape_function == ShapeFunction::linear
                                ? solid::ShapeFunction::linear
                                : solid::ShapeFunction::quadratic_bspline;
  settings.flip_fraction = input.numerics.flip_fraction.value_or(-1.0);
  settings.gravity = input.gravity;
  settings.averages_pressure = input.scheme != Scheme::explicit_two_pass;
  settings.particle_spacing = particles.spacing;
  settings.threads = threads;
  const std::vector<std::uint16_t> soil = soil_indices(particles);
  return {grid, std::move(soils),
          solid::Particles::at(particles.x, particles.y, particles.volume, porosity, soil, grain_density), settings};
}

seepage::PoreFlow make_water(const Case& input, const InitialParticles& particles, std::span<const double> pressure,
                             const seepage::Skeleton& skeleton, int threads) {
  std::vector<seepage::Soil> soils;
  for (const Soil& soil : input.soils) soils.push_back(soil.seepage);
  seepage::FlowSettings settings;
  settings.spacing = particles.spacing;
  settings.smoothing_ratio = input.numerics.smoothing_length;
  settings.threads = threads;
  settings.walls = mirror_walls(input);
  seepage::Water water = input.water;
  water.gravity = input.gravity;
  return {std::move(soils), water, soil_indices(particles), pressure, skeleton, settings};
}

seepage::Skeleton view(const solid::Particles& p) {
  return {p.x, p.y, p.volume, p.porosity};
}

}  // namespace

seepage::MirrorWalls mirror_walls(const Case& input) {
  seepage::MirrorWalls walls;
  if (input.walls.left != Wall::free) walls.left = input.domain.lower[0];
  if (input.walls.right != Wall::free) walls.right = input.domain.upper[0];
  if (input.walls.base != Wall::free) walls.base = input.domain.lower[1];
  return walls;
}

Mixture::Mixture(const Case& input, const InitialParticles& particles, std::span<const double> pressure, int threads)
    : soil(make_soil(input, particles, threads)),
      water(make_water(input, particles, pressure, view(soil.particles()), threads)),
      rigid_(input.skeleton == Skeleton::rigid),
      saturated_density_(input.mixture_density == MixtureDensity::saturated) {
  if (rigid_) {
    state_.first_volume = soil.particles().volume;
    state_.first_porosity = soil.particles().porosity;
  }
}

seepage::Skeleton Mixture::skeleton() const {
  seepage::Skeleton skeleton = view(soil.particles());
  if (rigid_) {
    skeleton.volume = state_.first_volume;
    skeleton.porosity = state_.first_porosity;
  }
  return skeleton;
}

solid::PoreState Mixture::pore_state() {
  weigh_water(water_mass_);
  return {water.pore_stress(), water_mass_};
}

std::vector<double> Mixture::water_mass() const {
  std::vector<double> mass;
  weigh_water(mass);
  return mass;
}

void Mixture::slow_down(double factor) {
  soil.particles().for_each_velocity([factor](std::vector<double>& field) {
    for (double& value : field) value *= factor;
  });
}

void Mixture::weigh_water(std::vector<double>& mass) const {
  const solid::Particles& p = soil.particles();
  const std::span<const double> saturation = water.saturation();
  const double density = water.water().density;
  mass.resize(p.size());
  for (std::size_t i = 0; i < mass.size(); ++i) {
    mass[i] = density * p.porosity[i] * (saturated_density_ ? 1.0 : saturation[i]) * p.volume[i];
  }
}

}  // namespace slope::couple
