// The faces between soils, as a lattice of particles shows them.

#include "slope/solid/soil_faces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>

#include "block.hpp"

namespace slope::solid {
namespace {

constexpr double cell = 0.5;
constexpr int side = 24;  // cells

struct Ground {
  Grid grid{.lower = {-3.0, 2.0}, .cell_size = cell, .columns = side, .rows = side, .walls = {}};
  Particles particles;
  std::vector<std::size_t> end, by_cell;
  SoilFaces faces;

  /// A square full of particles, n by n to a cell, of the soils that `soil_at` gives (-: no soil there).
  explicit Ground(int n, const std::function<int(double x, double y)>& soil_at) {
    const double spacing = cell / n;
    for (int row = 0; row < side; ++row) {
      for (int column = 0; column < side; ++column) {
        for (int k = 0; k < n * n; ++k) {
          const double x = grid.lower[0] + column * cell + (k % n + 0.5) * spacing;
          const double y = grid.lower[1] + row * cell + (k / n + 0.5) * spacing;
          const int soil = soil_at(x, y);
          if (soil < 0) continue;
          by_cell.push_back(particles.x.size());
          particles.x.push_back(x), particles.y.push_back(y);
          particles.volume.push_back(spacing * spacing);
          particles.soil.push_back(static_cast<std::uint8_t>(soil));
        }
        end.push_back(particles.x.size());
      }
    }
    faces.find(grid, {end, by_cell}, particles, 3);
  }
};

/// What lies between two lines that dip by so many degrees, the lower one through the middle of the square and through
/// no particle, and below and above.
struct Seam {
  double dip, thickness;  // (deg), (m)

  [[nodiscard]] double up(double x, double y) const {
    const double angle = dip * testing::degree;
    return (y - 8.05) * std::cos(angle) - (x - 3.0) * std::sin(angle);
  }
  [[nodiscard]] std::array<double, 2> normal() const {
    return {-std::sin(dip * testing::degree), std::cos(dip * testing::degree)};
  }
};

TEST(SoilFaces, HaveTheirDirectionUpToTheirEnds) {
  for (const int n : {1, 2, 3}) {
    for (const double dip : {-80.0, -33.0, 0.0, 7.0, 20.0, 45.0, 61.0}) {
      const Seam seam{dip, 0.0};
      const Ground ground(n, [&](double x, double y) { return seam.up(x, y) < 0.0 ? 0 : 2; });
      ASSERT_FALSE(ground.faces.particles_beside().empty());
      for (const std::size_t p : ground.faces.particles_beside()) {
        const double outward = ground.particles.soil[p] == 0 ? 1.0 : -1.0;
        ground.faces.for_each_face_of(p, [&](const SoilFaces::Beside& face) {
          const double sine = face.normal[0] * seam.normal()[1] - face.normal[1] * seam.normal()[0];
          EXPECT_LT(std::abs(sine), std::sin((n == 1 ? 16.0 : 5.5) * testing::degree)) << n << ", " << dip;
          EXPECT_GT(outward * (face.normal[0] * seam.normal()[0] + face.normal[1] * seam.normal()[1]), 0.0);
          const double gap = std::abs(seam.up(ground.particles.x[p], ground.particles.y[p]));
          EXPECT_NEAR(face.gap, gap, 0.5 * cell / n) << n << ", " << dip;
          EXPECT_TRUE(face.close);
          EXPECT_EQ(face.beyond, SoilFaces::none);
        });
      }
    }
  }
}

// Half of the five cells that a slip takes, less the seam, to either side of it.
TEST(SoilFaces, OfAThinLayerReachFurther) {
  for (const double thickness : {0.5 * cell, cell, 2.0 * cell}) {
    for (const double dip : {0.0, 20.0, -45.0}) {
      const Seam seam{dip, thickness};
      const Ground ground(2, [&](double x, double y) {
        const double up = seam.up(x, y);
        return up < 0.0 ? 0 : up < seam.thickness ? 1 : 2;
      });
      const double reach = 0.5 * (5.0 * cell - thickness);
      for (std::size_t p = 0; p < ground.particles.x.size(); ++p) {
        if (ground.particles.soil[p] == 1) continue;
        const double up = seam.up(ground.particles.x[p], ground.particles.y[p]);
        const double gap = up < 0.0 ? -up : up - thickness;
        bool seen = false;
        ground.faces.for_each_face_of(p, [&](const SoilFaces::Beside& face) {
          if (ground.particles.soil[face.other] != 1) return;
          seen = true;
          if (face.close) return;
          ASSERT_NE(face.beyond, SoilFaces::none);
          EXPECT_NE(ground.particles.soil[face.beyond], 1);
          EXPECT_NE(ground.particles.soil[face.beyond], ground.particles.soil[p]) << "of the other side";
        });
        const std::array<double, 2> at{ground.particles.x[p] - ground.grid.lower[0],
                                       ground.particles.y[p] - ground.grid.lower[1]};
        const double off_walls = std::min({at[0], at[1], side * cell - at[0], side * cell - at[1]});
        if (off_walls < 2.0 * cell) continue;
        if (gap < reach - 0.5 * cell) {
          EXPECT_TRUE(seen) << thickness << ", " << dip << ", " << gap;
        }
        if (gap > reach + 0.5 * cell) {
          EXPECT_FALSE(seen) << thickness << ", " << dip << ", " << gap;
        }
      }
    }
  }
}

TEST(SoilFaces, EndWhereTheOtherSoilDoes) {
  const Ground ground(2, [](double x, double y) { return y > 8.0 && y < 8.0 + cell && x > 0.0 && x < 5.0 ? 1 : 0; });
  for (const std::size_t p : ground.faces.particles_beside()) {
    EXPECT_GT(ground.particles.x[p], 0.0 - cell);
    EXPECT_LT(ground.particles.x[p], 5.0 + cell);
  }
}

// A lone pebble, and one at a slant from another: nothing to draw a line through.
TEST(SoilFaces, OfAFewParticlesHaveADirection) {
  const auto pebble = [](double x, double y) { return std::abs(x - 0.125) < 0.2 && std::abs(y - 8.125) < 0.2 ? 1 : 0; };
  const auto speckled = [](double x, double y) {
    return (static_cast<int>(std::floor(4.0 * x)) + 3 * static_cast<int>(std::floor(4.0 * y))) % 5 == 0 ? 1 : 0;
  };
  for (const std::function<int(double, double)>& soil_at :
       {std::function<int(double, double)>(pebble), std::function<int(double, double)>(speckled)}) {
    const Ground ground(2, soil_at);
    ASSERT_FALSE(ground.faces.particles_beside().empty());
    for (const std::size_t p : ground.faces.particles_beside()) {
      ground.faces.for_each_face_of(p, [&](const SoilFaces::Beside& face) {
        EXPECT_NEAR(face.normal.norm(), 1.0, 1.0e-12);
        EXPECT_TRUE(std::isfinite(face.gap));
      });
    }
  }
}

TEST(SoilFaces, AreThreeWhereThreeSoilsMeet) {
  const Ground ground(2, [](double x, double y) { return y < 8.0 ? 0 : x < 3.0 ? 1 : 2; });
  std::map<int, int> others;  // of soil 0, and how many of its particles touch it
  int both = 0;
  for (const std::size_t p : ground.faces.particles_beside()) {
    if (ground.particles.soil[p] != 0) continue;
    int count = 0;
    ground.faces.for_each_face_of(p, [&](const SoilFaces::Beside& face) {
      EXPECT_NEAR(face.normal[1], 1.0, 1.0e-9);
      ++others[ground.particles.soil[face.other]];
      ++count;
    });
    if (count == 2) ++both;
  }
  EXPECT_GE(others[1], side);
  EXPECT_GE(others[2], side);
  EXPECT_GE(both, 2);
}

}  // namespace
}  // namespace slope::solid
