// Saturated, undrained soil that shears at constant volume keeps its pore pressure: under load, where the mean total
// stress stays what it was, and in free flight, as far as the shear goes.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "block.hpp"
#include "run/mixture.hpp"
#include "run/semi_implicit_scheme.hpp"
#include "slope/testing/record.hpp"

namespace slope::testing {
namespace {

constexpr double size = 1.0, cell_size = 0.1;  // m
constexpr double pressure = 20.0e3;            // Pa, at the start
constexpr double edge = 2.0 * cell_size;       // beside the loaded sides, where the stress is not uniform

// Without gravity, and tight: nothing flows.
Block tight_block() {
  Block block(size, size, cell_size, 4.0 * cell_size);
  block.input.gravity = 1.0e-6;
  couple::Soil& soil = block.input.soils[0];
  soil.seepage.hydraulic_conductivity = 1.0e-12;
  soil.seepage.retention = seepage::VanGenuchten{.alpha = 1.0e-12, .n = 3.0, .range = {}};
  return block;
}

// Squeezed from above as much as it is relieved at its side. @return largest change of the pressure over the shear
// stress
double change_under_load(double youngs_modulus, double ramp) {
  const double last_shear = 40.0e3, effective_stress = 50.0e3;
  Block block = tight_block();
  solid::Elastic& elastic = block.input.soils[0].solid.elastic;
  elastic.youngs_modulus = youngs_modulus;
  const couple::InitialParticles particles = block.particles();
  const std::size_t count = particles.x.size();
  couple::Mixture mixture(block.input, particles, std::vector<double>(count, pressure), 1);
  solid::Particles& soil = mixture.soil.particles();
  for (auto* stress : {&soil.sxx, &soil.syy, &soil.szz}) stress->assign(count, -effective_stress);
  const auto top = couple::particles_at({couple::Place::ground_surface}, particles);
  const auto right = couple::particles_at({couple::Place::right}, particles);
  const double face = 0.5 * particles.spacing, total = effective_stress + pressure;
  couple::SemiImplicitScheme scheme(block.input.numerics.pressure_tolerance);
  const double time_step = couple::SemiImplicitScheme::stable_step(mixture, block.input.numerics.courant_number);
  double largest = 0.0;
  couple::Actions actions;
  for (double time = 0.0; time < 1.25 * ramp; time += time_step) {
    const double shear = last_shear * (0.5 - 0.5 * std::cos(std::numbers::pi * std::min(1.0, time / ramp)));
    // a traction acts on the side as it was, the stress on the side as it is
    const double stretch = std::exp(shear / (2.0 * elastic.shear_modulus()));
    actions.tractions.clear();
    for (const std::size_t p : top) actions.tractions.push_back({p, 0.0, -(total + shear) * stretch, 0.0, face});
    for (const std::size_t p : right) actions.tractions.push_back({p, -(total - shear) / stretch, 0.0, face, 0.0});
    scheme.step(mixture, actions, time_step, 1.0);
    for (std::size_t p = 0; p < count; ++p) {
      if (std::max(particles.x[p], particles.y[p]) > size - edge) continue;
      largest = std::max(largest, std::abs(mixture.water.pressure()[p] - pressure) / last_shear);
    }
  }
  return largest;
}

struct Flight {
  double pressure = 0.0;  // largest change over what it was
  double porosity = 0.0;  // largest change
  double water = 0.0;     // change of all the water over what it was
};

// The skeleton is next to nothing and its tension balances the pressure: v = rate (y, 0) goes on as it began.
Flight shear_in_flight(double last_shear) {
  Block block = tight_block();
  couple::Case& input = block.input;
  input.domain.lower = {-4.0 * cell_size, -4.0 * cell_size};
  input.domain.upper = {2.5 * size, 1.5 * size};
  input.walls.left = input.walls.right = input.walls.base = couple::Wall::free;
  input.soils[0].solid.elastic.youngs_modulus = 1.0;
  const couple::InitialParticles particles = block.particles();
  const std::size_t count = particles.x.size();
  couple::Mixture mixture(input, particles, std::vector<double>(count, pressure), 1);
  solid::Particles& soil = mixture.soil.particles();
  for (auto* stress : {&soil.sxx, &soil.syy, &soil.szz}) stress->assign(count, pressure);
  const double rate = 1.0, time_step = 2.0e-3;
  for (std::size_t p = 0; p < count; ++p) soil.vx[p] = rate * soil.y[p];
  soil.cxy.assign(count, rate);

  const double first_water = mixture.water.stored_water();
  couple::SemiImplicitScheme scheme(input.numerics.pressure_tolerance);
  Flight flight;
  for (double time = 0.0; rate * time < last_shear; time += time_step) scheme.step(mixture, {}, time_step, 1.0);
  for (std::size_t p = 0; p < count; ++p) {
    EXPECT_NEAR(soil.ux[p], last_shear * particles.y[p], 0.01 * size);
    flight.pressure = std::max(flight.pressure, std::abs(mixture.water.pressure()[p] / pressure - 1.0));
    flight.porosity = std::max(flight.porosity, std::abs(soil.porosity[p] - input.soils[0].porosity));
  }
  flight.water = std::abs(mixture.water.stored_water() / first_water - 1.0);
  return flight;
}

TEST(ShearedBlock, KeepsItsPressureUnderLoad) {
  EXPECT_TRUE(record("sheared-block-1",
                     "Saturated block under shear stress q, undrained: change of pore pressure over q", at_most(0.01),
                     change_under_load(10.0e6, 1.0), "%"));
  EXPECT_TRUE(record("sheared-block-2", "- soft, to strains of 5 %: its loaded sides move by half a cell",
                     at_most(0.15), change_under_load(1.0e6, 2.0), "%"));
}

TEST(ShearedBlock, KeepsItsPressureHoweverFarItShears) {
  const Flight flight = shear_in_flight(1.0);
  EXPECT_TRUE(record("sheared-block-3", "- free flight to a shear of 1: change of pore pressure", at_most(0.01),
                     flight.pressure, "%"));
  EXPECT_TRUE(record("sheared-block-4", "- change of porosity", at_most(1.0e-4), flight.porosity, ""));
  EXPECT_TRUE(record("sheared-block-5", "- change of the water in the block", at_most(1.0e-6), flight.water, ""));
}

}  // namespace
}  // namespace slope::testing
