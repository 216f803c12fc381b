#include "slope/seepage/pore_flow.hpp"
#include "slope/seepage/coupled_step.hpp"
#include "slope/seepage/rigid_step.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "particles.hpp"

namespace slope::seepage {
namespace {

using testing::lattice;
using testing::Particles;

constexpr int columns = 2, rows = 30;
constexpr double spacing = 0.1;

// A column of the paper's soil W2, walled at the sides, hydrostatic above a water table at its base.
class Column : public ::testing::Test {
 protected:
  [[nodiscard]] PoreFlow flow(int threads = 1) const {
    Soil soil;
    soil.retention = VanGenuchten{.alpha = 0.5, .n = 3.0, .range = {}};
    soil.relative_permeability.law = HillelPower{.exponent = 2.0};
    soil.hydraulic_conductivity = 1.0e-5;
    FlowSettings settings;
    settings.spacing = spacing;
    settings.walls = {.left = 0.0, .right = columns * spacing};
    settings.threads = threads;
    std::vector<double> pressure(particles.size());
    for (std::size_t p = 0; p < particles.size(); ++p) pressure[p] = -water.unit_weight() * particles.y[p];
    return {{soil}, water, std::vector<std::uint16_t>(particles.size(), 0), pressure, particles.skeleton(), settings};
  }

  // Rain kept at zero pressure at the top, by particles or by faces.
  [[nodiscard]] Boundary held_top() const {
    Boundary boundary;
    boundary.count = 1;
    for (std::uint32_t p = (rows - 1) * columns; p < rows * columns; ++p) boundary.held.push_back({p, 0, 0.0});
    return boundary;
  }
  [[nodiscard]] Boundary face_top() const {
    Boundary boundary;
    boundary.count = 1;
    for (std::uint32_t p = (rows - 1) * columns; p < rows * columns; ++p) {
      boundary.faces.push_back({p, 0, 0.0, 0.5 * spacing, 0.5 * spacing, spacing});
    }
    return boundary;
  }
  // A flux at the top, a face held at the base.
  [[nodiscard]] Boundary flux_top() const {
    Boundary boundary;
    boundary.count = 2;
    for (std::uint32_t p = 0; p < columns; ++p) {
      boundary.inflows.push_back({(rows - 1) * columns + p, 0, 5.0e-6 * spacing});
      boundary.faces.push_back({p, 1, 0.0, -0.5 * spacing, 0.5 * spacing, spacing});
    }
    return boundary;
  }

  Particles particles = lattice(columns, rows, spacing);
  Water water;
  RigidStep rigid;
  CoupledStep coupled;
};

class WaterBalance : public Column, public ::testing::WithParamInterface<int> {};

TEST_P(WaterBalance, IsExactOverNonlinearSteps) {
  const Boundary boundary = GetParam() == 0 ? held_top() : GetParam() == 1 ? face_top() : flux_top();
  PoreFlow water_flow = flow();
  const double start = water_flow.stored_water();
  for (int step = 0; step < 40; ++step) {
    const double time_step = 0.05 * std::pow(1.2, step);
    ASSERT_TRUE(rigid.advance(water_flow, time_step, particles.skeleton(), boundary, 0.1).converged) << step;
  }
  double inflow = 0.0;
  for (const double v : water_flow.cumulative_inflow()) inflow += v;
  const double gain = water_flow.stored_water() - start;
  EXPECT_GT(gain, 1.0e-4 * start);
  EXPECT_NEAR(gain + water_flow.unexplained_water(), inflow, 1e-12 * start);
  EXPECT_LT(std::abs(water_flow.unexplained_water()), 1e-6 * inflow);
}

std::string boundary_name(const ::testing::TestParamInfo<int>& info) {
  return info.param == 0 ? "HeldParticles" : info.param == 1 ? "HeldFaces" : "Flux";
}
INSTANTIATE_TEST_SUITE_P(Boundaries, WaterBalance, ::testing::Values(0, 1, 2), boundary_name);

TEST_F(Column, IsStillWhenHydrostatic) {
  PoreFlow water_flow = flow();
  const auto before = std::vector<double>(water_flow.pressure().begin(), water_flow.pressure().end());
  ASSERT_TRUE(rigid.advance(water_flow, 1.0e6, particles.skeleton(), {}, 1.0e-3).converged);
  std::vector<double> wx(particles.size()), wy(particles.size());
  water_flow.darcy_velocity(particles.skeleton(), wx, wy);
  for (std::size_t p = 0; p < particles.size(); ++p) {
    EXPECT_NEAR(water_flow.pressure()[p], before[p], 1e-6);
    EXPECT_NEAR(wx[p], 0.0, 1e-18);
    EXPECT_NEAR(wy[p], 0.0, 1e-18);
  }
}

TEST_F(Column, UnitGradientFlowsWithTheConductivity) {
  PoreFlow water_flow = flow();
  Boundary drained = flux_top();
  for (Inflow& inflow : drained.inflows) inflow.rate = 1.0e-5 * spacing;
  for (int step = 0; step < 60; ++step) {
    ASSERT_TRUE(rigid.advance(water_flow, 100.0 * std::pow(1.1, step), particles.skeleton(), drained, 0.01).converged);
  }
  std::vector<double> wx(particles.size()), wy(particles.size());
  water_flow.darcy_velocity(particles.skeleton(), wx, wy);
  EXPECT_NEAR(water_flow.inflow_rate()[1], -1.0e-5 * columns * spacing, 1e-12);
  for (std::size_t p = 0; p < particles.size(); ++p) EXPECT_NEAR(wy[p], -1.0e-5, 1e-9);
}

TEST_F(Column, DrainsFreelyUnderASteadyRain) {
  const double rain = 1.0e-6;  // m/s, a tenth of the conductivity
  Boundary drained;
  drained.count = 2;
  for (std::uint32_t p = 0; p < columns; ++p) {
    drained.inflows.push_back({(rows - 1) * columns + p, 0, rain * spacing});
    drained.drains.push_back({p, 1, spacing});
  }
  PoreFlow water_flow = flow();
  const double start = water_flow.stored_water();
  for (double step = 1.0; step < 1.0e9; step *= 2.0) {
    ASSERT_TRUE(rigid.advance(water_flow, step, particles.skeleton(), drained, 1.0e-4).converged) << step;
  }
  EXPECT_NEAR(water_flow.inflow_rate()[1], -rain * columns * spacing, 1e-6 * rain);
  // k k_rw = rain everywhere: S_r^2 = 0.1
  for (const double saturation : water_flow.saturation()) EXPECT_NEAR(saturation, std::sqrt(0.1), 1e-5);
  const double gain = water_flow.stored_water() - start;
  const double inflow = water_flow.cumulative_inflow()[0] + water_flow.cumulative_inflow()[1];
  EXPECT_NEAR(gain + water_flow.unexplained_water(), inflow, 1e-12 * water_flow.cumulative_inflow()[0]);
}

TEST_F(Column, DrainsAsFastAsItConductsWhereItIsSaturated) {
  PoreFlow water_flow = flow();
  Boundary drained = face_top();  // zero pressure at the ground
  drained.count = 2;
  for (std::uint32_t p = 0; p < columns; ++p) drained.drains.push_back({p, 1, spacing});
  for (double step = 1.0; step < 1.0e9; step *= 2.0) {
    ASSERT_TRUE(rigid.advance(water_flow, step, particles.skeleton(), drained, 1.0e-3).converged) << step;
  }
  EXPECT_NEAR(water_flow.inflow_rate()[1], -1.0e-5 * columns * spacing, 1e-12);
  for (const double pressure : water_flow.pressure()) EXPECT_NEAR(pressure, 0.0, 1.0);
}

TEST_F(Column, LinearisedStepsConvergeToTheNonlinearOnes) {
  const double end = 4.0;
  const int coarse = 50;
  const auto run = [&](bool linearised, int steps) {
    PoreFlow water_flow = flow();
    const std::vector<double> strain(particles.size(), 0.0);
    for (int step = 0; step < steps; ++step) {
      if (linearised) {
        EXPECT_TRUE(
            coupled.solve(water_flow, end / steps, particles.skeleton(), strain, face_top(), RigidSkeleton{}, 1e-8)
                .converged);
        coupled.finish(water_flow, particles.skeleton());
      } else {
        EXPECT_TRUE(rigid.advance(water_flow, end / steps, particles.skeleton(), face_top(), 1e-3).converged);
      }
    }
    return std::vector<double>(water_flow.pressure().begin(), water_flow.pressure().end());
  };
  const auto difference = [](const std::vector<double>& a, const std::vector<double>& b) {
    double largest = 0.0;
    for (std::size_t p = 0; p < a.size(); ++p) largest = std::max(largest, std::abs(a[p] - b[p]));
    return largest;
  };
  const double at_coarse = difference(run(true, coarse), run(false, coarse));
  const double at_fine = difference(run(true, 4 * coarse), run(false, 4 * coarse));
  EXPECT_LT(at_fine, 0.01 * 29430.0) << "of the suction at the top";
  EXPECT_LT(at_fine, 0.4 * at_coarse) << "first order in time";
}

TEST_F(Column, LinearisedStepsBookEveryDrop) {
  PoreFlow water_flow = flow();
  Boundary boundary = held_top();
  boundary.count = 2;
  for (std::uint32_t p = 0; p < columns; ++p) boundary.drains.push_back({p, 1, spacing});
  const double start = water_flow.stored_water();
  const std::vector<double> strain(particles.size(), 0.0);
  for (int step = 0; step < 100; ++step) {
    coupled.solve(water_flow, 0.05, particles.skeleton(), strain, boundary, RigidSkeleton{}, 1e-2);
    coupled.finish(water_flow, particles.skeleton());
  }
  const double gain = water_flow.stored_water() - start;
  EXPECT_GT(water_flow.cumulative_inflow()[0], 0.0);
  EXPECT_LT(water_flow.cumulative_inflow()[1], 0.0);
  EXPECT_NEAR(gain + water_flow.unexplained_water(),
              water_flow.cumulative_inflow()[0] + water_flow.cumulative_inflow()[1], 1e-12 * start);
}

TEST_F(Column, CompressionOfTheSkeletonSqueezesWaterOut) {
  PoreFlow water_flow = flow();
  const std::vector<double> strain(particles.size(), -1.0e-6);
  coupled.solve(water_flow, 1.0e-3, particles.skeleton(), strain, {}, RigidSkeleton{}, 1e-8);
  for (const double change : coupled.pressure_change()) EXPECT_GT(change, 0.0);
  for (std::size_t p = 0; p < particles.size(); ++p) {
    EXPECT_DOUBLE_EQ(coupled.pore_stress_change()[p], water_flow.saturation()[p] * coupled.pressure_change()[p]);
  }
}

// The skeleton expands or shrinks by more than stiff water does: air must come in or go, by a slope of the retention
// curve that the start of the step knows nothing of.
TEST_F(Column, FollowsItsRetentionCurveInAndOutOfSaturation) {
  Soil soil;
  soil.relative_permeability.law = HillelPower{.exponent = 2.0};
  soil.hydraulic_conductivity = 1.0e-12;
  FlowSettings settings;
  settings.spacing = spacing;
  settings.walls = {.left = 0.0, .right = columns * spacing};
  const std::size_t n = particles.size();
  const double porosity = particles.porosity[0];
  for (const Retention& retention :
       {Retention(VanGenuchten{.alpha = 4.0, .n = 2.0, .range = {}}),
        Retention(VanGenuchten{.alpha = 0.8, .n = 1.09, .range = {}, .air_entry = 0.02}),
        Retention(ExponentialRetention{.alpha = 3.0, .range = {0.1, 1.0}}), Retention(LiakopoulosRetention{})}) {
    soil.retention = retention;
    for (const auto& [first, strain] : {std::pair(500.0, 1e-3), {500.0, 0.05}, {-200.0, 0.02}, {-8000.0, -1e-3}}) {
      PoreFlow water_flow({soil}, water, std::vector<std::uint16_t>(n, 0), std::vector<double>(n, first),
                          particles.skeleton(), settings);
      const auto report = coupled.solve(water_flow, 1.0e-3, particles.skeleton(), std::vector<double>(n, strain), {},
                                        RigidSkeleton{}, 1e-4);
      EXPECT_LT(report.iterations, 20);
      for (std::size_t p = 0; p < n; ++p) {
        const auto stored = [&](double pressure) {
          const double head = -pressure / water.unit_weight();
          const double saturation = evaluate(retention, head).saturation;
          return porosity * saturation * (1.0 + pressure / water.bulk_modulus);
        };
        const double change = stored(first + coupled.pressure_change()[p]) - stored(first);
        EXPECT_NEAR(change, -water_flow.saturation()[p] * strain, 1e-3 * std::abs(strain))
            << "law " << retention.index() << ", strain " << strain;
      }
    }
  }
}

// As the soil at a drain gets saturated within a step, its outflow is that of saturated soil at most.
TEST_F(Column, ADrainLetsOutNoMoreThanTheConductivity) {
  Soil soil;
  soil.retention = VanGenuchten{.alpha = 2.0, .n = 1.41, .range = {}};
  soil.relative_permeability.law = VanGenuchtenMualem{.n = 1.41, .range = {}};
  soil.hydraulic_conductivity = 1.0e-6;
  FlowSettings settings;
  settings.spacing = spacing;
  settings.walls = {.left = 0.0, .right = columns * spacing};
  const std::size_t n = particles.size();
  PoreFlow water_flow({soil}, water, std::vector<std::uint16_t>(n, 0), std::vector<double>(n, -10.0),
                      particles.skeleton(), settings);
  Boundary drained;
  drained.count = 1;
  for (std::uint32_t p = 0; p < columns; ++p) drained.drains.push_back({p, 0, spacing});
  coupled.solve(water_flow, 1.0, particles.skeleton(), std::vector<double>(n, -1.0e-3), drained, RigidSkeleton{}, 1e-6);
  coupled.finish(water_flow, particles.skeleton());
  EXPECT_GT(water_flow.pressure()[0], 0.0);
  EXPECT_NEAR(water_flow.inflow_rate()[0], -1.0e-6 * columns * spacing, 1e-15);
}

// A steady state in soil whose conductivity falls by half within a particle, and one beside it: without a right
// Jacobian Newton's method would not be there so soon. One state for each kind of boundary.
TEST_F(Column, FindsSteepStatesInFewIterations) {
  const double alpha = 8.0;
  Soil soil;
  soil.retention = ExponentialRetention{.alpha = alpha, .range = {0.1, 1.0}};
  soil.relative_permeability.law = ExponentialPermeability{.alpha = alpha};
  soil.hydraulic_conductivity = 1.0e-5;
  FlowSettings settings;
  settings.spacing = spacing;
  settings.walls = {.left = 0.0, .right = columns * spacing};
  const std::size_t n = particles.size();
  const auto top = [](std::uint32_t p) { return (rows - 1) * columns + p; };
  const double half = 0.5 * spacing;
  std::map<std::string, Boundary> boundaries;
  for (std::uint32_t p = 0; p < columns; ++p) {
    boundaries["faces"].faces.push_back({top(p), 0, -8000.0, half, half, spacing});
    boundaries["faces"].faces.push_back({p, 0, -500.0, -half, half, spacing});
    boundaries["held"].held.push_back({top(p), 0, -8000.0});
    boundaries["held"].held.push_back({p, 0, -500.0});
    boundaries["drain"].inflows.push_back({top(p), 0, 1.0e-6 * spacing});
    boundaries["drain"].drains.push_back({p, 0, spacing});
    boundaries["ponding"].open_faces.push_back({top(p), 0, 2.0e-5 * spacing, 0.0, -1e5, half, half, spacing});
    boundaries["ponding"].drains.push_back({p, 0, spacing});
    boundaries["drying"].open_faces.push_back({top(p), 0, -1.0e-6 * spacing, 0.0, -8000.0, half, half, spacing});
    boundaries["drying"].faces.push_back({p, 0, -500.0, -half, half, spacing});
  }
  for (auto& [name, boundary] : boundaries) {
    boundary.count = 1;
    PoreFlow water_flow({soil}, water, std::vector<std::uint16_t>(n, 0), std::vector<double>(n, -4000.0),
                        particles.skeleton(), settings);
    double step = 1.0;
    for (int k = 0; k < 100 && step < 1.0e8; ++k) {
      step *= rigid.advance(water_flow, step, particles.skeleton(), boundary, 1.0e-2).converged ? 4.0 : 0.25;
    }
    ASSERT_GE(step, 1.0e8) << name;
    for (FacePressure& face : boundary.faces) face.pressure += 50.0;
    for (HeldPressure& held : boundary.held) held.pressure += 50.0;
    for (Inflow& inflow : boundary.inflows) inflow.rate *= 1.02;
    for (OpenFace& face : boundary.open_faces) face.ponding_pressure += 50.0;
    const SolveReport report = rigid.advance(water_flow, 1.0e8, particles.skeleton(), boundary, 1.0e-6);
    EXPECT_TRUE(report.converged) << name;
    EXPECT_LE(report.iterations, 7) << name;
  }
}

TEST_F(Column, AStepThatFailsChangesNothing) {
  PoreFlow water_flow = flow();
  const auto before = std::vector<double>(water_flow.pressure().begin(), water_flow.pressure().end());
  EXPECT_FALSE(rigid.advance(water_flow, 1.0e3, particles.skeleton(), face_top(), 1e-9, 1).converged);
  for (std::size_t p = 0; p < particles.size(); ++p) {
    EXPECT_EQ(water_flow.pressure()[p], before[p]);
  }
  EXPECT_TRUE(rigid.pressure_change().empty());
  EXPECT_EQ(water_flow.unexplained_water(), 0.0);
}

// As many particles as threads share the products of conjugate gradients of.
TEST_F(Column, DoesNotDependOnTheThreads) {
  particles = lattice(150, 120, spacing, 0.1);
  const std::vector<double> strain(particles.size(), 1.0e-7);
  const auto pressure = [&](int threads) {
    PoreFlow water_flow = flow(threads);
    for (int step = 0; step < 3; ++step) {
      coupled.solve(water_flow, 0.1, particles.skeleton(), strain, face_top(), RigidSkeleton{}, 1e-4);
      coupled.finish(water_flow, particles.skeleton());
    }
    return std::vector<double>(water_flow.pressure().begin(), water_flow.pressure().end());
  };
  const std::vector<double> one = pressure(1);
  EXPECT_EQ(pressure(2), one);
  EXPECT_EQ(pressure(3), one);
}

TEST_F(Column, ReportsWhatIsNotANumber) {
  PoreFlow water_flow = flow();
  Boundary bad = flux_top();
  bad.inflows[0].rate = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> strain(particles.size(), 0.0);
  EXPECT_FALSE(coupled.solve(water_flow, 0.1, particles.skeleton(), strain, bad, RigidSkeleton{}, 1e-4).converged);
  try {
    coupled.finish(water_flow, particles.skeleton());
    FAIL() << "not noticed";
  } catch (const SeepageError& error) {
    EXPECT_EQ(error.particle, bad.inflows[0].particle);
    EXPECT_NE(std::string(error.what()).find("water balance (m2) is"), std::string::npos);
  }
}

}  // namespace
}  // namespace slope::seepage
