#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "block.hpp"

namespace slope::solid {
namespace {

using testing::Block;

constexpr double dt = 1e-3;

struct Setting {
  const char* name;
  Wall wall;
  ShapeFunction shape;
};
std::ostream& operator<<(std::ostream& out, const Setting& setting) {
  return out << setting.name;
}

// A small block of scattered particles between walls.
class PressureCoupling : public ::testing::TestWithParam<Setting> {
 protected:
  PressureCoupling() : solid(block().build()), water(block().pore_water(solid)), q(water.size()) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> share(-1.0, 1.0);
    Particles& p = solid.particles();
    for (std::size_t i = 0; i < p.size(); ++i) {
      p.x[i] += 0.1 * share(random);
      p.y[i] += 0.1 * share(random);
      p.vx[i] = share(random);
      p.vy[i] = share(random);
      p.volume[i] *= 1.0 + 0.2 * share(random);
      q[i] = 1.0e4 * share(random);
    }
  }

  static Block block() {
    Block small;
    small.columns = small.soil_columns = small.soil_rows = 3;
    small.rows = 4;
    small.walls = {.left = GetParam().wall, .right = Wall::roller, .base = GetParam().wall};
    small.settings.shape_function = GetParam().shape;
    return small;
  }

  std::vector<double> strain() const {
    std::vector<double> values(q.size());
    solid.volumetric_strain(dt, values);
    return values;
  }

  MaterialPointMethod solid;
  std::vector<double> water;
  std::vector<double> q;
};

INSTANTIATE_TEST_SUITE_P(Settings, PressureCoupling,
                         ::testing::Values(Setting{"Free", Wall::free, ShapeFunction::quadratic_bspline},
                                           Setting{"Roller", Wall::roller, ShapeFunction::quadratic_bspline},
                                           Setting{"Fixed", Wall::fixed, ShapeFunction::quadratic_bspline},
                                           Setting{"LinearFixed", Wall::fixed, ShapeFunction::linear}),
                         [](const auto& setting) { return std::string(setting.param.name); });

TEST_P(PressureCoupling, ResponseIsSymmetricPositiveAndBelowItsDiagonal) {
  solid.predict(dt, {{}, water}, {}, 5.0);
  const auto n = static_cast<Eigen::Index>(q.size());
  Eigen::MatrixXd response(n, n);
  std::vector<double> unit(q.size()), column(q.size()), diagonal(q.size());
  solid.volume_response_diagonal(dt, diagonal);
  for (Eigen::Index p = 0; p < n; ++p) {
    std::fill(unit.begin(), unit.end(), 0.0);
    unit[static_cast<std::size_t>(p)] = 1.0;
    solid.volume_response(dt, unit, column);
    response.col(p) = Eigen::Map<Eigen::VectorXd>(column.data(), n);
    const double bound = diagonal[static_cast<std::size_t>(p)];
    EXPECT_LE(response(p, p), bound * (1.0 + 1e-14));
    EXPECT_GE(response(p, p), bound / 3.0) << "near enough to scale the pressure step's residual with";
  }
  const double largest = response.cwiseAbs().maxCoeff();
  EXPECT_LT((response - response.transpose()).cwiseAbs().maxCoeff(), 1e-14 * largest);
  const Eigen::VectorXd eigenvalues = response.selfadjointView<Eigen::Lower>().eigenvalues();
  EXPECT_GT(eigenvalues.minCoeff(), -1e-13 * eigenvalues.maxCoeff());
}

// The response is what the volumetric strain changes by when the pressure acts: its factors are transposes.
TEST_P(PressureCoupling, ResponseIsTheStrainThatACorrectionMakes) {
  solid.predict(dt, {{}, water}, {}, 5.0);
  std::vector<double> response(q.size());
  solid.volume_response(dt, q, response);
  const std::vector<double> before = strain();
  solid.correct(dt, q);
  const std::vector<double> after = strain();
  for (std::size_t p = 0; p < q.size(); ++p) {
    EXPECT_NEAR((after[p] - before[p]) * solid.particles().volume[p], response[p], 1e-15);
  }
}

TEST_P(PressureCoupling, CorrectingIsPredictingWithThePressureAdded) {
  MaterialPointMethod other = solid;
  std::vector<double> old(q.size()), both(q.size());
  for (std::size_t p = 0; p < q.size(); ++p) {
    old[p] = 1.0e4 + 300.0 * static_cast<double>(p % 5);
    both[p] = old[p] + q[p];
  }
  solid.predict(dt, {old, water}, {}, 5.0);
  solid.correct(dt, q);
  solid.advance(dt, {});
  other.predict(dt, {both, water}, {}, 5.0);
  other.advance(dt, {});
  for (std::size_t p = 0; p < q.size(); ++p) {
    EXPECT_NEAR(solid.particles().vx[p], other.particles().vx[p], 1e-13);
    EXPECT_NEAR(solid.particles().vy[p], other.particles().vy[p], 1e-13);
    EXPECT_NEAR(solid.particles().syy[p], other.particles().syy[p], 1e-6);
    EXPECT_NEAR(solid.particles().porosity[p], other.particles().porosity[p], 1e-14);
  }
}

// The stress sees the projected change of volume, the one that the water sees; its deviator in the plane is that of the
// particle's own strain. What the projection takes from one particle it gives to others.
TEST_P(PressureCoupling, StressFollowsTheProjectedVolumeChange) {
  solid.predict(dt, {{}, water}, {}, 0.0);
  const std::vector<double> projected = strain();
  solid.advance(dt, {}, {.yields = false, .moves = false});
  const Particles& p = solid.particles();
  const Elastic& elastic = solid.soils()[0].elastic;
  const double shear = elastic.shear_modulus(), lame = elastic.bulk_modulus() - 2.0 / 3.0 * shear;
  // linear shape functions take the strain of the soil from velocities that were mapped twice
  const bool same_velocity = GetParam().shape == ShapeFunction::quadratic_bspline;
  double sum = 0.0, own = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < q.size(); ++i) {
    const double seen = p.szz[i] / lame, tolerance = 1e-12 * elastic.youngs_modulus * dt;
    if (same_velocity) {
      EXPECT_NEAR(seen, projected[i], 1e-12 * dt);
    }
    EXPECT_NEAR(p.sxx[i] + p.syy[i], 2.0 * (lame + shear) * seen, tolerance);
    EXPECT_NEAR(p.sxx[i] - p.syy[i], 2.0 * shear * (p.exx[i] - p.eyy[i]), tolerance);
    EXPECT_NEAR(p.sxy[i], 2.0 * shear * p.exy[i], tolerance);
    sum += p.volume[i] * seen;
    own += p.volume[i] * (p.exx[i] + p.eyy[i]);
    largest = std::max(largest, std::abs(seen - p.exx[i] - p.eyy[i]));
  }
  EXPECT_NEAR(sum, own, 1e-12 * dt);
  EXPECT_GT(largest, 0.01 * dt) << "the particles' own strain differs";
}

// Particles far from each other have no neighbour to share with: each keeps its own pressure and strain.
TEST(VolumetricStrain, OfLoneParticlesIsTheirOwn) {
  const std::vector<double> x{1.3, 4.5, 8.0}, y{1.7, 4.0, 7.75};
  const Soil soil = testing::table_2_soil();
  const Grid grid{.cell_size = 0.5, .columns = 20, .rows = 20, .walls = {}};
  MaterialPointMethod solid(grid, {soil},
                            Particles::at(x, y, std::vector<double>(3, 0.0625), std::vector<double>(3, 0.35),
                                          std::vector<std::uint16_t>(3, 0), std::vector{soil.grain_density}),
                            {.gravity = 0.0});
  Particles& p = solid.particles();
  for (std::size_t i = 0; i < 3; ++i) {
    p.cxx[i] = 0.3 * double(i + 1);
    p.cyy[i] = -0.1;
  }
  solid.predict(dt, {}, {}, 0.0);
  std::vector<double> strain(3);
  solid.volumetric_strain(dt, strain);
  solid.advance(dt, {}, {.yields = false, .moves = false});
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(strain[i], p.exx[i] + p.eyy[i], 1e-16);
    EXPECT_GT(strain[i], 0.0);
  }
}

TEST(VolumetricStrain, IsTheDivergenceOfALinearField) {
  Block block;
  block.walls.base = Wall::roller;
  block.settings.gravity = 0.0;
  MaterialPointMethod solid = block.build();
  Particles& p = solid.particles();
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.vy[i] = 0.5 * p.y[i];
    p.cyy[i] = 0.5;
  }
  solid.predict(dt, {}, {}, 0.0);
  std::vector<double> strain(p.size());
  solid.volumetric_strain(dt, strain);
  for (const double value : strain) EXPECT_NEAR(value, 0.5 * dt, 1e-14);

  // so the projection leaves the stress of uniform compression as it is, at walls and at the surface too
  solid.advance(dt, {}, {.yields = false, .moves = false});
  const Elastic& elastic = solid.soils()[0].elastic;
  const double nu = elastic.poissons_ratio;
  for (std::size_t i = 0; i < p.size(); ++i) {
    EXPECT_NEAR(p.syy[i], elastic.constrained_modulus() * 0.5 * dt, 1e-6);
    EXPECT_NEAR(p.sxx[i], nu / (1.0 - nu) * p.syy[i], 1e-6);
  }
}

}  // namespace
}  // namespace slope::solid
