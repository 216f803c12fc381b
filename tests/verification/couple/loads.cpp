// Surcharge, earthquake, friction at the base, and K0 initial stress, from case files.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "run_case.hpp"
#include "slope/testing/record.hpp"

namespace slope::testing {
namespace {

constexpr double gravity = 9.81;
constexpr double density = 0.65 * 2700.0 + 350.0;

couple::ParticleTable end_of(couple::Simulation simulation) {
  run(simulation, [](const couple::ParticleTable&) {});
  return simulation.particles();
}

double mean_displacement(const couple::ParticleTable& table) {
  double sum = 0.0;
  for (const couple::Point& u : table.displacement) sum += u[0];
  return sum / static_cast<double>(table.displacement.size());
}

TEST(Surcharge, CompressesTheGroundByItsPressure) {
  const double load = 20.0e3, height = 2.0;
  const couple::ParticleTable table = end_of(
      start_case("ground.yaml", {"loads=[{name: fill, at: ground_surface, traction: [0 kPa, -20 kPa], ramp: 3 s}]",
                                 "soils.sand.strength={model: elastic}", "clock.adaptive=false", "stop.time=4 s"}));
  double settlement = 0.0;
  for (const couple::Point& u : table.displacement) settlement = std::max(settlement, -u[1]);
  // the uppermost particles lie a quarter of a cell below the surface
  const double expected = load * (height - 0.0625) / solid::Elastic{10.0e6, 0.33}.constrained_modulus();
  EXPECT_TRUE(record("surcharge-settlement", "Surcharge of 20 kPa on level ground: settlement (q H / M)",
                     near(1e3 * expected, 1e1 * expected), 1e3 * settlement, "mm"));
}

constexpr double ramp = 0.2, end = 0.7;  // s
constexpr double friction = 0.2;

// A layer 2 m long, a quarter as high, free at both ends, on a base with friction.
couple::ParticleTable shaken(const std::string& coefficient) {
  return end_of(start_case(
      "ground.yaml",
      {"domain.upper=[4 m, 1 m]", "geometry.0.polygon=[[1 m, 0 m], [3 m, 0 m], [3 m, 0.5 m], [1 m, 0.5 m]]",
       "walls={left: free, right: free, base: friction, base_friction: 0.2}", "soils.sand.strength={model: elastic}",
       "output.history_interval=10 s", "seismic={ramp: 0.2 s, horizontal_coefficient: " + coefficient + "}",
       "clock.adaptive=false", "stop.time=0.7 s"}));
}

// How far a rigid layer slides: it starts when the coefficient on its ramp passes that of friction.
double way_of(double coefficient) {
  const double sliding = ramp * (1.0 - friction / coefficient), after = end - ramp;
  const double growth = coefficient * gravity / ramp;
  return growth * sliding * sliding * (sliding / 6.0 + after / 2.0) +
         0.5 * (coefficient - friction) * gravity * after * after;
}

TEST(Seismic, ShakesALayerOffItsBase) {
  const double expected = way_of(0.6);
  EXPECT_TRUE(record("seismic-slide", "Layer on a frictional base (0.2) under k_h = 0.6: way after 0.7 s",
                     near(1e3 * expected, 2e1 * expected), 1e3 * mean_displacement(shaken("0.6")), "mm"));
  EXPECT_NEAR(mean_displacement(shaken("-0.6")), -expected, 0.02 * expected) << "towards -x";
  EXPECT_NEAR(mean_displacement(shaken("0.1")), 0.0, 0.01 * expected) << "sticks";
}

struct FieldBlock {
  std::string friction, push, lift, left_end;
  double way, speed;  // of a rigid block after 1.5 s
};

// An earthquake that acts in full from the start is in the initial stress: no wave has to bring the friction.
TEST(Seismic, SlidesABlockFromTheStart) {
  double way = 0.0, speed = 0.0;
  for (const FieldBlock& block :
       {FieldBlock{"0.2", "0.6", "0", "1 m", 4.4145, 5.886}, FieldBlock{"0.5", "0.6", "0", "2 m", 1.1036, 1.4715},
        FieldBlock{"0.6", "0.7", "0", "2 m", 1.1036, 1.4715}, FieldBlock{"0.4", "0.5", "0.3", "2 m", 2.4280, 3.2373}}) {
    const std::string left = block.left_end, right = left == "1 m" ? "3 m" : "4 m";
    const couple::ParticleTable table = end_of(start_case(
        "ground.yaml",
        {"domain.upper=[14 m, 3 m]",
         "geometry.0.polygon=[[" + left + ", 0 m], [" + right + ", 0 m], [" + right + ", 1 m], [" + left + ", 1 m]]",
         "walls={left: free, right: free, base: friction, base_friction: " + block.friction + "}",
         "soils.sand.strength={model: elastic}", "soils.sand.poissons_ratio=0.3",
         "seismic={horizontal_coefficient: " + block.push + ", vertical_coefficient: " + block.lift + "}",
         "clock.adaptive=false", "stop.time=1.5 s"}));
    double mean_speed = 0.0;
    for (const couple::Point& v : table.velocity) mean_speed += v[0] / static_cast<double>(table.velocity.size());
    way = std::max(way, std::abs(mean_displacement(table) / block.way - 1.0));
    speed = std::max(speed, std::abs(mean_speed / block.speed - 1.0));
  }
  EXPECT_TRUE(record("seismic-slide-blocks-1", "Four blocks under an earthquake from the start: error of the way",
                     at_most(0.02), way, "%"));
  EXPECT_TRUE(record("seismic-slide-blocks-2", "Four blocks under an earthquake from the start: error of the speed",
                     at_most(0.02), speed, "%"));
}

// Over all particles: largest difference of the horizontal over the vertical effective stress from the ratio asked for.
double ratio_error(const couple::ParticleTable& table, double ratio) {
  double error = 0.0;
  for (const couple::PlaneTensor& stress : table.stress_effective) {
    error = std::max({error, std::abs(stress.xx / stress.yy - ratio), std::abs(stress.zz / stress.yy - ratio)});
  }
  return error;
}

TEST(InitialStress, KeepsTheRatioOnLevelGround) {
  couple::Simulation given = start_case("ground.yaml", {"initial.stress=k0", "initial.k0_coefficient=0.8"});
  EXPECT_TRUE(record("k0-level-ground", "Level ground, K0 = 0.8: error of the stress ratio", at_most(1e-3),
                     ratio_error(given.particles(), 0.8), ""));
  couple::Simulation jaky = start_case("ground.yaml", {"initial.stress=k0"});
  EXPECT_LT(ratio_error(jaky.particles(), 0.5), 1e-3);
  EXPECT_LT(jaky.summary().initial_unbalanced_ratio, 1e-6);
  couple::Simulation wet =
      start_case("ground.yaml", {"initial.stress=k0", "initial.water={type: hydrostatic, water_table: 1 m}"});
  EXPECT_LT(ratio_error(wet.particles(), 0.5), 1e-3);
  const couple::ParticleTable table = wet.particles();
  double error = 0.0;  // the pore pressure acts by its average over a cell
  for (std::size_t p = 0; p < table.position.size(); ++p) {
    const double total = density * gravity * (2.0 - table.position[p][1]);
    const double pore = table.pore_pressure[p] * table.saturation[p];
    error = std::max(error, std::abs(table.stress_effective[p].yy + total - pore));
  }
  EXPECT_LT(error, 0.04 * density * gravity * 2.0);
}

TEST(InitialStress, IsInBalanceUnderASlopeToo) {
  couple::Simulation slope = start_shipped_case("quick.yaml", {"initial.stress=k0", "initial.k0_coefficient=0.7"});
  EXPECT_LT(slope.summary().initial_unbalanced_ratio, 1e-5);
}

}  // namespace
}  // namespace slope::testing
