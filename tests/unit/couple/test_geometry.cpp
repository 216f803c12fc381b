#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "case_folder.hpp"
#include "polygon.hpp"
#include "slope/couple/geometry.hpp"
#include "slope/couple/read_case.hpp"

namespace slope::couple::test {
namespace {

const std::vector<Point> unit_square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
const Domain two_by_two{{0.0, 0.0}, {2.0, 2.0}, 0.5, 4};

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
