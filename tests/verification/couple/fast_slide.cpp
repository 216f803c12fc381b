// The slope W2 with its friction angle cut to 14 degrees slides metres within seconds: nearly undrained, at real time.

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

TEST(FastSlide, KeepsItsPressureAndItsWater) {
  couple::Simulation simulation = start_shipped_case(
      "paper/slope-w2.yaml", {"soils.sandy_clay.strength.friction_angle=14 deg", "stop.displacement=3 m",
                              "stop.time=10 min", "output.snapshot_interval=0.2 s"});
  double largest = 0.0, fastest = 0.0, checkerboard = 0.0;
  run(simulation, [&](const couple::ParticleTable& now) {
    double ratio = pressure_over_overburden(now);
    double speed = 0.0;
    for (const couple::Point& v : now.velocity) speed = std::max(speed, std::hypot(v[0], v[1]));
    if (ratio > largest || speed > fastest) std::printf("t %.2f ratio %.3f speed %.3f\n", now.time, ratio, speed);
    largest = std::max(largest, ratio);
    fastest = std::max(fastest, speed);
  });
  const couple::Summary summary = simulation.summary();
  checkerboard = summary.pressure_checkerboard;
  std::printf("end %s %g cb %g steps %zu\n", summary.end_reason.c_str(), summary.time, checkerboard, summary.steps);
  EXPECT_GT(fastest, 0.3);
  EXPECT_TRUE(record("fast-slide-1", "Fast slide (14 degrees): largest pore pressure over the total overburden",
                     at_most(1.2), largest, ""));
  EXPECT_TRUE(record("fast-slide-2", "- water budget error over the infiltration", at_most(1.0e-4),
                     std::abs(summary.water.error), ""));
}

}  // namespace
}  // namespace slope::testing
