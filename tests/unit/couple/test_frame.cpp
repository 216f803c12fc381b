// Copies of a case that were moved, or turned to their mirror image, are computed as one.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

#include "case/frame.hpp"
#include "case/polygon.hpp"
#include "case_folder.hpp"
#include "slope/couple/geometry.hpp"
#include "slope/couple/read_case.hpp"
#include "slope/couple/simulation.hpp"

namespace slope::couple::test {
namespace {

/// Everything of a case that has a place or a direction; sizes in cells of 0.5 m.
const char* const everything = R"(
domain: {lower: [0 m, 0 m], upper: [11 m, 6 m], cell_size: 0.5 m, particles_per_cell: 4}
walls: {left: friction, right: roller, base: fixed, left_friction: 0.4}
geometry:
  - {soil: clay, polygon: [[0 m, 0 m], [11 m, 0 m], [11 m, 5 m], [7.2 m, 5 m], [2.5 m, 1 m], [0 m, 1 m]]}
  - {soil: sand, polygon: [[8 m, 1.2 m], [10.1 m, 2 m], [9 m, 3 m]]}
initial: {water: {type: water_table, points: [[1 m, 0.5 m], [10 m, 2.25 m]]}}
water_boundaries:
  - {name: river, at: left, from: 0.25 m, to: 0.75 m, total_head: [[0 h, 0.5 m], [1 h, 0.75 m]], start: 1 s, ramp: 9 s}
  - {name: drain, at: base, from: 3 m, to: 5 m, free_drainage: true}
  - {name: rain, at: free_surface, from: 2 m, rain: {intensity: 3 mm/h}}
  - {name: lake, at: free_surface, to: 3.5 m, reservoir: {level: [[0 h, 1.4 m], [1 h, 0.6 m]]}}
loads: [{name: fill, at: ground_surface, from: 8 m, to: 9 m, traction: [1 kPa, -10 kPa]}]
seismic: {horizontal_coefficient: 0.1, vertical_coefficient: 0.05}
points: {toe: [2.5 m, 1 m], deep: [9.3 m, 2.1 m]}
safety: {times: [1 s], tolerance: 0.1, within: [[1 m, 0 m], [11 m, 0 m], [11 m, 5 m], [1 m, 3 m]]}
)";

/// The same, written down by hand as its mirror image in other coordinates: x from 500134.45 m leftwards, y from 404.1
/// m.
const char* const everything_elsewhere = R"(
domain: {lower: [500123.45 m, 404.1 m], upper: [500134.45 m, 410.1 m], cell_size: 0.5 m, particles_per_cell: 4}
walls: {left: roller, right: friction, base: fixed, right_friction: 0.4}
geometry:
  - soil: clay
    polygon: [[500127.25 m, 409.1 m], [500131.95 m, 405.1 m], [500134.45 m, 405.1 m], [500134.45 m, 404.1 m], [500123.45 m,
              404.1 m], [500123.45 m, 409.1 m]]
  - {soil: sand, polygon: [[500126.45 m, 405.3 m], [500124.35 m, 406.1 m], [500125.45 m, 407.1 m]]}
initial: {water: {type: water_table, points: [[500124.45 m, 406.35 m], [500133.45 m, 404.6 m]]}}
water_boundaries:
  - {name: river, at: right, from: 404.35 m, to: 404.85 m, total_head: [[0 h, 404.6 m], [1 h, 404.85 m]], start: 1 s, ramp: 9 s}
  - {name: drain, at: base, from: 500129.45 m, to: 500131.45 m, free_drainage: true}
  - {name: rain, at: free_surface, to: 500132.45 m, rain: {intensity: 3 mm/h}}
  - {name: lake, at: free_surface, from: 500130.95 m, reservoir: {level: [[0 h, 405.5 m], [1 h, 404.7 m]]}}
loads: [{name: fill, at: ground_surface, from: 500125.45 m, to: 500126.45 m, traction: [-1 kPa, -10 kPa]}]
seismic: {horizontal_coefficient: -0.1, vertical_coefficient: 0.05}
points: {toe: [500131.95 m, 405.1 m], deep: [500125.15 m, 406.2 m]}
safety: {times: [1 s], tolerance: 0.1, within: [[500133.45 m, 404.1 m], [500133.45 m, 407.1 m], [500123.45 m, 409.1 m],
                                                [500123.45 m, 404.1 m]]}
)";

const std::string rest = R"(
title: copies
soils:
  clay: &clay
    youngs_modulus: 10 MPa
    poissons_ratio: 0.33
    porosity: 0.35
    grain_density: 2.7 g/cm3
    strength: {model: drucker_prager, cohesion: 1 kPa, friction_angle: 25 deg, dilatancy_angle: 0 deg,
               maximum_cohesion_increase: 100 kPa, cohesion_suction_rate: 0.07, friction_angle_suction_rate: 0 deg}
    hydraulic_conductivity: 1e-4 m/s
    retention: {model: van_genuchten, alpha: 0.05 1/m, n: 3, residual_saturation: 0, maximum_saturation: 1}
    relative_permeability: {model: hillel, exponent: 2}
  sand: *clay
failure: {zone_deviatoric_strain: 1e-6, onset_displacement: 0.1 mm}
stop: {time: 2 s}
output: {history_interval: 0.5 s}
)";

Case read(const std::string& content) {
  const CaseFolder folder;
  return read_case(folder.write("case.yaml", content + rest));
}

/// The history and what is left at the end.
struct Outcome {
  std::vector<std::vector<double>> history;
  ParticleTable particles;
  Summary summary;
};

Outcome outcome_of(const Case& input) {
  Simulation simulation(input);
  simulation.initialise();
  Outcome outcome;
  outcome.history.push_back(simulation.history_row());
  for (Event event; !event.finished;) {
    event = simulation.advance();
    if (event.history) outcome.history.push_back(simulation.history_row());
    if (simulation.asks_for_safety()) simulation.find_safety();
  }
  outcome.particles = simulation.particles();
  outcome.summary = simulation.summary();
  return outcome;
}

TEST(Frame, HoldsTheSameCaseForEveryCopy) {
  const Case here = read(everything), there = read(everything_elsewhere);
  EXPECT_EQ(resolved_yaml(Frame(here).place(here)), resolved_yaml(Frame(there).place(there)));
}

TEST(Frame, LeavesACaseAtTheOriginAsItIs) {
  const Case here = read(everything);
  const Case placed = Frame(here).place(here);
  EXPECT_EQ(resolved_yaml(Frame(placed).place(placed)), resolved_yaml(placed));
  EXPECT_EQ(placed.initial_water.index(), here.initial_water.index());
  EXPECT_EQ(placed.points.at(1).position, here.points.at(1).position);
}

TEST(Frame, GivesCopiesTheSameHistoryAndTurnsTheRestBack) {
  const Outcome here = outcome_of(read(everything)), there = outcome_of(read(everything_elsewhere));
  EXPECT_EQ(here.history, there.history) << "to the last bit";
  ASSERT_EQ(here.particles.position.size(), there.particles.position.size());
  const auto& [a, b] = std::tie(here.particles, there.particles);
  for (std::size_t p = 0; p < a.position.size(); ++p) {
    EXPECT_NEAR(a.position[p][0], 500134.45 - b.position[p][0], 1e-9);
    EXPECT_NEAR(a.position[p][1], b.position[p][1] - 404.1, 1e-9);
    for (const auto member : {&ParticleTable::displacement, &ParticleTable::velocity, &ParticleTable::darcy_velocity}) {
      EXPECT_EQ((a.*member)[p][0], -(b.*member)[p][0]);
      EXPECT_EQ((a.*member)[p][1], (b.*member)[p][1]);
    }
    for (const auto member : {&ParticleTable::stress_effective, &ParticleTable::strain}) {
      EXPECT_EQ((a.*member)[p].xy, -(b.*member)[p].xy);
      EXPECT_EQ((a.*member)[p].xx, (b.*member)[p].xx);
    }
    EXPECT_EQ(a.soil[p], b.soil[p]);
  }
  ASSERT_GT(here.summary.zone_at_end.area, 0.0);
  EXPECT_NEAR(here.summary.zone_at_end.lowest, there.summary.zone_at_end.lowest - 404.1, 1e-9);
  const Slide &slide = here.summary.slide_at_end, &elsewhere = there.summary.slide_at_end;
  ASSERT_GT(slide.area, 0.0);
  EXPECT_EQ(slide.area, elsewhere.area);
  EXPECT_EQ(slide.direction, -elsewhere.direction);
  ASSERT_EQ(slide.toe.has_value(), elsewhere.toe.has_value());
  if (!slide.toe) return;
  EXPECT_NEAR((*slide.toe)[0], 500134.45 - (*elsewhere.toe)[0], 1e-9);
  EXPECT_NEAR((*slide.toe)[1], (*elsewhere.toe)[1] - 404.1, 1e-9);
}

/// A slope between two levels, its toe at x = 4 m: a face of some inclination, or another outline; all to the
/// millimetre, as a survey has them.
std::vector<Point> slope(double degrees) {
  const double height = 4.0,
               run = std::min(6.5, std::round(1000.0 * height / std::tan(degrees * std::numbers::pi / 180.0)) / 1000.0);
  return {{0, 0}, {12, 0}, {12, 5}, {4 + run, 5}, {4, 1}, {0, 1}};
}

/// A case of one or two soils, moved by so much and perhaps mirrored.
Case copy_of(std::vector<Region> regions, double cell_size, bool mirrored, const Point& by) {
  static const Case base = read(everything);
  Case input = base;
  input.walls = {};
  input.water_boundaries.clear();
  input.tractions.clear();
  input.points.clear();
  input.seismic = {};
  input.initial_water = HydrostaticWater{.water_table = by[1] + 0.5};
  input.domain = {by, {by[0] + 12.0, by[1] + 6.0}, cell_size, 4};
  for (Region& region : regions) {
    for (Point& corner : region.polygon) {
      corner = {by[0] + (mirrored ? 12.0 - corner[0] : corner[0]), by[1] + corner[1]};
    }
  }
  input.regions = std::move(regions);
  return input;
}

const std::vector<Point> places{{500123.4, 4649776.22}, {0.0, 404.0}, {9699459.75, 3.0}, {-17.3, -1234.567}};

TEST(FirstParticles, OfMovedAndMirroredCopiesAreTheSame) {
  std::map<std::string, std::vector<Region>> grounds;
  for (double degrees = 33.0; degrees < 89.0; degrees += 4.0) grounds[std::to_string(degrees)] = {{0, slope(degrees)}};
  grounds["45 degrees"] = {{0, slope(45.0)}};
  grounds["benches"] = {{0, {{0, 0}, {12, 0}, {12, 5}, {9.13, 5}, {7.4, 3.27}, {6.2, 3.27}, {4.05, 1.12}, {0, 1.12}}}};
  grounds["an overhang"] = {{0, {{0, 0}, {12, 0}, {12, 5}, {6.1, 5}, {7.3, 3.4}, {4, 1}, {0, 1}}}};
  grounds["two soils"] = {{0, slope(45.0)}, {1, {{0, 0}, {12, 0}, {12, 3.5}, {0, 0.35}}}};
  grounds["a lens"] = {{0, slope(36.0)}, {1, {{6, 1.1}, {9.2, 1.7}, {10.3, 2.6}, {8, 2.2}}}};
  grounds["a hill"] = {{0, {{0, 0}, {12, 0}, {12, 1}, {7.5, 4.1}, {4.5, 4}, {0, 1}}}};
  for (const auto& [name, regions] : grounds) {
    for (const double cell_size : {0.25, 0.4}) {
      const InitialParticles first = first_particles(copy_of(regions, cell_size, false, {0.0, 0.0}));
      bool mirrored = false;
      for (const Point& by : places) {
        mirrored = !mirrored;
        const InitialParticles copy = first_particles(copy_of(regions, cell_size, mirrored, by));
        ASSERT_EQ(copy.volume, first.volume) << name << ", cells of " << cell_size;
        ASSERT_EQ(copy.soil, first.soil) << name;
        for (std::size_t p = 0; p < first.x.size(); ++p) {
          const double x = copy.x[p] - by[0];
          ASSERT_NEAR(mirrored ? 12.0 - x : x, first.x[p], 1e-8) << name;
          ASSERT_NEAR(copy.y[p] - by[1], first.y[p], 1e-8) << name;
        }
      }
    }
  }
}

/// The face cuts every square that it meets in the same way.
TEST(FirstParticles, OfAStraightFaceFollowItRegularly) {
  const InitialParticles particles = first_particles(copy_of({{0, slope(45.0)}}, 0.2, false, {0.0, 0.0}));
  const double whole = particles.spacing * particles.spacing;
  const auto halves =
      std::ranges::count_if(particles.volume, [&](double v) { return std::abs(v / whole - 0.5) < 1e-6; });
  EXPECT_EQ(halves, 40) << "half of each of the squares on the diagonal";
  EXPECT_EQ(particles.x.size(), 1200u + 3200u - 800u + 20u) << "1 m of ground, 8 m of slope less the air before it";
}

/// What decides how a square is cut, or to which neighbour a part is joined, is not which of the copies it is: nor is
/// it where along the face.
TEST(FirstParticles, RepeatThemselvesAlongAFace) {
  for (const auto& [rise, run] :
       {std::pair{1, 1}, std::pair{1, 2}, std::pair{2, 3}, std::pair{3, 4}, std::pair{3, 2}}) {
    const double spacing = 0.1, cells = 12.0;
    const double height = cells * spacing * rise, length = cells * spacing * run;
    Domain domain{{0.0, 0.0}, {6.0, 6.0}, 0.2, 4};
    const InitialParticles particles =
        fill_regions(domain, {{0, {{0, 0}, {6, 0}, {6, 1 + height}, {1 + length, 1 + height}, {1, 1}, {0, 1}}}});
    std::map<std::pair<int, int>, double> volume;
    for (std::size_t p = 0; p < particles.x.size(); ++p)
      volume[{particles.column[p], particles.row[p]}] = particles.volume[p];
    for (const auto& [square, v] : volume) {
      const auto [column, row] = square;
      const auto next = volume.find({column + run, row + rise});
      const double x = particles.spacing * (column + 0.5) - 1.0;
      if (x < run * 2 * spacing || x > length - run * 3 * spacing || row < 10 + 2 * rise) continue;
      ASSERT_NE(next, volume.end()) << rise << ":" << run << " at " << column << ", " << row;
      EXPECT_NEAR(next->second, v, 1e-12);
    }
  }
}

}  // namespace
}  // namespace slope::couple::test
