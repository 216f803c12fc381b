#include "slope/seepage/images.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "particles.hpp"

namespace slope::seepage {
namespace {

// The same sum over images, and over a lattice that was continued behind the walls by hand.
TEST(Images, ContinueTheParticlesBehindTheWalls) {
  const auto inside = testing::lattice(5, 4, 1.0, 0.2);
  const MirrorWalls walls{.left = 0.0, .right = 5.0, .base = 0.0};
  const WendlandC2 kernel(1.2);
  const Neighbours neighbours = find_neighbours(inside.x, inside.y, kernel.support());
  Images images;
  find_images(inside.skeleton(), neighbours, walls, kernel, 2.0, images);
  ASSERT_EQ(images.size(), inside.size());
  for (std::size_t p = 0; p < inside.size(); ++p) {
    double first_x = 0.0, first_y = 0.0, weight = 0.0;
    std::size_t count = 0;
    for (std::size_t q = 0; q < inside.size(); ++q) {
      for (const double x : {inside.x[q], -inside.x[q], 10.0 - inside.x[q]}) {
        for (const double y : {inside.y[q], -inside.y[q]}) {
          const double r = std::hypot(inside.x[p] - x, inside.y[p] - y);
          if (r == 0.0 || r >= kernel.support()) continue;
          const double w = 2.0 * kernel.radial_factor(r);
          ++count;
          weight += w;
          first_x += w * (inside.x[p] - x);
          first_y += w * (inside.y[p] - y);
        }
      }
    }
    EXPECT_EQ(images.of(p).size(), count);
    for (const Image& q : images.of(p)) {
      EXPECT_NEAR(std::hypot(q.ex, q.ey), 1.0, 1e-15);
      weight -= q.weight;
      first_x -= q.weight * q.r * q.ex;
      first_y -= q.weight * q.r * q.ey;
      const double x = inside.x[p] - q.r * q.ex, y = inside.y[p] - q.r * q.ey;
      EXPECT_EQ(q.flip_x, x < 0.0 || x > 5.0 ? -1 : 1);
      EXPECT_EQ(q.flip_y, y < 0.0 ? -1 : 1);
    }
    EXPECT_NEAR(weight, 0.0, 1e-12);
    EXPECT_NEAR(first_x, 0.0, 1e-12);
    EXPECT_NEAR(first_y, 0.0, 1e-12);
  }
}

TEST(Images, AscendAndEndWithTheParticlesOwn) {
  const auto inside = testing::lattice(4, 4, 1.0);
  const WendlandC2 kernel(1.2);
  const Neighbours neighbours = find_neighbours(inside.x, inside.y, kernel.support());
  Images images;
  find_images(inside.skeleton(), neighbours, {.left = 0.0}, kernel, 1.0, images);
  for (std::size_t p = 0; p < inside.size(); ++p) {
    const auto row = images.of(p);
    const auto own = std::find_if(row.begin(), row.end(), [&](const Image& q) { return q.particle == p; });
    EXPECT_TRUE(
        std::is_sorted(row.begin(), own, [](const Image& a, const Image& b) { return a.particle < b.particle; }));
    EXPECT_TRUE(std::all_of(own, row.end(), [&](const Image& q) { return q.particle == p; }));
    EXPECT_EQ(own == row.end(), inside.x[p] > 1.0);
  }
}

TEST(Images, LatticeScaleMakesTheSecondMomentTheUnitTensor) {
  const auto block = testing::lattice(9, 9, 0.5);
  const WendlandC2 kernel(0.6);
  const Neighbours neighbours = find_neighbours(block.x, block.y, kernel.support());
  Images images;
  find_images(block.skeleton(), neighbours, {}, kernel, lattice_scale(kernel, 0.5), images);
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (const Image& q : images.of(40)) {
    xx += q.weight * q.r * q.r * q.ex * q.ex;
    xy += q.weight * q.r * q.r * q.ex * q.ey;
    yy += q.weight * q.r * q.r * q.ey * q.ey;
  }
  EXPECT_NEAR(xx, 1.0, 1e-12);
  EXPECT_NEAR(xy, 0.0, 1e-12);
  EXPECT_NEAR(yy, 1.0, 1e-12);
}

}  // namespace
}  // namespace slope::seepage
