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

TEST_P(PressureCoupling, ResponseIsSymmetricPositiveAndHasItsDiagonal) {
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
    EXPECT_NEAR(response(p, p), diagonal[static_cast<std::size_t>(p)], 1e-14 * diagonal[static_cast<std::size_t>(p)]);
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
}

}  // namespace
}  // namespace slope::solid
