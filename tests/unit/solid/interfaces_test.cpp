// Where soils meet, none bears more along the face than the other.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "block.hpp"

namespace slope::solid {
namespace {

constexpr double weak = 10.0e3, strong = 80.0e3, shear = 50.0e3;  // Pa
constexpr double cell = 0.5;

Soil clay(double undrained_strength) {
  Soil soil = testing::table_2_soil();
  soil.strength = VonMises{.undrained_strength = undrained_strength};
  return soil;
}

using Side = std::function<bool(double x, double y)>;

/// A block of 8 x 8 cells, at rest; of the first soil where `first` says, else of the second.
MaterialPointMethod block(const std::vector<Soil>& soils, const Side& first) {
  testing::Block block;
  block.columns = block.rows = block.soil_columns = block.soil_rows = 8;
  Particles particles = block.build().particles();
  for (std::size_t p = 0; p < particles.size(); ++p) particles.soil[p] = first(particles.x[p], particles.y[p]) ? 0 : 1;
  Settings settings;
  settings.gravity = 0.0;
  const Grid grid{.lower = {0.0, 0.0}, .cell_size = cell, .columns = 8, .rows = 8, .walls = {}};
  return {grid, soils, std::move(particles), settings};
}

/// Lets the stress yield where it stands.
void yield(MaterialPointMethod& soil) {
  constexpr double dt = 1.0e-12;
  soil.predict(dt, {}, {}, 0.0);
  soil.advance(dt, {}, {.moves = false});
}

bool below(double /*x*/, double y) {
  return y < 4.0 * cell;
}

TEST(Interface, BoundsTheShearAlongItNearIt) {
  MaterialPointMethod soil = block({clay(weak), clay(strong)}, below);
  Particles& all = soil.particles();
  std::fill(all.sxy.begin(), all.sxy.end(), shear);
  std::fill(all.sxx.begin(), all.sxx.end(), -70.0e3);
  std::fill(all.syy.begin(), all.syy.end(), -90.0e3);
  std::fill(all.szz.begin(), all.szz.end(), -80.0e3);
  yield(soil);
  for (std::size_t p = 0; p < all.size(); ++p) {
    const bool near = all.y[p] < 4.5 * cell;
    if (below(all.x[p], all.y[p])) {
      EXPECT_LE(all.sxy[p], weak * (1.0 + 1.0e-9));
    } else {
      EXPECT_NEAR(all.sxy[p], near ? weak : shear, 1.0e-3 * shear) << all.y[p];
      EXPECT_NEAR(all.sxx[p], -70.0e3, 10.0);
      EXPECT_NEAR(all.syy[p], -90.0e3, 10.0);
      EXPECT_EQ(all.plastic_strain[p], 0.0) << "it is the other soil that flows";
    }
  }
}

// Of a face that dips by 45 degrees, the shear along it is half the difference of the stresses along the axes.
TEST(Interface, BoundsTheShearAlongAnInclinedOne) {
  const Side lower_right = [](double x, double y) { return y < x; };
  MaterialPointMethod soil = block({clay(weak), clay(strong)}, lower_right);
  Particles& all = soil.particles();
  std::fill(all.sxx.begin(), all.sxx.end(), -shear);
  std::fill(all.syy.begin(), all.syy.end(), shear);
  yield(soil);
  for (std::size_t p = 0; p < all.size(); ++p) {
    if (lower_right(all.x[p], all.y[p])) continue;
    // of the face, half way between the diagonal, whose particles are the upper soil's, and the next ones
    const double off = (all.y[p] - all.x[p] + 0.25 * cell) / std::sqrt(2.0);
    const bool inner = std::min({all.x[p], all.y[p], 8.0 * cell - all.x[p], 8.0 * cell - all.y[p]}) > 2.0 * cell;
    const double along = 0.5 * (all.syy[p] - all.sxx[p]);
    if (inner && off < 0.5 * cell) {
      EXPECT_NEAR(along, weak, 0.02 * weak);
    } else if (off > 2.0 * cell) {
      EXPECT_NEAR(along, shear, 1.0);
    }
  }
}

/// A block of the second soil with a layer of the first, a cell thick, at its middle and a third one above it.
MaterialPointMethod layered(double above, double gravity, double slope_of_layer) {
  testing::Block block;
  block.columns = block.rows = block.soil_columns = block.soil_rows = 16;
  Particles particles = block.build().particles();
  for (std::size_t p = 0; p < particles.size(); ++p) {
    const double up = particles.y[p] - 8.0 * cell - slope_of_layer * (particles.x[p] - 8.0 * cell);
    particles.soil[p] = up < 0.0 ? 1 : up < cell ? 0 : 2;
  }
  Settings settings;
  settings.gravity = gravity;
  const Grid grid{.lower = {0.0, 0.0}, .cell_size = cell, .columns = 16, .rows = 16, .walls = {}};
  return {grid, {clay(weak), clay(strong), clay(above)}, std::move(particles), settings};
}

// A slip takes five cells on this grid: two to either side of a layer of one, if both sides are stronger.
TEST(Interface, BoundsTheShearFurtherFromAThinWeakLayer) {
  for (const double above : {strong, 0.5 * weak}) {
    MaterialPointMethod soil = layered(above, 0.0, 0.0);
    Particles& all = soil.particles();
    std::fill(all.sxy.begin(), all.sxy.end(), shear);
    yield(soil);
    const double reach = above > weak ? 2.0 : 0.5;
    for (std::size_t p = 0; p < all.size(); ++p) {
      const double under = 8.0 - all.y[p] / cell;  // cells
      if (under < 0.0) continue;
      EXPECT_NEAR(all.sxy[p], under < reach ? weak : shear, 1.0e-3 * shear) << under;
    }
  }
}

// At rest, shear along a face that dips grows downwards by the weight between: soil there must bear that much more.
TEST(Interface, LeavesWhatTheWeightBelowItAdds) {
  constexpr double gravity = 9.81, rise = 1.0;  // 45 degrees
  MaterialPointMethod soil = layered(strong, gravity, rise);
  Particles& all = soil.particles();
  std::fill(all.sxx.begin(), all.sxx.end(), shear);
  std::fill(all.syy.begin(), all.syy.end(), -shear);
  yield(soil);
  int seen = 0;
  for (std::size_t p = 0; p < all.size(); ++p) {
    // the layer's lowest particles are those on the diagonal
    const double under = (all.x[p] - all.y[p] - 0.25 * cell) / std::sqrt(2.0);
    const bool inner = std::min({all.x[p], all.y[p], 16.0 * cell - all.x[p], 16.0 * cell - all.y[p]}) > 4.0 * cell;
    if (!inner || under < 0.0 || under > 1.75 * cell) continue;
    const double weight = gravity * all.solid_mass[p] / all.volume[p] / std::sqrt(2.0) * under;
    EXPECT_NEAR(0.5 * (all.sxx[p] - all.syy[p]), weak + weight, 0.01 * weak) << under / cell;
    ++seen;
  }
  EXPECT_GT(seen, 20);
}

TEST(Interface, OfSoilsAlikeIsNone) {
  MaterialPointMethod two = block({clay(strong), clay(strong)}, below);
  MaterialPointMethod one = block({clay(strong), clay(strong)}, [](double, double) { return true; });
  for (MaterialPointMethod* soil : {&two, &one}) {
    std::fill(soil->particles().sxy.begin(), soil->particles().sxy.end(), 1.5 * strong);
    yield(*soil);
  }
  EXPECT_EQ(two.particles().sxy, one.particles().sxy);
}

// A soil that is weakened within a polygon is the same soil as outside.
TEST(Interface, IsNoneWhereASoilIsWeakened) {
  MaterialPointMethod whole = block({clay(strong), clay(strong)}, [](double, double) { return true; });
  std::vector<std::uint8_t> where(whole.particles().size());
  for (std::size_t p = 0; p < where.size(); ++p) where[p] = below(0.0, whole.particles().y[p]) ? 1 : 0;
  MaterialPointMethod soil = whole.weakened(8.0, where);
  std::fill(soil.particles().sxy.begin(), soil.particles().sxy.end(), shear);
  yield(soil);
  for (std::size_t p = 0; p < where.size(); ++p) {
    if (where[p] == 0) {
      EXPECT_NEAR(soil.particles().sxy[p], shear, 1.0e-3 * shear);
    }
  }
}

// The limit is that of the other soil at the normal stress of the face, with its suction.
TEST(Interface, FollowsFriction) {
  Soil sand = testing::table_2_soil();
  sand.strength = MohrCoulomb{.cohesion = 0.0, .friction_angle = 20.0 * testing::degree};
  MaterialPointMethod soil = block({sand, clay(strong)}, below);
  Particles& all = soil.particles();
  constexpr double normal = 60.0e3;
  for (auto* stress : {&all.sxx, &all.syy, &all.szz}) std::fill(stress->begin(), stress->end(), -normal);
  std::fill(all.sxy.begin(), all.sxy.end(), shear);
  yield(soil);
  for (std::size_t p = 0; p < all.size(); ++p) {
    if (below(all.x[p], all.y[p]) || all.y[p] > 4.5 * cell) continue;
    EXPECT_NEAR(all.sxy[p], normal * std::sin(20.0 * testing::degree), 10.0);
  }
}

}  // namespace
}  // namespace slope::solid
