#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "case/cell_cut.hpp"
#include "case/polygon.hpp"
#include "case_folder.hpp"
#include "slope/couple/geometry.hpp"
#include "slope/couple/read_case.hpp"

namespace slope::couple::test {
namespace {

const std::vector<Point> unit_square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
const Domain two_by_two{{0.0, 0.0}, {2.0, 2.0}, 0.5, 4};

Domain clipped(Domain domain) {
  domain.surface_particles = SurfaceParticles::clipped;
  return domain;
}

double area_of(const InitialParticles& particles) {
  return std::accumulate(particles.volume.begin(), particles.volume.end(), 0.0);
}

TEST(Polygon, AreaIsPositiveAnticlockwise) {
  EXPECT_EQ(signed_area(unit_square), 1.0);
  EXPECT_EQ(signed_area({unit_square.rbegin(), unit_square.rend()}), -1.0);
  EXPECT_EQ(signed_area({{0, 0}, {1, 1}, {2, 2}}), 0.0);
  EXPECT_DOUBLE_EQ(signed_area({{1000, 1000}, {1004, 1000}, {1000, 1003}}), 6.0);
}

TEST(Polygon, ContainsItsInsideInEitherSense) {
  const std::vector<Point> notched{{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}};  // a V is cut into the top
  for (const auto& polygon : {notched, std::vector<Point>(notched.rbegin(), notched.rend())}) {
    EXPECT_TRUE(contains(polygon, {1, 1}, 0.0));
    EXPECT_TRUE(contains(polygon, {3.5, 2}, 0.0));
    EXPECT_FALSE(contains(polygon, {2, 2}, 0.0));
    EXPECT_FALSE(contains(polygon, {5, 1}, 0.0));
    EXPECT_FALSE(contains(polygon, {-1, 0}, 0.0)) << "level with a corner";
    EXPECT_TRUE(contains(polygon, {2, 1}, 1e-12)) << "a corner";
    EXPECT_TRUE(contains(polygon, {2, 0}, 1e-12)) << "an edge";
    EXPECT_TRUE(contains(polygon, {2, -0.1}, 0.11));
  }
}

TEST(Polygon, CrossingEdgesAreFound) {
  EXPECT_EQ(crossing_edges(unit_square), std::nullopt);
  EXPECT_EQ(crossing_edges({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), std::pair(std::size_t{0}, std::size_t{2}));
}

TEST(FillRegions, PutsASquareLatticeIntoEachCell) {
  for (const int per_cell : {1, 4, 9, 16}) {
    Domain domain = two_by_two;
    domain.particles_per_cell = per_cell;
    const auto particles = fill_regions(domain, {{0, {{0, 0}, {2, 0}, {2, 2}, {0, 2}}}});
    EXPECT_DOUBLE_EQ(particles.spacing, 0.5 / std::sqrt(per_cell));
    ASSERT_EQ(particles.x.size(), 16u * static_cast<unsigned>(per_cell));
    EXPECT_NEAR(area_of(particles), 4.0, 1e-12);
    EXPECT_DOUBLE_EQ(particles.x[0], 0.5 * particles.spacing);
    EXPECT_DOUBLE_EQ(particles.y[0], 0.5 * particles.spacing);
  }
}

TEST(FillRegions, GoesByCellsRowByRowFromBelow) {
  const auto particles = fill_regions(two_by_two, {{0, {{0, 0}, {2, 0}, {2, 2}, {0, 2}}}});
  const auto cell_of = [&](std::size_t p) {
    return std::floor(particles.y[p] / 0.5) * 4.0 + std::floor(particles.x[p] / 0.5);
  };
  for (std::size_t p = 0; p < particles.x.size(); ++p) EXPECT_EQ(cell_of(p), static_cast<double>(p / 4)) << p;
}

TEST(FillRegions, ALaterRegionOverwritesAnEarlierOne) {
  const auto particles = fill_regions(two_by_two, {{0, {{0, 0}, {2, 0}, {2, 2}, {0, 2}}}, {1, unit_square}});
  ASSERT_EQ(particles.x.size(), 64u);
  for (std::size_t p = 0; p < particles.x.size(); ++p) {
    EXPECT_EQ(particles.soil[p], particles.x[p] < 1.0 && particles.y[p] < 1.0 ? 1 : 0);
  }
}

TEST(FillRegions, RegionsThatTouchShareNoParticle) {
  const std::vector<Point> left{{0, 0}, {1.125, 0}, {1.125, 2}, {0, 2}};  // the border runs through lattice points
  const std::vector<Point> right{{1.125, 0}, {2, 0}, {2, 2}, {1.125, 2}};
  const auto particles = fill_regions(two_by_two, {{0, left}, {1, right}});
  EXPECT_EQ(particles.x.size(), 64u);
}

TEST(FillRegions, ThePapersSlopeHasThePrototypesParticles) {
  const Case input = read_case(shipped_cases() / "paper/slope-w2.yaml");
  const auto particles = fill_regions(input.domain, input.regions);
  EXPECT_EQ(particles.x.size(), 5089u);
  EXPECT_NEAR(area_of(particles), std::abs(signed_area(input.regions.at(0).polygon)), 0.003 * area_of(particles));
}

/// Area and first moments of a polygon (m2, m3), by Green's theorem.
std::array<double, 3> moments_of(const std::vector<Point>& polygon) {
  std::array<double, 3> moments{};
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point& a = polygon[i];
    const Point& b = polygon[(i + 1) % polygon.size()];
    const double twice = a[0] * b[1] - b[0] * a[1];
    moments[0] += twice / 2.0;
    moments[1] += twice * (a[0] + b[0]) / 6.0;
    moments[2] += twice * (a[1] + b[1]) / 6.0;
  }
  if (moments[0] < 0.0) std::transform(moments.begin(), moments.end(), moments.begin(), std::negate<>());
  return moments;
}

std::array<double, 3> moments_of(const InitialParticles& particles) {
  std::array<double, 3> moments{};
  for (std::size_t p = 0; p < particles.x.size(); ++p) {
    moments[0] += particles.volume[p];
    moments[1] += particles.volume[p] * particles.x[p];
    moments[2] += particles.volume[p] * particles.y[p];
  }
  return moments;
}

/// A polygon with a corner in each of so many directions, at random distances from its middle: not convex.
std::vector<Point> random_star(std::mt19937& generator, const Point& middle, double reach) {
  std::uniform_real_distribution<double> distance(0.4 * reach, reach);
  std::uniform_int_distribution<int> count(3, 12);
  const int corners = count(generator);
  std::vector<Point> polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / corners, r = distance(generator);
    polygon.push_back({middle[0] + r * std::cos(angle), middle[1] + r * std::sin(angle)});
  }
  return polygon;
}

TEST(CutCell, HasTheAreaTheCentroidAndTheSidesOfATriangle) {
  const std::vector<Edge> edges{{{0.0, 0.0}, {2.0, 0.0}, 0}, {{0.0, 0.0}, {2.0, 1.0}, 0}};  // its third is vertical
  const CellCut cut = cut_cell({1.0, 0.0}, 1.0, edges, 1);
  EXPECT_DOUBLE_EQ(cut.area, 0.75);
  EXPECT_DOUBLE_EQ(cut.centroid[0], 1.0 + 5.0 / 9.0);
  EXPECT_DOUBLE_EQ(cut.centroid[1], 7.0 / 18.0);
  EXPECT_DOUBLE_EQ(cut.contact[0], 0.5);
  EXPECT_DOUBLE_EQ(cut.contact[1], 1.0);
  EXPECT_DOUBLE_EQ(cut.contact[2], 1.0);
  EXPECT_EQ(cut.contact[3], 0.0);
}

TEST(CutCell, ALaterRegionTakesFromAnEarlierOne) {
  const std::vector<Edge> edges{{{0.0, 0.0}, {1.0, 0.0}, 0},
                                {{0.0, 0.5}, {1.0, 0.5}, 0},
                                {{0.0, 1.0}, {1.0, 0.0}, 1},  // above the falling diagonal, below y = 2
                                {{0.0, 2.0}, {1.0, 2.0}, 1}};
  const CellCut cut = cut_cell({0.0, 0.0}, 1.0, edges, 2);
  EXPECT_DOUBLE_EQ(cut.share[0], 0.375);
  EXPECT_DOUBLE_EQ(cut.share[1], 0.5);
  EXPECT_DOUBLE_EQ(cut.area, 0.875);
}

TEST(ClippedParticles, HaveTheAreaAndTheCentroidOfAnyPolygon) {
  std::mt19937 generator(7);
  for (int trial = 0; trial < 200; ++trial) {
    const Domain domain = clipped({{-1.0, 2.0}, {1.0, 4.0}, 0.25, trial % 2 == 0 ? 4 : 9});
    const std::vector<Point> polygon = random_star(generator, {0.0, 3.0}, 0.95);
    const auto wanted = moments_of(polygon);
    const auto particles = fill_regions(domain, {{0, polygon}});
    const auto reached = moments_of(particles);
    EXPECT_NEAR(reached[0], wanted[0], 1.0e-13);
    EXPECT_NEAR(reached[1], wanted[1], 1.0e-13);
    EXPECT_NEAR(reached[2], wanted[2], 1.0e-12);
    const double whole = particles.spacing * particles.spacing;
    EXPECT_GE(*std::min_element(particles.volume.begin(), particles.volume.end()), whole / 2.0) << "no sliver";
    EXPECT_LE(*std::max_element(particles.volume.begin(), particles.volume.end()), 3.0 * whole);
  }
}

TEST(ClippedParticles, OfRegionsThatOverlapHaveTheAreaOfTheirUnion) {
  const std::vector<Point> low{{0, 0}, {2, 0}, {2, 1.1}, {0, 0.3}};
  const std::vector<Point> lens{{0.3, 0.2}, {1.7, 0.6}, {1.5, 0.7}, {0.4, 0.4}};
  const std::vector<Point> square_above{{1.2, 0.9}, {1.9, 0.9}, {1.9, 1.7}, {1.2, 1.7}};  // half of it is in the air
  const auto particles = fill_regions(clipped(two_by_two), {{0, low}, {1, lens}, {2, square_above}});
  const double shared = 0.5 * 0.4 * 0.16;  // of low and the square above: below y = 0.3 + 0.4 x, right of x = 1.5
  EXPECT_NEAR(area_of(particles), signed_area(low) + signed_area(square_above) - shared, 1.0e-13);
}

TEST(ClippedParticles, OfALatticeAlignedRegionAreThoseOfTheLattice) {
  const std::vector<Region> regions{{0, {{0, 0}, {2, 0}, {2, 1.5}, {0.75, 1.5}, {0.75, 1}, {0, 1}}}, {1, unit_square}};
  for (const int per_cell : {1, 4, 9, 16}) {
    Domain domain{{0.0, 0.0}, {2.0, 2.0}, 0.25, per_cell};
    domain.surface_particles = SurfaceParticles::lattice;
    const auto lattice = fill_regions(domain, regions);
    const auto exact = fill_regions(clipped(domain), regions);
    EXPECT_EQ(exact.x, lattice.x);
    EXPECT_EQ(exact.y, lattice.y);
    EXPECT_EQ(exact.volume, lattice.volume);
    EXPECT_EQ(exact.soil, lattice.soil);
    EXPECT_EQ(lattice.face_distance, std::vector<double>(lattice.x.size(), 0.5 * lattice.spacing));
    for (const double distance : exact.face_distance) EXPECT_NEAR(distance, 0.5 * exact.spacing, 1e-12);
  }
}

TEST(ClippedParticles, OfFlatGroundBetweenLatticeLinesLieHalfTheirHeightBelowIt) {
  for (const double height : {1.05, 1.1, 1.2, 1.24}) {
    const auto particles = fill_regions(clipped(two_by_two), {{0, {{0, 0}, {2, 0}, {2, height}, {0, height}}}});
    const auto surface = particles_at({Place::ground_surface}, particles);
    ASSERT_EQ(surface.size(), 8u);
    for (const std::size_t p : surface) {
      EXPECT_NEAR(particles.y[p] + particles.face_distance[p], height, 1.0e-12) << "the face is the ground";
    }
  }
}

/// A slope of some inclination across a domain of 6 m, 3 m of soil at its foot.
Case slope_of(double gradient) {
  Case input;
  input.domain = {{0.0, 0.0}, {6.0, 20.0}, 0.5, 4};
  input.regions = {{0, {{0, 0}, {6, 0}, {6, 3 + 6 * gradient}, {0, 3}}}};
  return input;
}

TEST(FacesAt, AreTheGroundAsItIsDrawn) {
  for (const double gradient : {0.0, 0.1, 0.35, 0.577, 1.0, 1.3, 2.5}) {
    const Case input = slope_of(gradient);
    const auto particles = fill_regions(input.domain, input.regions);
    double width = 0.0;
    for (const Face& face : faces_at({Place::ground_surface}, input, particles)) {
      const double x = particles.x[face.particle], y = particles.y[face.particle];
      const Point foot{x + face.distance * face.normal[0], y + face.distance * face.normal[1]};
      EXPECT_NEAR(foot[1], 3 + gradient * foot[0], 1e-12) << gradient;
      EXPECT_NEAR(y + face.outwards, 3 + gradient * x, 1e-12);
      EXPECT_NEAR(std::hypot(face.normal[0], face.normal[1]), 1.0, 1e-12);
      EXPECT_NEAR(particles.face_distance[face.particle], face.distance, 1e-12);
      width += face.area * face.normal[1];
    }
    EXPECT_NEAR(width, 6.0, 1e-12) << "seen from above";
  }
}

TEST(FacesAt, OfASideAndTheBaseAreTheirOutlines) {
  Case input = slope_of(0.5);
  input.regions = {{0, {{0.3, 0.1}, {6, 0.1}, {6, 3}, {0.8, 3}}}};
  const auto particles = fill_regions(input.domain, input.regions);
  double height = 0.0;
  for (const Face& face : faces_at({Place::left}, input, particles)) {
    const double x = particles.x[face.particle], y = particles.y[face.particle];
    const Point foot{x + face.distance * face.normal[0], y + face.distance * face.normal[1]};
    EXPECT_NEAR(foot[0], 0.3 + 0.5 * (foot[1] - 0.1) / 2.9, 1e-12);
    EXPECT_LT(face.normal[0], 0.0);
    height -= face.area * face.normal[0];
  }
  EXPECT_NEAR(height, 3.0, 1e-12) << "of twelve rows";
  for (const Face& face : faces_at({Place::base}, input, particles)) {
    EXPECT_NEAR(particles.y[face.particle] - face.distance, 0.1, 1e-12);
    EXPECT_EQ(face.normal[1], -1.0);
  }
}

TEST(ClippedParticles, FollowThePapersSlopeWithoutSteps) {
  const Case input = read_case(shipped_cases() / "paper/slope-w2.yaml", {"domain.surface_particles=clipped"});
  const auto particles = fill_regions(input.domain, input.regions);
  EXPECT_NEAR(area_of(particles), std::abs(signed_area(input.regions.at(0).polygon)), 1.0e-10);
  const auto surface = particles_at({Place::ground_surface}, particles);
  ASSERT_EQ(surface.size(), 144u);
  double least = 1.0, largest = 0.0;
  for (const std::size_t p : surface) {
    const double ground = particles.x[p] < 10.0 ? 5.0 : std::min(12.0, 5.0 + (particles.x[p] - 10.0) / 1.8);
    least = std::min(least, ground - particles.y[p]);
    largest = std::max(largest, ground - particles.y[p]);
  }
  EXPECT_GT(least, 0.05);
  EXPECT_LT(largest, 0.22) << "the lattice's steps reach 0.25 m";
}

TEST(ClippedParticles, AnInterfaceFollowsTheLatticeAndKeepsTheTotal) {
  const std::vector<Point> under{{0, 0}, {2, 0}, {2, 1.4}, {0, 0.6}};
  const auto particles = fill_regions(clipped(two_by_two), {{0, {{0, 0}, {2, 0}, {2, 2}, {0, 2}}}, {1, under}});
  EXPECT_EQ(particles.x.size(), 64u);
  double lower = 0.0;
  for (std::size_t p = 0; p < particles.x.size(); ++p) {
    EXPECT_EQ(particles.volume[p], 0.0625);
    if (particles.soil[p] == 1) lower += particles.volume[p];
  }
  EXPECT_NEAR(lower, signed_area(under), 1.0e-12) << "what one column has too much, another lacks";
}

TEST(ClippedParticles, ASpeckThatTouchesNothingIsKept) {
  const auto particles = fill_regions(clipped(two_by_two), {{0, {{0.6, 0.6}, {0.65, 0.6}, {0.65, 0.65}}}});
  ASSERT_EQ(particles.x.size(), 1u);
  EXPECT_NEAR(particles.volume[0], 0.00125, 1.0e-15);
}

TEST(ParticlesAt, TheGroundSurfaceIsTheUppermostOfEachColumn) {
  const Case input = read_case(shipped_cases() / "paper/slope-w2.yaml");
  const auto particles = fill_regions(input.domain, input.regions);
  const auto surface = particles_at({Place::ground_surface}, particles);
  ASSERT_EQ(surface.size(), 144u);
  for (std::size_t i = 0; i < surface.size(); ++i) {
    const double x = particles.x[surface[i]];
    EXPECT_NEAR(x, 0.125 + 0.25 * static_cast<double>(i), 1e-9);
    const double ground = x < 10.0 ? 5.0 : std::min(12.0, 5.0 + (x - 10.0) / 1.8);
    EXPECT_LE(particles.y[surface[i]], ground + 1e-9);
    EXPECT_GT(particles.y[surface[i]], ground - 0.25 - 1e-9);
  }
}

TEST(ParticlesAt, TheOtherPlacesAreTheLowestAndTheOutermost) {
  const auto particles = fill_regions(two_by_two, {{0, {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}}});
  const auto all_have = [&](const std::vector<std::size_t>& chosen, const std::vector<double>& coordinate,
                            double value) {
    return std::all_of(chosen.begin(), chosen.end(),
                       [&](std::size_t p) { return std::abs(coordinate[p] - value) < 1e-12; });
  };
  const auto base = particles_at({Place::base}, particles);
  EXPECT_EQ(base.size(), 8u);
  EXPECT_TRUE(all_have(base, particles.y, 0.125));
  const auto left = particles_at({Place::left}, particles);
  EXPECT_EQ(left.size(), 8u);
  EXPECT_TRUE(all_have(left, particles.x, 0.125));
  const auto right = particles_at({Place::right}, particles);
  EXPECT_EQ(right.size(), 8u) << "the upper rows end at the step";
  EXPECT_TRUE(all_have(particles_at({Place::right, 1.0, never}, particles), particles.x, 0.875));
}

TEST(ParticlesAt, ARangeLimitsThem) {
  const auto particles = fill_regions(two_by_two, {{0, {{0, 0}, {2, 0}, {2, 2}, {0, 2}}}});
  EXPECT_EQ(particles_at({Place::ground_surface, 0.5, 1.0}, particles).size(), 2u);
  EXPECT_EQ(particles_at({Place::left, -never, 0.5}, particles).size(), 2u);
  EXPECT_TRUE(particles_at({Place::base, 3.0, never}, particles).empty());
  EXPECT_TRUE(particles_at({Place::base}, {}).empty());
}

}  // namespace
}  // namespace slope::couple::test
