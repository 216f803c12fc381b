// The slope W2, wet through (no suction anywhere), with its friction angle cut to 14 degrees: it slides metres within
// seconds, nearly undrained.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "run_case.hpp"
#include "slope/testing/record.hpp"

namespace slope::testing {
namespace {

constexpr double gravity = 9.81;                    // m/s2
constexpr double density = 0.65 * 2700.0 + 0.35e3;  // kg/m3, of the mixture as the case weighs it
constexpr double column_width = 0.5;                // m
constexpr double least_depth = 1.0;                 // m: above it the overburden is small against the noise

// Largest pore pressure over the weight of what lies above, among the particles deeper than least_depth below the
// ground; the ground of a column is its highest particle, or the level water that the toe's flat carries.
double pressure_over_overburden(const couple::ParticleTable& now) {
  std::map<long, double> surface;
  for (std::size_t p = 0; p < now.position.size(); ++p) {
    double& top = surface[std::lround(std::floor(now.position[p][0] / column_width))];
    top = std::max(top, now.position[p][1] + 0.125);
  }
  double largest = 0.0;
  for (std::size_t p = 0; p < now.position.size(); ++p) {
    const double depth = surface[std::lround(std::floor(now.position[p][0] / column_width))] - now.position[p][1];
    if (depth > least_depth) largest = std::max(largest, now.pore_pressure[p] / (density * gravity * depth));
  }
  return largest;
}

// Water in the pores (m2).
double all_water(const couple::ParticleTable& now) {
  double sum = 0.0;
  for (std::size_t p = 0; p < now.volume.size(); ++p) sum += now.porosity[p] * now.saturation[p] * now.volume[p];
  return sum;
}

TEST(FastSlide, KeepsItsPressureAndItsWater) {
  couple::Simulation simulation = start_shipped_case(
      "paper/slope-w2.yaml",
      {"soils.sandy_clay.strength.friction_angle=14 deg", "initial.water={type: uniform, pressure: 0 kPa}",
       "stop.displacement=3 m", "stop.time=20 s", "output.snapshot_interval=0.1 s"});
  double largest = 0.0, fastest = 0.0;
  run(simulation, [&](const couple::ParticleTable& now) {
    largest = std::max(largest, pressure_over_overburden(now));
    for (const couple::Point& v : now.velocity) fastest = std::max(fastest, std::hypot(v[0], v[1]));
  });
  const couple::Summary summary = simulation.summary();
  EXPECT_GT(fastest, 0.3);
  EXPECT_TRUE(record("fast-slide-1", "Fast slide (14 degrees): largest pore pressure over the total overburden",
                     at_most(1.2), largest, ""));
  const couple::WaterBudget& water = summary.water;
  // two seconds of infiltration are no measure: what the pressure step leaves to the next one is 1e-3 of them
  EXPECT_TRUE(record("fast-slide-2", "- water gained or lost over all that is in the slope", at_most(1.0e-6),
                     std::abs(water.infiltration - water.outflow - water.storage) / all_water(simulation.particles()),
                     ""));
}

}  // namespace
}  // namespace slope::testing
