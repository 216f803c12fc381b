#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "block.hpp"

namespace slope::solid {
namespace {

using testing::Block;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// The error of one step, or "none".
std::string error_of_a_step(MaterialPointMethod& solid, std::size_t& particle) {
  try {
    solid.predict(1e-3, {}, {}, 0.0);
    solid.advance(1e-3, {});
  } catch (const SolidError& error) {
    particle = error.particle;
    EXPECT_FALSE(error.field.empty());
    return error.what();
  }
  return "none";
}

TEST(SolidError, NamesTheParticleOutsideOfTheGrid) {
  for (const double y : {-1e-9, 12.0, 1e300, nan, -std::numeric_limits<double>::infinity()}) {
    MaterialPointMethod solid = Block{}.build();
    solid.particles().y[17] = y;
    solid.particles().y[40] = y;
    std::size_t particle = 0;
    const std::string error = error_of_a_step(solid, particle);
    EXPECT_EQ(particle, 17u) << y;
    EXPECT_NE(error.find("particle 17: y position (m), outside of the grid"), std::string::npos) << error;
  }
  MaterialPointMethod solid = Block{}.build();
  solid.particles().x[3] = 1.0;
  std::size_t particle = 0;
  EXPECT_NE(error_of_a_step(solid, particle).find("particle 3: x position"), std::string::npos);
}

TEST(SolidError, NamesAVelocityThatIsNotANumber) {
  MaterialPointMethod solid = Block{}.build();
  solid.particles().vx[20] = nan;
  std::size_t particle = 0;
  EXPECT_NE(error_of_a_step(solid, particle).find("velocity (m/s)"), std::string::npos);
}

TEST(SolidError, NamesAStressThatIsNotANumber) {
  MaterialPointMethod solid = Block{}.build();
  solid.predict(1e-3, {}, {}, 0.0);
  solid.particles().szz[9] = nan;
  try {
    solid.advance(1e-3, {});
    FAIL() << "no error";
  } catch (const SolidError& error) {
    EXPECT_EQ(error.particle, 9u);
    EXPECT_EQ(error.field, "effective stress (Pa)");
  }
}

TEST(SolidError, NamesAVolumeThatIsNotPositive) {
  Block block;
  block.soil.grain_density = 1e15;
  MaterialPointMethod solid = block.build();
  Particles& p = solid.particles();
  for (std::size_t i = 0; i < p.size(); ++i) p.vy[i] = -p.y[i];
  try {
    solid.predict(3.0, {}, {}, 0.0);
    solid.advance(3.0, {});
    FAIL() << "no error";
  } catch (const SolidError& error) {
    EXPECT_EQ(error.field, "volume (m2)");
    EXPECT_LE(error.value, 0.0);
  }
}

TEST(MaterialPointMethod, RefusesWhatCannotBe) {
  const Block block;
  const MaterialPointMethod good = block.build();
  const auto make = [&](const Grid& grid, std::vector<Soil> soils, Particles particles, const Settings& settings) {
    return MaterialPointMethod(grid, std::move(soils), std::move(particles), settings);
  };
  const Soil soil = testing::table_2_soil();
  EXPECT_NO_THROW(make(good.grid(), {soil}, good.particles(), {}));
  EXPECT_THROW(make({}, {soil}, good.particles(), {}), std::invalid_argument);
  EXPECT_THROW(make(good.grid(), {}, good.particles(), {}), std::invalid_argument);
  EXPECT_THROW(make(good.grid(), {soil}, good.particles(), {.threads = 0}), std::invalid_argument);
  EXPECT_THROW(make(good.grid(), {soil}, good.particles(), {.flip_fraction = 1.1}), std::invalid_argument);
  Particles short_of_one = good.particles();
  short_of_one.porosity.pop_back();
  EXPECT_THROW(make(good.grid(), {soil}, short_of_one, {}), std::invalid_argument);
}

TEST(MaterialPointMethod, TractionsNeedAParticleSpacing) {
  const MaterialPointMethod good = Block{}.build();
  MaterialPointMethod solid(good.grid(), {testing::table_2_soil()}, good.particles(), {});
  const std::vector<ParticleTraction> tractions{{0, 1.0, 0.0}};
  EXPECT_THROW(solid.predict(1e-3, {}, {.tractions = tractions}, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace slope::solid
