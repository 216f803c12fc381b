#include "slope/seepage/open_face.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "particles.hpp"
#include "slope/seepage/coupled_step.hpp"
#include "slope/seepage/pore_flow.hpp"
#include "slope/seepage/rigid_step.hpp"

namespace slope::seepage {
namespace {

using testing::lattice;
using testing::Particles;

double inflow(const OpenFaceLaw& law, double head) {
  return law.inflow(law.part_at(head), head);
}

TEST(OpenFaceLaw, NeverRisesWithTheHead) {
  for (const double rain : {2.0e-6, 0.0, -2.0e-6}) {
    const OpenFaceLaw law{rain, {1.0e-5, 1.0}, {1.0e-6, -9.0}};
    double before = inflow(law, -20.0);
    EXPECT_EQ(before, std::max(rain, 0.0)) << "dry soil takes all the rain, and loses nothing to the air";
    for (double head = -20.0; head < 5.0; head += 0.01) {
      const double now = inflow(law, head);
      EXPECT_LE(now, before);
      EXPECT_NEAR(now, before, 1.01e-5 * 0.01) << "no jump at " << head;
      EXPECT_LE(now, std::max(rain, 0.0)) << "nothing is sucked in";
      before = now;
    }
    EXPECT_NEAR(before, -4.0e-5, 1e-7) << "seepage";
  }
}

TEST(OpenFaceLaw, EvaporationFadesAtTheLowestPressure) {
  const OpenFaceLaw law{-2.0e-6, {1.0e-5, 1.0}, {1.0e-6, -9.0}};
  EXPECT_EQ(law.part_at(0.9), OpenFaceLaw::Part::air);
  EXPECT_EQ(inflow(law, -5.0), -2.0e-6);
  EXPECT_EQ(law.part_at(-8.0), OpenFaceLaw::Part::dry);
  EXPECT_NEAR(inflow(law, -8.0), -1.0e-6, 1e-20);
  EXPECT_EQ(law.part_at(-9.5), OpenFaceLaw::Part::closed);
}

TEST(AirFlow, PartsAddUp) {
  const AirFlow ponds = air_flow(3.0, 1.0), wet = air_flow(3.0, -2.0), dries = air_flow(-1.0, -1.5);
  EXPECT_EQ(ponds.infiltration, 1.0);
  EXPECT_EQ(ponds.run_off, 2.0);
  EXPECT_EQ(wet.run_off, 3.0);
  EXPECT_EQ(wet.seepage, 2.0);
  EXPECT_EQ(dries.rain, 0.0);
  EXPECT_EQ(dries.evaporation, 1.0);
  EXPECT_EQ(dries.seepage, 0.5);
}

// A column 2 m high, hydrostatic above a water table at its closed base, under rain and sun by turns.
class OpenColumn : public ::testing::Test {
 protected:
  static constexpr int columns = 2, rows = 20;
  static constexpr double spacing = 0.1, lowest = -40.0e3;

  [[nodiscard]] PoreFlow flow() const {
    Soil soil;
    soil.retention = VanGenuchten{.alpha = 0.5, .n = 3.0, .range = {}};
    soil.relative_permeability.law = HillelPower{.exponent = 3.0};
    soil.hydraulic_conductivity = 1.0e-5;
    FlowSettings settings;
    settings.spacing = spacing;
    settings.walls = {.left = 0.0, .right = columns * spacing, .base = 0.0};
    std::vector<double> pressure;
    for (const double y : particles.y) pressure.push_back(-Water{}.unit_weight() * y);
    return {{soil}, Water{}, std::vector<std::uint16_t>(particles.size(), 0), pressure, particles.skeleton(), settings};
  }
  [[nodiscard]] Boundary air(double intensity, double ponding_pressure = 0.0) const {
    Boundary boundary;
    boundary.count = 1;
    for (std::uint32_t p = (rows - 1) * columns; p < rows * columns; ++p) {
      boundary.open_faces.push_back(
          {p, 0, intensity * spacing, ponding_pressure, lowest, 0.5 * spacing, 0.5 * spacing, spacing});
    }
    return boundary;
  }
  [[nodiscard]] double pressure_at_top(const PoreFlow& flow) const { return flow.pressure()[particles.size() - 1]; }

  Particles particles = lattice(columns, rows, spacing);
};

class OpenColumnBy : public OpenColumn, public ::testing::WithParamInterface<bool> {
 protected:
  void step(PoreFlow& flow, double time_step, const Boundary& boundary) {
    if (GetParam()) {
      ASSERT_TRUE(rigid_.advance(flow, time_step, particles.skeleton(), boundary, 0.1).converged);
      return;
    }
    const std::vector<double> still(particles.size(), 0.0);
    ASSERT_TRUE(
        coupled_.solve(flow, time_step, particles.skeleton(), still, boundary, RigidSkeleton{}, 1.0e-3).converged);
    coupled_.finish(flow, particles.skeleton());
  }

  RigidStep rigid_;
  CoupledStep coupled_;
};

TEST_P(OpenColumnBy, BooksRainPondingAndDrying) {
  PoreFlow water = flow();
  const double start = water.stored_water(), time_step = 20.0;
  AirFlow sum;
  int changes = 0;
  bool ponded = false;
  const auto weather = [&](double intensity, int steps) {
    const Boundary boundary = air(intensity);
    for (int k = 0; k < steps; ++k) {
      ASSERT_NO_FATAL_FAILURE(step(water, time_step, boundary));
      AirFlow now = water.air_flow();
      EXPECT_NEAR(now.rain, now.infiltration + now.run_off, 1e-12 * now.rain);
      changes += ponded != (now.run_off > 0.0) ? 1 : 0;
      ponded = now.run_off > 0.0;
      for (double* part : {&now.rain, &now.infiltration, &now.run_off, &now.seepage, &now.evaporation}) {
        *part *= time_step;
      }
      sum += now;
    }
  };
  ASSERT_NO_FATAL_FAILURE(weather(3.0e-5, 400));
  EXPECT_GT(sum.infiltration, 0.0);
  EXPECT_GT(sum.run_off, 0.5 * sum.rain) << "the column is full";
  EXPECT_EQ(changes, 1) << "it ponds once and for all";
  EXPECT_LT(water.air_flow().infiltration, 1.0e-3 * water.air_flow().rain);
  EXPECT_NEAR(pressure_at_top(water), 0.5 * spacing * Water{}.unit_weight(), 0.1) << "zero at the face";
  ASSERT_NO_FATAL_FAILURE(weather(-1.0e-7, 4000));
  EXPECT_GT(sum.evaporation, 0.0);
  EXPECT_LE(sum.evaporation, 1.0e-7 * columns * spacing * 4000 * time_step * (1.0 + 1e-12));
  const double gain = water.stored_water() - start;
  EXPECT_NEAR(gain + water.unexplained_water(), sum.infiltration - sum.seepage - sum.evaporation, 1e-10 * start);
  EXPECT_LT(std::abs(water.unexplained_water()), 1e-3 * sum.rain);
}
INSTANTIATE_TEST_SUITE_P(Steps, OpenColumnBy, ::testing::Bool(),
                         [](const auto& instance) { return instance.param ? "Newton" : "Linearised"; });

TEST_F(OpenColumn, DriesToTheLowestPressureAndNoFurther) {
  PoreFlow water = flow();
  double step = 10.0;
  for (int k = 0; k < 200; ++k) {
    step *= RigidStep().advance(water, step, particles.skeleton(), air(-1.0e-6), 0.1).converged ? 1.3 : 0.25;
    EXPECT_GT(pressure_at_top(water), lowest);
  }
  EXPECT_LT(pressure_at_top(water), 0.9 * lowest);
  EXPECT_LT(water.air_flow().evaporation, 1.0e-3 * 1.0e-6 * columns * spacing);
  EXPECT_EQ(water.air_flow().seepage, 0.0);
}

TEST_F(OpenColumn, PondsUpToTheGivenDepth) {
  PoreFlow water = flow();
  const double depth = 0.3;
  for (int k = 0; k < 500; ++k) {
    ASSERT_TRUE(RigidStep()
                    .advance(water, 50.0, particles.skeleton(), air(3.0e-5, depth * Water{}.unit_weight()), 0.1)
                    .converged);
  }
  EXPECT_NEAR(pressure_at_top(water), (depth + 0.5 * spacing) * Water{}.unit_weight(), 1.0);
  EXPECT_NEAR(water.air_flow().run_off, water.air_flow().rain, 1e-3 * water.air_flow().rain);
}

TEST_F(OpenColumn, UnderPressureLetsWaterOut) {
  PoreFlow water = flow();
  Boundary boundary = air(0.0);
  boundary.count = 2;
  for (std::uint32_t p = 0; p < columns; ++p) boundary.inflows.push_back({p, 1, 2.0e-6 * spacing});
  for (int k = 0; k < 60; ++k) {
    ASSERT_TRUE(RigidStep().advance(water, 10.0 * std::pow(1.2, k), particles.skeleton(), boundary, 0.01).converged);
  }
  EXPECT_NEAR(water.air_flow().seepage, 2.0e-6 * columns * spacing, 1e-12);
}

}  // namespace
}  // namespace slope::seepage
