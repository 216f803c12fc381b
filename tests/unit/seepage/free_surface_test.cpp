#include "slope/seepage/free_surface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "particles.hpp"

namespace slope::seepage {
namespace {

using testing::lattice;
using testing::Particles;

constexpr double spacing = 0.25;

// Those particles of a lattice for which a condition on their place holds.
Particles carved(const Particles& from, const std::function<bool(double x, double y)>& stays) {
  Particles result;
  for (std::size_t p = 0; p < from.size(); ++p) {
    if (!stays(from.x[p], from.y[p])) continue;
    result.x.push_back(from.x[p]);
    result.y.push_back(from.y[p]);
    result.volume.push_back(from.volume[p]);
    result.porosity.push_back(from.porosity[p]);
  }
  return result;
}

FreeSurface found(const Particles& particles, const MirrorWalls& walls) {
  FreeSurface surface(spacing, walls);
  EXPECT_TRUE(surface.update(particles.skeleton()));
  return surface;
}

double total_width(const FreeSurface& surface) {
  double sum = 0.0;
  for (const SurfacePiece& piece : surface.pieces()) sum += piece.width;
  return sum;
}

TEST(FreeSurface, OfAFlatLatticeGivesEachTopParticleOneSpacing) {
  const Particles block = lattice(20, 8, spacing);
  const FreeSurface surface = found(block, {.left = 0.0, .right = 20 * spacing, .base = 0.0});
  ASSERT_EQ(surface.pieces().size(), 20U);
  for (std::size_t k = 0; k < 20; ++k) {
    const SurfacePiece& piece = surface.pieces()[k];
    EXPECT_EQ(piece.particle, 7 * 20 + k);
    EXPECT_NEAR(piece.area, spacing, 1e-12);
    EXPECT_NEAR(piece.width, spacing, 1e-12);
    EXPECT_NEAR(piece.nx, 0.0, 1e-12);
    EXPECT_NEAR(piece.ny, 1.0, 1e-12);
  }
}

TEST(FreeSurface, OfAVerticalFaceGetsNoRainButLetsWaterOut) {
  const Particles block = lattice(12, 16, spacing);
  const FreeSurface surface = found(block, {.left = 0.0, .base = 0.0});
  ASSERT_EQ(surface.pieces().size(), 12U + 15U);
  for (const SurfacePiece& piece : surface.pieces()) {
    const bool top = block.y[piece.particle] > 15 * spacing, side = block.x[piece.particle] > 11 * spacing;
    EXPECT_NEAR(piece.width, top ? spacing : 0.0, 1e-12);
    EXPECT_NEAR(piece.area, spacing * (top && side ? 1.765 : 1.0), 0.001 * spacing);
    EXPECT_NEAR(piece.nx, top && side ? std::sqrt(0.5) : side ? 1.0 : 0.0, 1e-12);
    EXPECT_NEAR(piece.ny, top && side ? std::sqrt(0.5) : top ? 1.0 : 0.0, 1e-12);
  }
}

class Inclined : public ::testing::TestWithParam<double> {};

// height of the surface over its length: the lattice has steps there
TEST_P(Inclined, GetsRainPerHorizontalMetre) {
  const double length = 10.0, steepness = GetParam();
  const Particles slope = carved(lattice(40, 60, spacing), [&](double x, double y) { return y < 2.0 + steepness * x; });
  const FreeSurface surface = found(slope, {.left = 0.0, .right = length, .base = 0.0});
  std::map<int, double> highest;
  for (std::size_t p = 0; p < slope.size(); ++p) {
    double& top = highest[static_cast<int>(slope.x[p] / spacing)];
    top = std::max(top, slope.y[p]);
  }
  double nx = 0.0, ny = 0.0;
  for (const SurfacePiece& piece : surface.pieces()) {
    const bool top = slope.y[piece.particle] == highest.at(static_cast<int>(slope.x[piece.particle] / spacing));
    EXPECT_NEAR(piece.width, top ? spacing : 0.0, 1e-12);
    nx += piece.area * piece.nx;
    ny += piece.area * piece.ny;
  }
  EXPECT_NEAR(total_width(surface), length, 1e-12);
  EXPECT_NEAR(ny, length, 0.05 * length) << "the pieces follow the surface";
  EXPECT_NEAR(-nx, steepness * length, 0.05 * length);
}
INSTANTIATE_TEST_SUITE_P(Surfaces, Inclined, ::testing::Values(0.25, 1.0 / 1.8, 1.0), [](const auto& instance) {
  return "Percent" + std::to_string(std::lround(100.0 * instance.param));
});

TEST(FreeSurface, IsShadedByOverhangsAndBlocks) {
  // a ground 2 m high, 6 m long; a block that lies free above 2 m to 4 m; a step with an overhang from 5 m on
  const Particles broken = carved(lattice(24, 24, spacing), [](double x, double y) {
    const bool ground = y<2.0, block = x> 2.0 && x < 4.0 && y > 3.0 && y < 4.0;
    const bool roof = x > 5.0 && y > 4.0, pillar = x > 5.5;
    return ground || block || roof || pillar;
  });
  const FreeSurface surface = found(broken, {.left = 0.0, .right = 6.0, .base = 0.0});
  EXPECT_NEAR(total_width(surface), 6.0, 1e-12);
  for (const SurfacePiece& piece : surface.pieces()) {
    const double x = broken.x[piece.particle], y = broken.y[piece.particle];
    const bool open_ground = y > 1.75 && y < 2.0 && (x < 2.0 || (x > 4.0 && x < 5.0));
    const bool block_top = y > 3.75 && y < 4.0 && x > 2.0 && x < 4.0;
    const bool roof_top = y > 5.75 && x > 5.0;
    EXPECT_NEAR(piece.width, open_ground || block_top || roof_top ? spacing : 0.0, 1e-12) << x << " " << y;
  }
}

TEST(FreeSurface, OfDisplacedParticlesIsTheOutermostLayer) {
  const Particles block = lattice(40, 20, spacing, 0.1, 3);
  const FreeSurface surface = found(block, {.left = 0.0, .right = 10.0, .base = 0.0});
  std::set<std::uint32_t> members;
  for (const SurfacePiece& piece : surface.pieces()) {
    members.insert(piece.particle);
    EXPECT_GT(piece.ny, 0.7);
    EXPECT_NEAR(piece.width, spacing, 0.3 * spacing);
  }
  EXPECT_EQ(members.size(), 40U);
  EXPECT_EQ(*members.begin(), 19U * 40U) << "none from below the top row";
  EXPECT_NEAR(total_width(surface), 10.0, 1e-12);
}

TEST(FreeSurface, OfALooseParticleFacesUpwards) {
  const Particles single = lattice(1, 1, spacing);
  const FreeSurface surface = found(single, {});
  ASSERT_EQ(surface.pieces().size(), 1U);
  EXPECT_NEAR(surface.pieces()[0].ny, 1.0, 1e-12);
  EXPECT_NEAR(surface.pieces()[0].width, spacing, 1e-12);
  // a row with air below and above it catches the rain on its upper side
  const FreeSurface row = found(lattice(6, 1, spacing), {.left = 0.0, .right = 1.5});
  for (const SurfacePiece& piece : row.pieces()) {
    EXPECT_NEAR(piece.ny, 1.0, 1e-12);
    EXPECT_NEAR(piece.width, spacing, 1e-12);
  }
}

TEST(FreeSurface, FollowsWhatMoves) {
  Particles block = lattice(10, 10, spacing);
  FreeSurface surface = found(block, {.left = 0.0, .base = 0.0});
  for (double& x : block.x) x += 0.04 * spacing;
  EXPECT_FALSE(surface.update(block.skeleton()));
  // the upper half slides to the right by three spacings: part of the lower half comes to light
  for (std::size_t p = 50; p < 100; ++p) block.x[p] += 3.0 * spacing;
  EXPECT_TRUE(surface.update(block.skeleton()));
  double uncovered = 0.0;
  for (const SurfacePiece& piece : surface.pieces()) {
    if (piece.particle < 50) uncovered += piece.width;
  }
  EXPECT_NEAR(uncovered, 3.0 * spacing, 0.1 * spacing);
  EXPECT_NEAR(total_width(surface), 13.04 * spacing, 0.01 * spacing);
}

}  // namespace
}  // namespace slope::seepage
