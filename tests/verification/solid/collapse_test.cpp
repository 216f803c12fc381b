// A column of dry sand, 1 m wide and high, that falls when its gate is gone.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <slope/testing/record.hpp>

#include "block.hpp"

namespace slope::solid {
namespace {

using slope::testing::near;
using slope::testing::record;
using testing::Block;

class Collapse : public ::testing::TestWithParam<ShapeFunction> {};
INSTANTIATE_TEST_SUITE_P(Shapes, Collapse, ::testing::Values(ShapeFunction::quadratic_bspline, ShapeFunction::linear));

TEST_P(Collapse, ComesToRestWithAllOfItsMass) {
  Block block;
  block.cell_size = 0.05;
  block.columns = 80;
  block.rows = 24;
  block.soil_columns = block.soil_rows = 20;
  block.porosity = 0.4;
  block.soil = {.elastic = {.youngs_modulus = 2.0e6, .poissons_ratio = 0.3},
                .strength = DruckerPrager{.friction_angle = 30.0 * testing::degree},
                .grain_density = 2650.0};
  block.settings.shape_function = GetParam();
  MaterialPointMethod sand = block.build();
  const Particles& p = sand.particles();
  const auto sum = [](const std::vector<double>& field) { return std::accumulate(field.begin(), field.end(), 0.0); };
  const double mass = sum(p.solid_mass);
  const double dt = sand.stable_step(0.25, {});
  double fastest_ever = 0.0;
  for (double time = 0.0; time < 2.0; time += dt) {
    sand.predict(dt, {}, {}, 0.0);
    sand.advance(dt, {});
    fastest_ever = std::max(fastest_ever, testing::fastest(p));
    ASSERT_NEAR(sand.balance().weight, 9.81 * mass, 1e-9 * mass);
  }
  EXPECT_EQ(sum(p.solid_mass), mass);
  EXPECT_GT(fastest_ever, 1.0);
  EXPECT_LT(fastest_ever, 5.0);
  EXPECT_LT(sand.balance().kinetic_energy, 1e-3 * 9.81 * mass);
  // no grain is lost: the solid volume that volume and porosity tell is that of the start
  for (std::size_t i = 0; i < p.size(); ++i) {
    ASSERT_NEAR((1.0 - p.porosity[i]) * p.volume[i], 0.6 * 0.000625, 1e-12);
  }
  std::vector<double> x = p.x;
  std::sort(x.begin(), x.end());
  const double run_out = x[x.size() * 99 / 100] - 1.0;
  if (GetParam() == ShapeFunction::quadratic_bspline) {
    // Lube et al. (2005): 1.2 heights for a column as high as wide
    EXPECT_TRUE(record("collapse-run-out", "Collapsing dry column, run-out (99 % of the mass) over height",
                       near(1.2, 0.4), run_out, ""));
  } else {
    EXPECT_NEAR(run_out, 1.2, 0.5);
  }
}

}  // namespace
}  // namespace slope::solid
